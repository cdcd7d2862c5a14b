#include "sim_bridge/commands/sail.h"

#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "sim_bridge/commands/options.h"
#include "sim_bridge/grounding.h"
#include "sim_bridge/output/atomic_file.h"
#include "sim_bridge/output/number_text.h"
#include "sim_bridge/output/progress.h"
#include "sim_bridge/output/stopwatch.h"
#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene/sea.h"
#include "sim_bridge/scene/vessel_launch.h"
#include "surface/angles.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

const SceneVessel& vesselOf(const Scene& scene, const std::string& name) {
  if (scene.vessels.empty()) throw InputError(scene.file.string(), 0, "has no vessel to sail");
  if (name.empty()) return scene.vessels.front();
  std::string all;
  for (const SceneVessel& vessel : scene.vessels) {
    if (vessel.name == name) return vessel;
    all += (all.empty() ? "" : ", ") + vessel.name;
  }
  throw InputError("--vessel: '" + name + "' is not in the scene; must be one of: " + all);
}

void writeRow(const FreeVessel& vessel, const Sea& sea, std::ostream& out) {
  const VesselPose pose = vessel.pose();
  const GeodeticPosition place = sea.geodesy.geodeticFromSeaPlane(pose.position);
  const double values[] = {vessel.time(),
                           place.latitude_deg,
                           place.longitude_deg,
                           pose.height,
                           degreesFromRadians(pose.roll),
                           degreesFromRadians(pose.pitch),
                           sea.geodesy.trueHeadingFromDirection(pose.position, pose.direction),
                           vessel.speed(),
                           vessel.waterHeight(),
                           vessel.submergedVolume(),
                           degreesFromRadians(vessel.body().rudderAngle()),
                           vessel.body().helm().revolutions};
  const char* separator = "";
  for (const double value : values) {
    out << separator << numberText(value);
    separator = ",";
  }
  out << '\n';
}

/// What a voyage came to.
struct Voyage {
  long long steps = 0;
  double wallMs = 0.0, mostRoll = 0.0, mostPitch = 0.0, mostCrossTrack = 0.0;
};

Voyage sail(FreeVessel& vessel, const std::string& name, const Sea& sea, const Scene& scene,
            double duration, std::ostream& telemetry) {
  Voyage voyage;
  const auto steps = static_cast<long long>(std::floor(duration / scene.run.step + 1e-6));
  Progress progress("steps", static_cast<std::size_t>(steps));
  const Stopwatch watch;
  for (; voyage.steps < steps; ++voyage.steps) {
    vessel.advance(static_cast<double>(voyage.steps + 1) * scene.run.step, sea.surface, 0);
    vessel.readWater(sea.surface, 0);
    requireFreeToMove(scene, name, vessel);
    const VesselPose pose = vessel.pose();
    if (!std::isfinite(pose.height + pose.roll)) {
      throw std::runtime_error("the vessel's motion is not finite at " +
                               std::to_string(vessel.time()) + " s");
    }
    if (!sea.geodesy.describe(pose.position).inRange) {
      throw InputError("the vessel leaves the scene's range at " + std::to_string(vessel.time()) +
                       " s");
    }
    voyage.mostRoll = std::max(voyage.mostRoll, std::abs(pose.roll));
    voyage.mostPitch = std::max(voyage.mostPitch, std::abs(pose.pitch));
    const auto& pilot = vessel.body().autopilot();
    if (pilot) {
      voyage.mostCrossTrack =
          std::max(voyage.mostCrossTrack,
                   std::abs(pilot->crossTrack(glm::dvec2(vessel.body().pose().position))));
    }
    writeRow(vessel, sea, telemetry);
    progress.update(static_cast<std::size_t>(voyage.steps + 1));
  }
  voyage.wallMs = watch.milliseconds();
  return voyage;
}

nlohmann::ordered_json asJson(const Voyage& voyage, const HullVessel& vessel,
                              const std::string& name, double step) {
  const HullModel& hull = vessel.hull();
  return {{"vessel", name},
          {"steps", voyage.steps},
          {"duration_s", vessel.time()},
          {"sub_steps", vessel.subSteps(step)},
          {"triangles", hull.panels().size()},
          {"heave_period_s", 2.0 * pi / hull.heaveFrequency()},
          {"roll_period_s", hull.rollFrequency() > 0.0
                                ? nlohmann::ordered_json(2.0 * pi / hull.rollFrequency())
                                : nlohmann::ordered_json()},
          {"shortest_wavelength_m", hull.shortestWavelength()},
          {"left_out_m", vessel.lastLoads().leftOut},
          {"most_roll_deg", degreesFromRadians(voyage.mostRoll)},
          {"most_pitch_deg", degreesFromRadians(voyage.mostPitch)},
          {"most_cross_track_m", voyage.mostCrossTrack},
          {"next_waypoint", vessel.autopilot() ? vessel.autopilot()->nextWaypoint() : 0},
          {"load_status", statusText(vessel.lastLoads().status)},
          {"wall_s", 1e-3 * voyage.wallMs}};
}

}  // namespace

int runSail(const SailOptions& options, std::ostream& out) {
  const Scene scene = loadScene(options.scene);
  const double duration = options.duration.value_or(scene.run.duration);
  requireInRange("--duration", duration, Range::between(0.0, 1e7), "s");
  const SceneVessel& description = vesselOf(scene, options.vessel);
  const std::filesystem::path folder =
      options.out.empty() ? "out/" + scene.file.stem().string() + "_sail" : options.out;
  requireWritableFolder(folder);
  const Sea sea = buildSea(scene);
  FreeVessel voyager = launchFree(scene, description, sea);
  voyager.settle(sea.surface, 0);
  const HullVessel& vessel = voyager.body();
  AtomicFile csv(folder / "voyage.csv"), summary(folder / "voyage.json");
  csv.stream() << "time_s,latitude_deg,longitude_deg,height_m,roll_deg,pitch_deg,heading_deg,"
                  "speed_m_s,water_height_m,submerged_volume_m3,rudder_deg,revolutions_s\n";
  const Voyage voyage = sail(voyager, description.name, sea, scene, duration, csv.stream());
  const auto json = asJson(voyage, vessel, description.name, scene.run.step);
  summary.stream() << json.dump(2) << '\n';
  csv.commit();
  summary.commit();
  if (options.json) {
    out << json.dump(2) << '\n';
  } else {
    out << fmt::format(
        "{}: {:.0f} s of '{}' in {:.1f} s: roll to {:.1f} deg, pitch to {:.1f} deg, {} sub-steps "
        "a step on {} triangles\n",
        folder.string(), vessel.time(), description.name, 1e-3 * voyage.wallMs,
        degreesFromRadians(voyage.mostRoll), degreesFromRadians(voyage.mostPitch),
        vessel.subSteps(scene.run.step), vessel.hull().panels().size());
  }
  return 0;
}

void addSailCommand(CLI::App& app, ChosenCommand& chosen) {
  auto* command =
      app.add_subcommand("sail", "Sail one vessel under its own power along its waypoints");
  auto options = std::make_shared<SailOptions>();
  command->add_option("SCENE", options->scene, "scene file")->required();
  command->add_option("--vessel", options->vessel, "its name (default: the first)");
  command->add_option("--duration", options->duration, "simulated seconds (default: the scene's)");
  command
      ->add_option("--out", options->out,
                   "folder for voyage.csv and voyage.json (default: out/ and the scene's name)")
      ->check(mustBeNamed);
  command->add_flag("--json", options->json, "print voyage.json to standard output");
  command->footer("Example:\n  seaway sail configs/scenes/voyage.yaml --duration 300");
  command->callback([=, &chosen] { chosen = [=] { return runSail(*options, std::cout); }; });
}

}  // namespace seaway::bridge
