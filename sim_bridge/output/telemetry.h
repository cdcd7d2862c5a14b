#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim_bridge/output/atomic_file.h"
#include "sim_bridge/simulation.h"

namespace seaway::bridge {

/// Names of the telemetry files of a scene, in the order of its vessels; one at least.
std::vector<std::string> telemetryFiles(const Scene& scene);

/// The motion of a scene's vessels as CSV, one row a step: `telemetry.csv` for the first vessel
/// (only a header where there is none), `telemetry_NAME.csv` for each further one.
///
/// Columns: time_s, latitude_deg, longitude_deg, height_m (of the body origin above the still-water
/// level), roll_deg (starboard down), pitch_deg (bow up), heading_deg (true), speed_m_s (over
/// ground along the heading, negative astern), water_height_m (at the body origin, above the
/// still-water level), submerged_volume_m3.
class Telemetry {
 public:
  /// Throws InputError where nothing can be written in `folder`.
  Telemetry(const std::filesystem::path& folder, const Scene& scene);

  void write(const Simulation& simulation);

  /// Makes the files appear.
  void commit();

 private:
  std::vector<std::unique_ptr<AtomicFile>> files_;
};

}  // namespace seaway::bridge
