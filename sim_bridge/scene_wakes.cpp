#include "sim_bridge/scene_wakes.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "sim_bridge/scene/vessel_course.h"
#include "sim_bridge/scene/vessel_launch.h"
#include "sim_bridge/vessel/wake_footprint.h"
#include "surface/constants.h"
#include "surface/input_error.h"
#include "surface/state_archive.h"

namespace seaway::bridge {
namespace {

/// A hull presses in full until it carries less than half its weight: leaps and heave in a seaway
/// alike.
constexpr double lightestInFull = 0.5;

EffectSetting settingOf(const Scene& scene) {
  return scene.effects[static_cast<std::size_t>(Effect::wake)];
}

}  // namespace

WakePose wakePoseOf(double t, const SceneVessel& description, const Vessel& vessel) {
  const CoursePoint place = vessel.placeAt(t);
  const double carried = vessel.submergedVolume() * seaWaterDensity / vessel.mass();
  return {t, place.position, place.direction,
          description.model.wake.strength * std::clamp(carried / lightestInFull, 0.0, 1.0)};
}

bool makesWaves(const SceneVessel& vessel, const Sea& sea) {
  const bool moves = vessel.speed != 0.0 || vessel.turn_deg != 0.0 ||
                     sea.surface.waves().settings().current != glm::dvec2(0.0);
  return moves && vessel.model.wake.strength > 0.0;
}

std::vector<WakeLevel> wakeCascade(const Scene& scene, const BoxHull& hull) {
  const WakeAccuracy& accuracy = scene.accuracy.wakes;
  return cascadeOf(std::max(hull.length, hull.beam), scene.sea.depth, accuracy.cell,
                   accuracy.window);
}

WakeSystemSettings wakeSettings(const Scene& scene, const Sea& sea) {
  WakeSystemSettings settings;
  settings.depth = scene.sea.depth;
  settings.current = sea.surface.waves().settings().current;
  settings.mostWakes = static_cast<std::size_t>(scene.accuracy.wakes.most);
  settings.cell = scene.accuracy.wakes.cell;
  settings.window = scene.accuracy.wakes.window;
  return settings;
}

namespace {

/// The same of a vessel as it is: a host may move one that the scene has at rest.
bool makesWavesNow(const SceneVessel& description, const Vessel& vessel, const Sea& sea) {
  return makesWaves(description, sea) || (vessel.hosted() && description.model.wake.strength > 0.0);
}

}  // namespace

struct SceneWakes::Running {
  WakeSystem system;
  WaterSurface surface;
  std::vector<std::uint32_t> handles;  // by vessel; 0: makes no waves

  Running(const WakeSystemSettings& settings, const WaterSurface& water)
      : system(settings), surface(water) {
    surface.setDisturbances(system.feed());
  }
  Running(const Running& other)
      : system(other.system), surface(other.surface), handles(other.handles) {
    surface.setDisturbances(system.feed());
  }
};

SceneWakes::SceneWakes(const Scene& scene, const Sea& sea) : scene_(&scene), sea_(&sea) {}

void SceneWakes::setSea(const Sea& sea) {
  sea_ = &sea;
  if (!running_) return;
  if (running_.use_count() > 1) running_ = std::make_shared<Running>(*running_);
  running_->surface = sea.surface;
  running_->surface.setDisturbances(running_->system.feed());
}

const WaterSurface& SceneWakes::surface() const {
  return running_ ? running_->surface : sea_->surface;
}

std::uint32_t SceneWakes::ownHandle(std::size_t index) const {
  if (!running_ || scene_->vessels[index].model.wake.feltByItself) return 0;
  return running_->handles[index];
}

double SceneWakes::memory() const {
  double longest = 0.0;
  if (settingOf(*scene_) == EffectSetting::off || scene_->vessels.size() < 2) return longest;
  for (const SceneVessel& vessel : scene_->vessels) {
    if (!makesWaves(vessel, *sea_)) continue;
    for (const WakeLevel& level : wakeCascade(*scene_, vessel.model.hull)) {
      longest = std::max(longest, memoryOf(level));
    }
  }
  return longest;
}

const char* SceneWakes::idleReason(std::span<const Vessel> vessels) const {
  const auto& descriptions = scene_->vessels;
  bool any = false;
  for (std::size_t i = 0; i < vessels.size(); ++i) {
    any = any || makesWavesNow(descriptions[i], vessels[i], *sea_);
  }
  if (!any) return "no vessel is under way";
  const bool alone = descriptions.size() == 1 && !descriptions[0].model.wake.feltByItself &&
                     audience_.cameras.empty() && audience_.places.empty();
  if (alone && settingOf(*scene_) != EffectSetting::on) return "nobody else is there";
  return nullptr;
}

void SceneWakes::start(double t, std::span<const Vessel> vessels) {
  running_ = std::make_shared<Running>(wakeSettings(*scene_, *sea_), sea_->surface);
  for (std::size_t i = 0; i < vessels.size(); ++i) {
    running_->handles.push_back(0);
    if (makesWavesNow(scene_->vessels[i], vessels[i], *sea_)) enter(i, t, vessels[i]);
  }
}

void SceneWakes::enter(std::size_t index, double t, const Vessel& vessel) {
  const SceneVessel& description = scene_->vessels[index];
  const std::uint32_t handle = running_->system.addVessel(wakeFootprint(description.model));
  running_->handles[index] = handle;
  // On the steps' own times, so that the log does not depend on when it begins.
  const double step = wakeCascade(*scene_, description.model.hull).front().step;
  const double first = std::floor((t - running_->system.memory(handle)) / step) - 1.0;
  for (double n = first; n * step < t - 1e-3 * step; n += 1.0) {
    running_->system.record(handle, wakePoseOf(n * step, description, vessel));
  }
}

void SceneWakes::record(double t, std::span<const Vessel> vessels) {
  for (std::size_t i = 0; i < vessels.size(); ++i) {
    if (running_->handles[i] == 0) {
      if (!makesWavesNow(scene_->vessels[i], vessels[i], *sea_)) continue;
      enter(i, t, vessels[i]);  // a host sails it since a while
    }
    running_->system.record(running_->handles[i], wakePoseOf(t, scene_->vessels[i], vessels[i]));
  }
}

std::vector<WakeListener> SceneWakes::listeners(double t, std::span<const Vessel> vessels) const {
  std::vector<WakeListener> all = audience_.places;
  for (std::size_t i = 0; i < vessels.size(); ++i) {
    const glm::dvec2 place = vessels[i].placeAt(t).position;
    const double radius = 0.5 * scene_->vessels[i].model.hull.length;
    all.push_back({place, radius, ownHandle(i)});
    if (settingOf(*scene_) == EffectSetting::on) all.push_back({place, radius, 0});
  }
  for (const SceneCamera& camera : audience_.cameras) {
    if (camera.place) {
      const CameraPlace& place = *camera.place;
      all.push_back(
          {sea_->geodesy.seaPlaneFromGeodetic(place.latitude_deg, place.longitude_deg).position,
           cameraReach, 0});
      continue;
    }
    for (std::size_t i = 0; i < vessels.size(); ++i) {
      if (scene_->vessels[i].name != camera.mount) continue;
      all.push_back({vessels[i].placeAt(t).position, cameraReach, 0});
    }
  }
  return all;
}

void SceneWakes::advance(double t, std::span<const Vessel> vessels, EffectLedger* ledger) {
  if (settingOf(*scene_) == EffectSetting::off) return;
  if (const char* reason = idleReason(vessels)) {
    if (ledger) ledger->decide(Effect::wake, false, reason);
    running_ = nullptr;
    return;
  }
  if (!running_) {
    start(t, vessels);
  } else if (running_.use_count() > 1) {
    running_ = std::make_shared<Running>(*running_);
  }
  record(t, vessels);
  running_->system.advance(t, listeners(t, vessels), ledger);
}

bool wakesReach(const Scene& scene, const Sea& sea, double t,
                std::span<const WakeListener> places) {
  if (t < 0.0) return false;
  const bool wakes = settingOf(scene) != EffectSetting::off;
  const bool trails = scene.effects[static_cast<std::size_t>(Effect::trail)] != EffectSetting::off;
  for (const SceneVessel& vessel : scene.vessels) {
    const bool free = sailsFreely(scene, vessel);
    const bool makesWakes = wakes && makesWaves(vessel, sea);
    if (!makesWakes && !(free && trails)) continue;
    const glm::dvec2 at = courseOf(vessel, sea.geodesy).at(free ? 0.0 : t).position;
    double reach = reachOf(wakeCascade(scene, vessel.model.hull));
    if (free) {
      const glm::dvec2 current = sea.surface.waves().settings().current;
      reach += t * (2.0 * std::abs(vessel.speed) + 3.0 + glm::length(current));
    }
    for (const WakeListener& place : places) {
      const glm::dvec2 apart = glm::abs(place.position - at) - place.radius;
      if (std::max(apart.x, apart.y) < reach) return true;
    }
  }
  return false;
}

template <class Archive>
void SceneWakes::archive(Archive& archive) {
  bool runs = running_ != nullptr;
  archivePlain(archive, runs);
  if (!runs) {
    running_ = nullptr;
    return;
  }
  if constexpr (isReader<Archive>) {
    running_ = std::make_shared<Running>(wakeSettings(*scene_, *sea_), sea_->surface);
  }
  archiveRow(archive, running_->handles);
  if constexpr (isReader<Archive>) {
    if (running_->handles.size() != scene_->vessels.size()) {
      throw InputError("a checkpoint is of a scene with other vessels");
    }
    // In the order in which they once entered.
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < running_->handles.size(); ++i) {
      if (running_->handles[i] != 0) order.push_back(i);
    }
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return running_->handles[a] < running_->handles[b];
    });
    for (const std::size_t i : order) {
      running_->system.addVessel(running_->handles[i], wakeFootprint(scene_->vessels[i].model));
    }
  }
  running_->system.archive(archive);
}

template void SceneWakes::archive(StateWriter&);
template void SceneWakes::archive(StateReader&);

}  // namespace seaway::bridge
