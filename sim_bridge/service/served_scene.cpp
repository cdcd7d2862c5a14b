#include "sim_bridge/service/served_scene.h"

#include <utility>

#include "sim_bridge/scene/vessel_course.h"
#include "sim_bridge/scene/vessel_launch.h"
#include "sim_bridge/scene_wakes.h"
#include "sim_bridge/simulation.h"

namespace seaway::bridge {

ServedScene::ServedScene(const Scene& loaded, Sea built)
    : scene(loaded),
      sea(std::move(built)),
      wakesAllowed(scene.effects[static_cast<std::size_t>(Effect::wake)] != EffectSetting::off),
      trailsAllowed(scene.effects[static_cast<std::size_t>(Effect::trail)] != EffectSetting::off),
      detail(scene, sea) {
  for (const SceneVessel& vessel : scene.vessels) {
    const auto cascade = wakeCascade(scene, vessel.model.hull);
    vessels.push_back({.course = courseOf(vessel, sea.geodesy),
                       .free = sailsFreely(scene, vessel),
                       .makesWaves = wakesAllowed && seaway::bridge::makesWaves(vessel, sea),
                       .canMakeWaves = wakesAllowed && vessel.model.wake.strength > 0.0,
                       .reach = reachOf(cascade),
                       .step = cascade.front().step});
    anyFree = anyFree || vessels.back().free;
  }
  if (anyFree) Simulation(scene, this->sea);  // tells now what would not float
}

WaterSurface withWaves(const WaterSurface& water, const WaveField& waves) {
  WaterSurface other(waves);
  other.setOutline(water.sharedOutline());
  other.setTerrain(water.sharedTerrain());
  other.setEvents(water.extras().events);
  other.setDetail(water.extras().detail);
  return other;
}

}  // namespace seaway::bridge
