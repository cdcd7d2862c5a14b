#pragma once

#include <chrono>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "sim_bridge/service/frame_maker.h"
#include "sim_bridge/service/sea_state_reading.h"
#include "sim_bridge/service/serve_clock.h"
#include "sim_bridge/service/served_sea.h"
#include "surface/effects.h"

namespace seaway::bridge {

/// What an endpoint did lately.
struct EndpointLoad {
  std::string name;
  MeterCounts total;
  double requestsPerSecond = 0.0;
  double pointsPerSecond = 0.0;
  double framesPerSecond = 0.0;
  double median = 0.0;        ///< s, of a request; of all there ever were where none came lately
  double percentile99 = 0.0;  ///< s
};

/// A served vessel by where it is.
struct VesselFigures {
  std::string name;
  bool hosted = false, free = false;
  bool outOfTime = false;  ///< a free one that is not where it is now, as ServedHull
  double latitude_deg = 0.0, longitude_deg = 0.0, heading_deg = 0.0, height = 0.0;
};

/// The state of a service at a moment: what its metrics and its page tell.
struct ServiceFigures {
  std::string version, scene, clock;
  double uptime = 0.0;  ///< s
  double time = 0.0;    ///< s since the scene's epoch: the clock's, or what was asked for last
  double realTimeFactor = 0.0;  ///< how fast that time has gone lately
  SeaStateFigures asked, realised;
  std::vector<EndpointLoad> endpoints;
  std::vector<Meters::Event> events;
  std::vector<EffectReport> effects;  ///< of the picture drawn last; wakes as they run
  ServedSea::WakeFigures wakes;
  std::optional<std::pair<double, double>> wakeSpan;
  std::vector<VesselFigures> vessels;
  std::vector<std::string> cameras;
  std::vector<std::string> descriptions;  ///< of endpoints
  std::uint64_t warnings = 0, errors = 0;
};

/// Reads a service's figures. Thread-safe. `note` is to be called once a second or so: rates are of
/// the last ten seconds.
class ServiceStatus {
 public:
  /// All must outlive it. `descriptions` tells what the endpoints say they are.
  ServiceStatus(ServedSea& sea, FrameMaker& frames, const ServeClock& clock,
                std::function<std::vector<std::string>()> descriptions);

  void note();
  ServiceFigures read();
  /// The clock's time, or what was asked for last, s.
  double time() const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Moment {
    Clock::time_point when;
    double time = 0.0;
    std::map<std::string, MeterCounts> counts;
  };
  Moment now() const;
  std::vector<EffectReport> effects() const;

  ServedSea& sea_;
  FrameMaker& frames_;
  ServeClock clock_;
  std::function<std::vector<std::string>()> descriptions_;
  const Clock::time_point begun_ = Clock::now();
  SeaStateReading reading_;
  mutable std::mutex mutex_;
  std::deque<Moment> past_;
};

}  // namespace seaway::bridge
