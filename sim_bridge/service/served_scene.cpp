#include "sim_bridge/service/served_scene.h"

#include <utility>

#include "sim_bridge/scene/vessel_course.h"
#include "sim_bridge/scene_wakes.h"

namespace seaway::bridge {

ServedScene::ServedScene(const Scene& loaded, Sea built)
    : scene(loaded),
      sea(std::move(built)),
      wakesAllowed(scene.effects[static_cast<std::size_t>(Effect::wake)] != EffectSetting::off),
      detail(scene, sea) {
  for (const SceneVessel& vessel : scene.vessels) {
    const auto cascade = wakeCascade(scene, vessel.model.hull);
    vessels.push_back({.course = courseOf(vessel, sea.geodesy),
                       .makesWaves = wakesAllowed && seaway::bridge::makesWaves(vessel, sea),
                       .canMakeWaves = wakesAllowed && vessel.model.wake.strength > 0.0,
                       .reach = reachOf(cascade),
                       .step = cascade.front().step});
  }
}

}  // namespace seaway::bridge
