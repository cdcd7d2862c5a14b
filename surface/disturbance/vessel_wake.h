#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "surface/disturbance/disturbance_state.h"
#include "surface/disturbance/grid_pool.h"
#include "surface/disturbance/pose_log.h"
#include "surface/disturbance/wake_window.h"

namespace seaway {

/// One window of a cascade and how long its steps are, s.
struct WakeLevel {
  WakeWindowSettings window;
  double step = 0.1;
  bool operator==(const WakeLevel&) const = default;
};

/// Two windows for hulls up to 64 m long: waves of 2 to 32 m on 256 m around the vessel in cells of
/// 0.5 m, the longer ones on 1024 m in cells of 4 m. For longer hulls all lengths double, as often
/// as needed. Wakes err by some 0.5 % of their height against one large fine window
/// (tests/surface/disturbance/wake_window_test.cpp).
std::vector<WakeLevel> standardCascade(double hullLength, double depth);

/// The same with cells of `cell` m near the hull, which carry waves from four cells up, and waves
/// out to a square of `window` m, each 0 for the standard. Windows have 2ⁿ cells a side, so that
/// `window` is rounded up; one of up to 512 cells near the hull serves alone where that covers it.
std::vector<WakeLevel> cascadeOf(double hullLength, double depth, double cell, double window);

/// Seconds that waves of a level need to leave its window when their vessel lies still; what is
/// older is forgotten.
double memoryOf(const WakeLevel& level);

/// A wake runs while somebody is within this distance of its vessel along both axes, m.
double reachOf(const std::vector<WakeLevel>& cascade);

/// The waves of one vessel: a window of one level, stepped on a time grid fixed in the world
/// (multiples of the level's step) from the vessel's pose log. Step n → n + 1 depends on poses up
/// to n steps alone, so that the same log gives the same bits however often it is looked at.
class LevelWake {
 public:
  LevelWake(const WakeLevel& level, std::shared_ptr<const WakeTables> tables,
            std::shared_ptr<const FootprintTable> hull, bool withPotential);

  /// Steps until the surface at `time` lies between the last two steps; rebuilt from the log where
  /// the window is not running, or has passed `time`. True if anything changed. The log has a pose
  /// at or before `time`.
  bool advance(const PoseLog& log, double time);

  WakeSheet sheet() const;

  /// ∫∫ η² of the waves after the last step, m⁴, without the hollow under a hull at rest.
  double waveEnergy(const PoseLog& log);
  double meanWaveNumber() const { return meanWaveNumber_; }
  double time() const { return static_cast<double>(steps_) * level_.step; }
  std::size_t memoryBytes() const;

  /// Writes or reads the state: see surface/state_archive.h.
  template <class Archive>
  void archive(Archive& archive);

 private:
  double size() const { return level_.window.size(); }
  void start(const PoseLog& log, double time);
  void settle(const PoseLog& log);
  void step(const PoseLog& log);
  void follow();
  void draw();

  WakeLevel level_;
  WakeWindow window_;
  GridPool pool_;
  bool running_ = false;
  long long steps_ = 0;     // the state's time in steps
  glm::dvec2 astern_{0.0};  // from the vessel to the window's centre, m
  glm::dvec2 centre_{0.0};
  HullPlace place_;           // after the last step
  glm::dvec2 velocity_{0.0};  // m/s
  double meanWaveNumber_ = 0.0;
  std::shared_ptr<const WakeGrid> before_, after_;
};

}  // namespace seaway
