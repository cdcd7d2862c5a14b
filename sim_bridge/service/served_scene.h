#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "sim_bridge/scene/scene.h"
#include "sim_bridge/scene/sea.h"
#include "sim_bridge/scene_detail.h"
#include "sim_bridge/vessel/course.h"

namespace seaway::bridge {

/// What a vessel of a served scene does where no host sails it, and how its waves run.
struct ServedVessel {
  Course course;              ///< of a free one: until the epoch
  bool free = false;          ///< sails freely (FreeSailing) from the epoch on
  bool makesWaves = false;    ///< on its course
  bool canMakeWaves = false;  ///< when a host moves it
  double reach = 0.0;         ///< of its wakes' windows along both axes, m
  double step = 0.1;          ///< of the finest window, s
};

/// A scene with its sea, as they were loaded. Immutable. Throws InputError for a layer's file that
/// cannot be read and for a free vessel that cannot float.
struct ServedScene {
  ServedScene(const Scene& loaded, Sea built);
  ServedScene(const ServedScene&) = delete;

  Scene scene;
  Sea sea;
  bool wakesAllowed;                  ///< the scene does not switch wakes off
  bool trailsAllowed;                 ///< nor trails
  std::vector<ServedVessel> vessels;  ///< one each of the scene's
  bool anyFree = false;
  const SceneDetail detail;  ///< before anything has happened: to be copied

  /// Handle of the wake of the scene's own vessel `index`; hosts' hulls have theirs below.
  static constexpr std::uint32_t handleOf(std::size_t index) {
    return 0x8000'0000u + static_cast<std::uint32_t>(index);
  }
};

/// The same water with other waves.
WaterSurface withWaves(const WaterSurface& water, const WaveField& waves);

}  // namespace seaway::bridge
