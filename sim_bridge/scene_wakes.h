#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "sim_bridge/scene/scene.h"
#include "sim_bridge/scene/sea.h"
#include "sim_bridge/vessel/vessel.h"
#include "surface/disturbance/wake_listener.h"
#include "surface/disturbance/wake_system.h"
#include "surface/effects.h"

namespace seaway::bridge {

/// Who feels or sees a scene's wakes beside its vessels.
struct Audience {
  std::vector<SceneCamera> cameras;
  std::vector<WakeListener> places;
};

/// The wakes of a scene's vessels, and the water that they disturb.
///
/// Vessels under way leave waves; all have sailed before the scene's epoch too, on their courses
/// or, if free, straight on to their start, so that their waves are whole from the start. A free
/// vessel counts as under way where its scene gives it a speed or the sea a current. A scene in
/// which nobody is under way, or nobody else is there to feel or see it, holds nothing. A copy is a
/// snapshot: it shares what it can until one of the two moves on.
class SceneWakes {
 public:
  /// `scene` and `sea` must outlive this object and its copies.
  SceneWakes(const Scene& scene, const Sea& sea);

  /// Waves and wakes, as they were at the last `advance`.
  const WaterSurface& surface() const;

  /// Handle of vessel `index` for SampleOptions::excludeVessel: 0 where it feels all waves.
  std::uint32_t ownHandle(std::size_t index) const;

  /// Other waves from now on, of a sea that is else the same and outlives this object.
  void setSea(const Sea& sea);

  void setAudience(Audience audience) { audience_ = std::move(audience); }

  /// Notes where the vessels are at `t` and brings the wakes there.
  void advance(double t, std::span<const Vessel> vessels, EffectLedger* ledger);

  /// How long vessels feel what another has done, s; 0 where none makes waves for another.
  double memory() const;

  /// Writes or reads the state: see surface/state_archive.h.
  template <class Archive>
  void archive(Archive& archive);

 private:
  struct Running;
  const char* idleReason(std::span<const Vessel> vessels) const;
  void enter(std::size_t index, double t, const Vessel& vessel);
  void start(double t, std::span<const Vessel> vessels);
  void record(double t, std::span<const Vessel> vessels);
  std::vector<WakeListener> listeners(double t, std::span<const Vessel> vessels) const;

  const Scene* scene_;
  const Sea* sea_;
  Audience audience_;
  std::shared_ptr<Running> running_;  // written to by its only owner
};

/// A camera sees wakes whose windows begin within this distance, m: the waves of a launch, 20 m
/// long, are as wide as a pixel or two of a frame there.
constexpr double cameraReach = 2000.0;

/// How a scene's wakes run.
WakeSystemSettings wakeSettings(const Scene& scene, const Sea& sea);
/// The windows of a hull's waves.
std::vector<WakeLevel> wakeCascade(const Scene& scene, const BoxHull& hull);
/// What the wakes note of a vessel at `t`, as deep in the water as it is now.
WakePose wakePoseOf(double t, const SceneVessel& description, const Vessel& vessel);
/// Whether a vessel of the scene moves through the water on its course and leaves waves there.
bool makesWaves(const SceneVessel& vessel, const Sea& sea);

/// Whether a vessel under way at `t` is so near to one of `places` that they may feel its waves. A
/// free one may be anywhere within twice its speed, 3 m/s and the current of its start, and its
/// trail counts as its waves do.
bool wakesReach(const Scene& scene, const Sea& sea, double t, std::span<const WakeListener> places);

}  // namespace seaway::bridge
