#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "render/render_technique.h"
#include "sim_bridge/scene_view.h"
#include "sim_bridge/simulation.h"
#include "tests/sim_bridge/effects/effect_proofs.h"

namespace seaway::bridge::test {

/// A scene at 1 s, ready for one more step, a batch of samples and a picture.
class EffectTrial {
 public:
  explicit EffectTrial(const Json& scene);

  void step(EffectLedger& ledger) { simulation_->step(&ledger); }
  void sample();
  void draw(render::RenderTechnique& technique, EffectLedger& ledger);

  const Scene& scene() const { return *scene_; }
  const std::vector<SurfaceSample>& samples() const { return samples_; }
  const render::Frame& frame() const { return frame_; }
  std::vector<VesselPose> poses() const;

 private:
  // At places of their own: parts refer to each other.
  std::unique_ptr<Scene> scene_;
  std::unique_ptr<Sea> sea_;
  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<SceneView> view_;
  std::vector<glm::dvec2> points_;
  std::vector<SurfaceSample> samples_;
  render::Frame frame_;
};

}  // namespace seaway::bridge::test
