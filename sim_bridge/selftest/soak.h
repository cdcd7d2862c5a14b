#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sim_bridge/commands/run_output.h"
#include "sim_bridge/scene/scene.h"

namespace seaway::bridge {

/// What a long run holds and takes, read at one of its times.
struct SoakReading {
  double time = 0.0;              ///< s since the scene's epoch
  std::size_t residentBytes = 0;  ///< of the process, mapped files left out
  std::size_t heapBytes = 0;      ///< that are allocated and not freed
  double stepMedian = 0.0;        ///< µs, of the steps since the last reading
  double step99 = 0.0;            ///< µs, that 99 % of those steps took at most
};

struct SoakSettings {
  double every = 3600.0;         ///< simulated s between readings
  std::filesystem::path folder;  ///< for telemetry and the checkpoint
  std::string backend = "osmesa";
};

struct SoakResult {
  std::vector<SoakReading> readings;
  StepTimes steps;
  long long stepCount = 0, frames = 0;
  double resumedFrom = 0.0;  ///< s: time of the checkpoint that was gone on from
  bool resumes = false;      ///< whether it came to the same bits as the run that went on
};

/// How far memory strays from its first value among `readings` from time `settled` on, as a share
/// of that; 0 without two of them.
double memoryChange(const std::vector<SoakReading>& readings, std::size_t SoakReading::*bytes,
                    double settled);

/// Sails all of a scene's duration as `seaway run` does, with telemetry, a checkpoint at each
/// reading, and frames that are drawn and dropped. Then goes on from the last checkpoint but that
/// of the end and compares the two states there. `observe` hears of each reading. Throws InputError
/// where the duration has not at least two readings.
SoakResult soak(const Scene& scene, const SoakSettings& settings,
                const std::function<void(const SoakReading&)>& observe);

}  // namespace seaway::bridge
