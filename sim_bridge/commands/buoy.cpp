#include "sim_bridge/commands/buoy.h"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "sim_bridge/commands/options.h"
#include "sim_bridge/commands/points_table.h"
#include "sim_bridge/output/atomic_file.h"
#include "sim_bridge/output/number_text.h"
#include "sim_bridge/output/progress.h"
#include "sim_bridge/scene/scene_loader.h"
#include "surface/angles.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

constexpr double mostSamples = 2e7;  // half a gigabyte of record
constexpr std::size_t fewestSegmentSamples = 8;

/// Where the buoy lies, and how its plane's directions read on a compass there.
struct Mooring {
  const Geodesy* geodesy;
  double latitude_deg = 0.0, longitude_deg = 0.0;
  glm::dvec2 place{0.0};  // sea plane, m

  double from_deg(const DirectionalMoments& moments) const {
    const double heading = geodesy->trueHeadingFromDirection(place, moments.meanDirection());
    return compassWrapped(heading + 180.0);
  }
};

double spread_deg(const DirectionalMoments& moments) {
  return degreesFromRadians(moments.spread());
}

void requireSound(const BuoyOptions& options) {
  const auto upTo = [](double most) {
    return Range{.least = 0.0, .most = most, .leastIncluded = false};
  };
  requireInRange("--hours", options.hours, upTo(1e5), "h");
  requireInRange("--rate", options.rate, upTo(1e3), "Hz");
  const double duration = options.hours * 3600.0;
  if (duration * options.rate > mostSamples) {
    throw InputError("--hours, --rate: " + numberText(duration * options.rate) +
                     " samples are not allowed; must be <= " + numberText(mostSamples));
  }
  const double shortest = static_cast<double>(fewestSegmentSamples) / options.rate;
  if (duration < shortest) {
    throw InputError("--hours: a record of " + numberText(duration) +
                     " s is not allowed; must be >= " + numberText(shortest) + " s, 8 samples");
  }
  requireInRange("--segment", options.segment, Range::within(shortest, duration),
                 "s: 8 samples or more, no longer than the record");
}

Mooring mooringOf(const BuoyOptions& options, const Geodesy& geodesy) {
  const PointsTable table = pointsFromArguments({options.at});
  Mooring mooring{&geodesy};
  mooring.latitude_deg = table.number(0, table.columns.latitude);
  mooring.longitude_deg = table.number(0, table.columns.longitude);
  requireInRange("--at: latitude", mooring.latitude_deg, Range::within(-90.0, 90.0), "°");
  const SeaPlanePoint point =
      geodesy.seaPlaneFromGeodetic(mooring.latitude_deg, mooring.longitude_deg);
  if (!point.inRange) {
    throw InputError("--at: '" + options.at + "' is farther from the scene's anchor than " +
                     numberText(Geodesy::usableRange() / 1000.0) + " km, the scene's range");
  }
  mooring.place = point.position;
  return mooring;
}

void warnOfAliases(const WaveField& waves, double rate) {
  const double nyquist = 0.5 * rate;
  double above = 0.0, all = 0.0;
  for (const Octave& octave : waves.octaves()) {
    const double variance = octave.standardDeviation * octave.standardDeviation;
    all += variance;
    if (octave.kind == OctaveKind::perlin) continue;
    if (bandOf(octave, waves.settings().depth).frequency > nyquist) above += variance;
  }
  if (above <= 0.01 * all) return;
  spdlog::warn(
      "{:.0f} % of the sea's energy lies above {} Hz, half the sampling rate, and reads as "
      "lower frequencies; see --rate",
      100.0 * above / all, nyquist);
}

void writeRecord(const BuoyRecord& record, double rate, std::ostream& out) {
  out << "time_s,height_m,slope_x,slope_y\n";
  for (std::size_t i = 0; i < record.heave.size(); ++i) {
    out << numberText(static_cast<double>(i) / rate) << ',' << numberText(record.heave[i]) << ','
        << numberText(record.slopeEast[i]) << ',' << numberText(record.slopeNorth[i]) << '\n';
  }
}

nlohmann::ordered_json asJson(const BuoyAnalysis& sea, const BuoyRecord& record,
                              const Mooring& mooring) {
  std::vector<double> from, spread;
  for (const DirectionalMoments& bin : sea.directions) {
    from.push_back(mooring.from_deg(bin));
    spread.push_back(spread_deg(bin));
  }
  return {{"latitude_deg", mooring.latitude_deg},
          {"longitude_deg", mooring.longitude_deg},
          {"duration_s", record.duration()},
          {"rate_hz", 1.0 / record.timeStep},
          {"samples", record.heave.size()},
          {"hm0_m", sea.significantWaveHeight},
          {"hm0_standard_error_m", sea.significantWaveHeightError},
          {"tp_s", sea.peakPeriod},
          {"tm02_s", sea.zeroCrossingPeriod},
          {"mean_direction_from_deg", mooring.from_deg(sea.overall)},
          {"spread_deg", spread_deg(sea.overall)},
          {"peak_direction_from_deg", mooring.from_deg(sea.peak)},
          {"peak_spread_deg", spread_deg(sea.peak)},
          {"kurtosis", sea.kurtosis},
          {"skewness", sea.skewness},
          {"segment_s", sea.segment},
          {"segments", sea.segments},
          {"degrees_of_freedom", sea.degreesOfFreedom},
          {"band_hz", {sea.spectrum.lowest(), sea.spectrum.highest()}},
          {"spectrum",
           {{"frequency_hz", sea.spectrum.frequency},
            {"density_m2_hz", sea.spectrum.density},
            {"direction_from_deg", from},
            {"spread_deg", spread},
            {"wave_number_rad_m", sea.waveNumber}}}};
}

void writeText(const BuoyAnalysis& sea, const BuoyRecord& record, const Mooring& mooring,
               const BuoyOptions& options, std::ostream& out) {
  out << fmt::format("buoy at {}, {}: {:g} h, {} samples at {:g} Hz\n",
                     numberText(mooring.latitude_deg), numberText(mooring.longitude_deg),
                     record.duration() / 3600.0, record.heave.size(), options.rate);
  out << fmt::format("H_m0       {:>8.3f} m  +- {:.3f} (one standard error of such a record)\n",
                     sea.significantWaveHeight, sea.significantWaveHeightError);
  out << fmt::format("T_p        {:>8.2f} s\nT_m02      {:>8.2f} s\n", sea.peakPeriod,
                     sea.zeroCrossingPeriod);
  const auto direction = [&](const char* name, const DirectionalMoments& moments) {
    out << fmt::format("direction  {:>8.1f} deg from, {}, spread {:.1f} deg\n",
                       mooring.from_deg(moments), name, spread_deg(moments));
  };
  direction("overall", sea.overall);
  direction("at the peak", sea.peak);
  out << fmt::format("kurtosis   {:>8.2f}\nskewness   {:>8.2f}\n", sea.kurtosis, sea.skewness);
  out << fmt::format(
      "Welch: {} segments of {:g} s, Hann, half overlapping: {:.0f} degrees of freedom, "
      "{:.4f} to {:g} Hz\n",
      sea.segments, sea.segment, sea.degreesOfFreedom, sea.spectrum.lowest(),
      sea.spectrum.highest());
  if (!options.out.empty()) out << "written: " << options.out << '\n';
}

}  // namespace

BuoyRecord recordBuoy(const Sea& sea, glm::dvec2 place, double rate, std::size_t count) {
  BuoyRecord record;
  record.timeStep = 1.0 / rate;
  for (auto* series : {&record.heave, &record.slopeEast, &record.slopeNorth})
    series->reserve(count);
  Progress progress("buoy", count);
  for (std::size_t i = 0; i < count; ++i) {
    const SurfaceSample sample = sea.surface.at(static_cast<double>(i) / rate).sample(place);
    if (has(sample.status, SampleStatus::dry)) {
      throw InputError("the buoy's place is outside the sea's outline: there is no water");
    }
    record.heave.push_back(sample.height);
    record.slopeEast.push_back(sample.slope.x);
    record.slopeNorth.push_back(sample.slope.y);
    progress.update(i + 1);
  }
  return record;
}

int runBuoy(const BuoyOptions& options, std::ostream& out) {
  requireSound(options);
  const Scene scene = loadScene(options.scene);
  if (!options.out.empty()) requireWritableFile(options.out);
  const Sea sea = buildSea(scene);
  const Mooring mooring = mooringOf(options, sea.geodesy);
  warnOfAliases(sea.surface.waves(), options.rate);
  // The margin takes back the rounding of hours that are whole multiples of the step.
  const auto count = static_cast<std::size_t>(options.hours * 3600.0 * options.rate + 1e-6);
  const BuoyRecord record = recordBuoy(sea, mooring.place, options.rate, count);
  const BuoyAnalysis analysis = analyseBuoy(record, {.segment = options.segment});
  if (!options.out.empty()) {
    AtomicFile file(options.out);
    writeRecord(record, options.rate, file.stream());
    file.commit();
  }
  if (options.json) {
    out << asJson(analysis, record, mooring).dump(2) << '\n';
  } else {
    writeText(analysis, record, mooring, options, out);
  }
  return 0;
}

void addBuoyCommand(CLI::App& app, ChosenCommand& chosen) {
  auto* command = app.add_subcommand("buoy", "Moor a heave-slope buoy and read its spectrum");
  auto options = std::make_shared<BuoyOptions>();
  command->add_option("SCENE", options->scene, "scene file")->required();
  command->add_option("--at", options->at, "LATITUDE,LONGITUDE in degrees")->required();
  command->add_option("--hours", options->hours, "length of the record, h (default 3)");
  command->add_option("--rate", options->rate, "samples a second, Hz (default 2)");
  command->add_option("--segment", options->segment,
                      "length of a segment of Welch's method, s (default 256)");
  command
      ->add_option("--out", options->out, "CSV file of the record: time_s,height_m,slope_x,slope_y")
      ->check(mustBeNamed);
  command->add_flag("--json", options->json, "machine-readable, with the spectrum");
  command->footer("Example:\n  seaway buoy configs/scenes/canaveral.yaml --at 28.878,-78.467");
  command->callback([=, &chosen] { chosen = [=] { return runBuoy(*options, std::cout); }; });
}

}  // namespace seaway::bridge
