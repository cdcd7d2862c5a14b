#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "sim_bridge/scene/scene.h"
#include "sim_bridge/scene/sea.h"
#include "surface/disturbance/published.h"
#include "surface/disturbance/wake_system.h"
#include "surface/water_surface.h"

namespace seaway::bridge {

/// The one sea that all endpoints of a service ask and change. Thread-safe: readers take the
/// surface without waiting, writers wait for each other.
///
/// Hulls that hosts sail leave wakes as WakeSystem has them, where the scene's effects do not
/// switch wakes off: while somebody asks near them.
class ServedSea {
 public:
  /// `scene` must outlive the sea.
  ServedSea(const Scene& scene, Sea sea);

  const Scene& scene() const { return *scene_; }
  const Geodesy& geodesy() const { return sea_.geodesy; }

  /// The surface as it is now, wakes included; never null.
  std::shared_ptr<const WaterSurface> surface() const noexcept { return surface_.latest(); }

  /// Other waves from now on. Throws InputError for octaves that are no field; the sea is then as
  /// before.
  void setOctaves(std::vector<Octave> octaves);
  /// The scene's own waves again.
  void restoreOctaves();

  /// A hull of the scene's vessel `index` that a host sails; 0 where there is no such vessel or
  /// wakes are switched off.
  std::uint32_t addHull(std::size_t index);
  void removeHull(std::uint32_t hull);
  void record(std::uint32_t hull, const WakePose& pose);

  /// Brings the wakes to `t` for those who ask. Nothing where there is no hull.
  void advanceWakes(double t, std::span<const WakeListener> listeners);

 private:
  void publish(WaterSurface surface);

  const Scene* scene_;
  Sea sea_;
  std::mutex writing_;
  std::unique_ptr<WakeSystem> wakes_;  // from the first hull on
  std::size_t hulls_ = 0;
  Published<WaterSurface> surface_;
};

}  // namespace seaway::bridge
