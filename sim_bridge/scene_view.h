#pragma once

#include <string>
#include <vector>

#include "render/render_technique.h"
#include "sim_bridge/simulation.h"

namespace seaway::bridge {

/// What pictures of a scene need beside the simulation: the vessels' meshes, made once.
class SceneView {
 public:
  /// `scene` must outlive this object.
  explicit SceneView(const Scene& scene);

  /// The view of one camera at the simulation's time. Refers to the simulation's water, to `ledger`
  /// and to this object: valid until the next call or until one of them goes.
  render::View view(const Simulation& simulation, const SceneCamera& camera, glm::ivec2 size,
                    EffectLedger& ledger);

 private:
  const Scene* scene_;
  std::vector<render::Mesh> meshes_;
  std::vector<render::SceneObject> objects_;
};

/// Simulation::replayed with a progress bar.
Simulation replayWithProgress(const Scene& scene, const Sea& sea, double t);

/// The scene's camera of that name; the first for an empty name. Throws InputError where there is
/// none, with the nearest name there is.
const SceneCamera& findCamera(const Scene& scene, const std::string& name);

}  // namespace seaway::bridge
