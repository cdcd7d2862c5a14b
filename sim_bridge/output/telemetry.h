#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim_bridge/output/atomic_file.h"
#include "sim_bridge/output/checkpoint.h"
#include "sim_bridge/simulation.h"

namespace seaway::bridge {

/// Names of the telemetry files of a scene, in the order of its vessels; one at least.
std::vector<std::string> telemetryFiles(const Scene& scene);

/// Where the beginning of a file of telemetry is kept that a checkpoint goes with.
std::filesystem::path keptTelemetry(const std::filesystem::path& checkpoint,
                                    const std::string& name);

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
  /// The same of a run that goes on from a checkpoint, read from the file `from`: begins with what
  /// was kept with it. Throws InputError where that is missing or other than it was.
  Telemetry(const std::filesystem::path& folder, const Scene& scene,
            const std::filesystem::path& from, const Checkpoint& checkpoint);

  void write(const Simulation& simulation);

  /// Keeps all rows so far beside the file `checkpoint`, by whose writing they come to count:
  /// before it, the one that stands there still finds its own. Throws std::runtime_error.
  std::vector<KeptText> keep(const std::filesystem::path& checkpoint);

  /// Makes the files appear.
  void commit();

 private:
  std::vector<std::string> names_;
  std::vector<std::unique_ptr<AtomicFile>> files_;
  std::filesystem::path keptWith_;  // checkpoint that `kept_` is of
  std::vector<KeptText> kept_;
};

}  // namespace seaway::bridge
