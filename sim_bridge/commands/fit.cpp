#include "sim_bridge/commands/fit.h"

#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>

#include "sim_bridge/commands/fit_report.h"
#include "sim_bridge/commands/fit_result.h"
#include "sim_bridge/commands/options.h"
#include "sim_bridge/output/atomic_file.h"
#include "sim_bridge/output/progress.h"
#include "sim_bridge/report/plot.h"
#include "surface/angles.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

bool hasDirections(const DirectionalSpectrum& spectrum) {
  return std::any_of(spectrum.moments.begin(), spectrum.moments.end(),
                     [](const DirectionalMoments& m) { return m.hasFirst(); });
}

void requireSound(const FitOptions& options) {
  if (options.model != "perlin" && options.model != "group") {
    throw InputError("--model: '" + options.model +
                     "' is not allowed; must be one of: group, perlin");
  }
  if (options.octaves) requireInRange("--octaves", *options.octaves, Range::within(1, 64), "");
  requireInRange("--starts", options.starts, Range::within(1, 1000), "");
  requireInRange("--from-deg", options.from_deg.value_or(0.0), Range::within(-360.0, 360.0), "°");
  requireInRange("--depth", options.depth, Range::above(0.0).orInfinite(), "m");
  requireInRange("--degrees-of-freedom", options.degreesOfFreedom, Range::within(2.0, 1e6), "");
  requireInRange("--hours", options.hours, Range::within(0.1, 1e3), "h");
  if (options.out.empty() && options.report.empty()) {
    throw InputError("give --out FILE for the sea state, or --report DIR");
  }
}

FitResult fitAll(const FitOptions& options, const SpectrumSource& source) {
  FitResult result{options, source, false, {}, {}, {}};
  const bool perlin = options.model == "perlin";
  OctaveFitOptions fitOptions;
  fitOptions.octaves = options.octaves.value_or(perlin ? 8 : 24);
  fitOptions.toward = towardFromCompassFrom(options.from_deg.value_or(0.0));
  fitOptions.depth = options.depth;
  fitOptions.starts = options.starts;
  fitOptions.seed = static_cast<std::uint64_t>(options.seed);
  result.directional = !perlin && !options.from_deg && hasDirections(source.spectrum);
  if (!result.directional && !options.from_deg) {
    spdlog::warn("{}: waves from 0 deg assumed; see --from-deg",
                 perlin && hasDirections(source.spectrum)
                     ? "a Perlin fit takes no directions from a spectrum"
                     : "a frequency spectrum has no direction");
  }
  Progress progress("fit", 3);
  result.fit = perlin               ? fitPerlinOctaves(source.spectrum.energy, fitOptions)
               : result.directional ? fitGroupOctaves(source.spectrum, fitOptions)
                                    : fitGroupOctaves(source.spectrum.energy, fitOptions);
  progress.update(1);
  if (options.parameters) {
    SeaParameterOptions parameterOptions;
    parameterOptions.degreesOfFreedom = options.degreesOfFreedom;
    result.parameters = fitSeaParameters(source.spectrum, parameterOptions);
  }
  progress.update(2);
  if (options.verify && result.fit.summary.usable) {
    DirectionalSpectrum asked = source.spectrum;
    if (!result.directional) asked.moments.clear();
    result.verification = verifyWithBuoy(asked, result.fit, options.depth,
                                         static_cast<std::uint64_t>(options.seed), options.hours);
  }
  progress.update(3);
  return result;
}

}  // namespace

int runFit(const FitOptions& options, std::ostream& out) {
  requireSound(options);
  const SpectrumSource source =
      spectrumFrom(options.spectrum, options.record, options.time, options.format);
  if (!options.out.empty()) requireWritableFile(options.out);
  if (!options.report.empty()) {
    requireWritableFolder(options.report);
    requirePlotter();
  }
  const FitResult result = fitAll(options, source);
  if (result.fit.summary.usable) {
    if (!options.out.empty()) writeSeaState(options.out, seaStateOf(result));
    if (!options.report.empty()) writeFitReport(result, options.report);
  }
  (options.json ? writeFitJson : writeFitText)(result, out);
  return result.fit.summary.usable ? 0 : 1;
}

void addFitCommand(CLI::App& app, ChosenCommand& chosen) {
  auto* command = app.add_subcommand("fit", "Fit octaves to a spectrum");
  auto options = std::make_shared<FitOptions>();
  command
      ->add_option("SPECTRUM", options->spectrum,
                   "file of spectra, or a family such as jonswap:Hs,Tp,gamma; see below")
      ->required();
  command->add_option("--record", options->record, "record of the file, from 0 (default 0)");
  command->add_option("--time", options->time, "record nearest to this time, ISO 8601, UTC");
  command->add_option("--format", options->format, "format of the file (default: by its content)");
  command->add_option("--model", options->model,
                      "kind of octaves: perlin or group (default perlin)");
  command->add_option("--octaves,--budget", options->octaves,
                      "octaves to fit (default 8 Perlin or 24 group octaves)");
  command->add_option("--starts", options->starts,
                      "group fits: starts that are tried, the best is kept (default 4)");
  command->add_option("--seed", options->seed, "of further starts and of --verify (default 1)");
  command->add_flag("--parameters", options->parameters,
                    "fit H_m0, T_p, gamma, direction and s of one or two wave systems too");
  command->add_option("--degrees-of-freedom", options->degreesOfFreedom,
                      "of each spectral estimate, for --parameters (default 20)");
  command->add_option("--from-deg", options->from_deg,
                      "compass direction the waves come from: overrides a spectrum's own, and a "
                      "frequency spectrum does not say (default 0, with a warning)");
  command->add_option("--depth", options->depth, "water depth, m (default: deep)");
  command->add_option("--out", options->out, "sea state file to write")->check(mustBeNamed);
  command->add_option("--report", options->report, "folder for sea.yaml and report.html")
      ->check(mustBeNamed);
  command->add_flag("--verify", options->verify,
                    "moor a buoy in the fitted field and compare what it reads");
  command->add_option("--hours", options->hours, "length of its record, h (default 3)");
  command->add_flag("--json", options->json, "machine-readable");
  command->footer(
      "Families:\n" + spectrumFamilies() + "File formats:\n" + spectrumFileFormats() +
      "Examples:\n  seaway fit 41010.data_spec --model group --verify --report out/fit\n"
      "  seaway fit jonswap:2.5,8,3.3 --from-deg 270 --out sea.yaml");
  command->callback([=, &chosen] { chosen = [=] { return runFit(*options, std::cout); }; });
}

}  // namespace seaway::bridge
