#include "sim_bridge/output/telemetry.h"

#include <initializer_list>

#include "sim_bridge/output/number_text.h"
#include "surface/angles.h"

namespace seaway::bridge {
namespace {

void writeRow(std::ostream& out, std::initializer_list<double> cells) {
  const char* separator = "";
  for (const double cell : cells) {
    out << separator << numberText(cell);
    separator = ",";
  }
  out << '\n';
}

}  // namespace

std::vector<std::string> telemetryFiles(const Scene& scene) {
  std::vector<std::string> names{"telemetry.csv"};
  for (std::size_t i = 1; i < scene.vessels.size(); ++i) {
    names.push_back("telemetry_" + scene.vessels[i].name + ".csv");
  }
  return names;
}

std::filesystem::path keptTelemetry(const std::filesystem::path& checkpoint,
                                    const std::string& name) {
  return checkpoint.string() + "." + name;
}

Telemetry::Telemetry(const std::filesystem::path& folder, const Scene& scene)
    : Telemetry(folder, scene, {}, {}) {}

Telemetry::Telemetry(const std::filesystem::path& folder, const Scene& scene,
                     const std::filesystem::path& from, const Checkpoint& checkpoint)
    : names_(telemetryFiles(scene)) {
  const bool goesOn = checkpoint.telemetry.size() == names_.size();
  for (std::size_t i = 0; i < names_.size(); ++i) {
    files_.push_back(std::make_unique<AtomicFile>(folder / names_[i]));
    if (goesOn) {
      copyKept(keptTelemetry(from, names_[i]), checkpoint.telemetry[i], files_.back()->stream());
      continue;
    }
    files_.back()->stream() << "time_s,latitude_deg,longitude_deg,height_m,roll_deg,pitch_deg,"
                               "heading_deg,speed_m_s,water_height_m,submerged_volume_m3\n";
  }
  if (!goesOn) return;
  keptWith_ = from;
  kept_ = checkpoint.telemetry;
}

void Telemetry::write(const Simulation& simulation) {
  const Geodesy& geodesy = simulation.sea().geodesy;
  for (std::size_t i = 0; i < simulation.vessels().size(); ++i) {
    const Vessel& vessel = simulation.vessels()[i];
    const VesselPose pose = vessel.pose();
    const GeodeticPosition place = geodesy.geodeticFromSeaPlane(pose.position);
    writeRow(files_[i]->stream(),
             {simulation.time(), place.latitude_deg, place.longitude_deg, pose.height,
              degreesFromRadians(pose.roll), degreesFromRadians(pose.pitch),
              geodesy.trueHeadingFromDirection(pose.position, pose.direction), vessel.speed(),
              vessel.waterHeight(), vessel.submergedVolume()});
  }
}

std::vector<KeptText> Telemetry::keep(const std::filesystem::path& checkpoint) {
  if (checkpoint != keptWith_) kept_.assign(names_.size(), {});
  keptWith_ = checkpoint;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    files_[i]->stream().flush();
    kept_[i] = keepText(files_[i]->beside(), keptTelemetry(checkpoint, names_[i]), kept_[i]);
  }
  return kept_;
}

void Telemetry::commit() {
  for (const auto& file : files_) file->commit();
}

}  // namespace seaway::bridge
