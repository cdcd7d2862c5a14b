#include "tests/sim_bridge/effects/effect_trial.h"

#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/selftest/yaml_json.h"

namespace seaway::bridge::test {

EffectTrial::EffectTrial(const Json& scene)
    : scene_(std::make_unique<Scene>(sceneFromText(yamlFromJson(scene), "/"))),
      sea_(std::make_unique<Sea>(buildSea(*scene_))),
      simulation_(std::make_unique<Simulation>(*scene_, *sea_)),
      view_(std::make_unique<SceneView>(*scene_)) {
  simulation_->attend({.cameras = scene_->cameras, .places = {}});
  simulation_->stepTo(1.0);
  for (int i = 0; i < 64; ++i) points_.emplace_back(0.5 * i - 16.0, 0.25 * i - 10.0);
  samples_.resize(points_.size());
}

void EffectTrial::sample() {
  simulation_->surface().sample(points_, simulation_->time(), samples_);
}

void EffectTrial::draw(render::RenderTechnique& technique, EffectLedger& ledger) {
  technique.drawInto(view_->view(*simulation_, scene_->cameras[0], scene_->run.size, ledger),
                     frame_);
}

std::vector<VesselPose> EffectTrial::poses() const {
  std::vector<VesselPose> poses;
  for (const Vessel& vessel : simulation_->vessels()) poses.push_back(vessel.pose());
  return poses;
}

}  // namespace seaway::bridge::test
