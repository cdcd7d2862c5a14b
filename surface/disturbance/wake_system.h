#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "surface/disturbance/disturbance_state.h"
#include "surface/disturbance/pose_log.h"
#include "surface/disturbance/published.h"
#include "surface/disturbance/vessel_wake.h"
#include "surface/disturbance/wake_listener.h"
#include "surface/effects.h"

namespace seaway {

struct WakeSystemSettings {
  double depth = std::numeric_limits<double>::infinity();  ///< m
  glm::dvec2 current{0.0};                                 ///< m/s (east, north)
  std::size_t mostWakes = 8;    ///< that run at once, those nearest to a listener: some 20 MB and
                                ///< 3 ms a step of 0.1 s each
  bool orbitalVelocity = true;  ///< keep the potential too: a third of the cost
  double cell = 0.0, window = 0.0;  ///< of `cascadeOf` for each hull, m; 0: the standard
  /// The windows of every vessel; empty: cascadeOf for each hull. Each level's step is a multiple
  /// of the first's.
  std::vector<WakeLevel> cascade;
};

/// The wakes of a scene: every vessel's past, and waves where somebody is near to feel or see them.
///
/// One writer: vessels' poses as they sail, then `advance`. Readers take `latest` from any thread
/// and never wait. A wake runs while a listener is within reach of a vessel that is or was under
/// way; it is rebuilt from the vessel's poses when one arrives (within 1 % of the wake's height of
/// one that ran all along) and dropped five seconds after the last has left, or when its waves
/// have. Without any, `latest` is null and nothing is held but the poses. The same calls give the
/// same bits (tests/surface/disturbance/wake_system_test.cpp).
class WakeSystem {
 public:
  /// Throws InputError for windows that cannot be.
  explicit WakeSystem(const WakeSystemSettings& settings = {});
  ~WakeSystem();
  /// A system in the same state, with a feed of its own.
  WakeSystem(const WakeSystem& other);
  WakeSystem& operator=(const WakeSystem&) = delete;

  /// A vessel's handle, above 0.
  std::uint32_t addVessel(const HullFootprint& hull);
  /// The same with a handle of the caller's choice, above 0, that no vessel has. Throws InputError.
  void addVessel(std::uint32_t handle, const HullFootprint& hull);
  /// Its waves stay until they are gone. Unknown handles are ignored.
  void removeVessel(std::uint32_t vessel);
  /// The vessel and its waves are gone from the next `advance` on, as if it had never been.
  void dropVessel(std::uint32_t vessel);

  /// Notes where a vessel is; its first pose, and a move faster than 100 m/s, put it there without
  /// a wake. A pose that is refused changes nothing. Throws InputError for an unknown vessel.
  PoseAnswer record(std::uint32_t vessel, const WakePose& pose);

  /// Brings the wakes that listeners call for up to time `t` and publishes the state, which is
  /// valid from the step before `t` to the step after, as far as poses were noted. Charges
  /// `ledger`.
  void advance(double t, std::span<const WakeListener> listeners, EffectLedger* ledger = nullptr);

  /// The state of the last `advance`; null where nothing is disturbed. Lock-free, any thread.
  std::shared_ptr<const DisturbanceState> latest() const noexcept { return published_->latest(); }
  /// What WaterSurface::setDisturbances takes.
  std::shared_ptr<const Published<DisturbanceState>> feed() const { return published_; }

  /// How far back the poses of a vessel bear on its waves, s.
  double memory(std::uint32_t vessel) const;

  std::size_t running() const;  ///< wakes that hold windows
  std::size_t memoryBytes() const;

  /// Writes or reads the state (surface/state_archive.h); it is read into a system that has the
  /// same vessels, and published.
  template <class Archive>
  void archive(Archive& archive);

 private:
  struct Vessel;
  Vessel& vesselOf(std::uint32_t handle) const;
  struct Call {
    Vessel* vessel;
    double distance;  // from the nearest listener's surroundings, m
  };
  std::vector<Call> calls(double t, std::span<const WakeListener> listeners);
  void open(Vessel& vessel);
  bool advance(Vessel& vessel, double t);
  void publish();
  std::shared_ptr<const WakeTables> tablesFor(const WakeLevel& level);

  WakeSystemSettings settings_;
  std::vector<std::unique_ptr<Vessel>> vessels_;
  std::vector<std::shared_ptr<const WakeTables>> tables_;
  std::shared_ptr<Published<DisturbanceState>> published_ =
      std::make_shared<Published<DisturbanceState>>();
  std::uint32_t nextHandle_ = 1;
  bool dropped_ = false;  // waves that were published last
};

}  // namespace seaway
