#include "sim_bridge/commands/fit.h"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "sim_bridge/commands/spectrum_source.h"
#include "sim_bridge/output/atomic_file.h"
#include "sim_bridge/scene/sea_state_file.h"
#include "surface/angles.h"
#include "surface/fit/octave_fit.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

bool isPerlin(const FitOptions& options) { return options.model == "perlin"; }

/// The spectrum that a model is fitted to and judged on.
const char* judgedOn(const FitOptions& options) { return isPerlin(options) ? "S(k)" : "S(f)"; }

FittedSeaState asSeaState(const OctaveFit& fit, const SpectrumSource& source,
                          const FitOptions& options) {
  FittedSeaState seaState;
  for (const Octave& octave : fit.octaves) {
    seaState.octaves.push_back(entryOf(octave, options.depth));
  }
  FitProvenance& provenance = seaState.provenance;
  provenance.source = source.source;
  provenance.recordTime = source.recordTime;
  provenance.model = options.model;
  provenance.options =
      fmt::format("octaves {}, from_deg {}, depth_m {}", fit.octaves.size(),
                  numberText(options.from_deg.value_or(0.0)), numberText(options.depth));
  provenance.judgedOn = judgedOn(options);
  provenance.hm0Target = fit.summary.hm0Target;
  provenance.hm0Fit = fit.summary.hm0Fit;
  provenance.tm02Target = fit.summary.tm02Target;
  provenance.tm02Fit = fit.summary.tm02Fit;
  provenance.tpTarget = fit.summary.tpTarget;
  provenance.tpFit = fit.summary.tpFit;
  provenance.residual = fit.summary.residualL2;
  return seaState;
}

const char* judgement(const FitOptions& options) {
  return isPerlin(options)
             ? "A Perlin fit is made and judged on the wave-number spectrum S(k): at a fixed point "
               "such a field is nearly flat in frequency up to its peak."
             : "A group fit is made and judged on S(f), the spectrum at a fixed point.";
}

void writeText(const OctaveFit& fit, const SpectrumSource& source, const FitOptions& options,
               std::ostream& out) {
  const OctaveFitSummary& s = fit.summary;
  out << fmt::format("{}{}{}: {} octaves, {}\n", source.source,
                     source.recordTime.empty() ? "" : ", ", source.recordTime, fit.octaves.size(),
                     s.usable ? "usable" : "not usable: " + s.message);
  out << fmt::format("          {:>9} {:>9}\n", "target", "fit");
  out << fmt::format("H_m0  m   {:>9.3f} {:>9.3f}\n", s.hm0Target, s.hm0Fit);
  out << fmt::format("T_m02 s   {:>9.3f} {:>9.3f}\n", s.tm02Target, s.tm02Fit);
  out << fmt::format("T_p   s   {:>9.3f} {:>9.3f}\n", s.tpTarget, s.tpFit);
  out << fmt::format("residual on {}, relative L2: {:.3f}\n{}\n", judgedOn(options), s.residualL2,
                     judgement(options));
  if (s.usable && !options.out.empty()) out << "written: " << options.out << '\n';
}

nlohmann::ordered_json asJson(const OctaveEntry& octave) {
  nlohmann::ordered_json entry{{"kind", kindName(octave.kind)},
                               {"standard_deviation_m", octave.standardDeviation}};
  const auto add = [&](const char* key, const std::optional<double>& value) {
    if (value) entry[key] = *value;
  };
  add("lattice_m", octave.latticeSize);
  add("frequency_hz", octave.frequency);
  add("bandwidth_hz", octave.bandwidth);
  add("directional_width_deg", octave.directionalWidth_deg);
  entry["toward_deg"] = octave.toward_deg;
  return entry;
}

void writeJson(const OctaveFit& fit, const SpectrumSource& source, const FitOptions& options,
               std::ostream& out) {
  const OctaveFitSummary& s = fit.summary;
  nlohmann::ordered_json octaves = nlohmann::ordered_json::array();
  for (const Octave& octave : fit.octaves) octaves.push_back(asJson(entryOf(octave, options.depth)));
  nlohmann::ordered_json result{{"source", source.source},    {"record_time", source.recordTime},
                                {"model", options.model},     {"usable", s.usable},
                                {"message", s.message},       {"hm0_target_m", s.hm0Target},
                                {"hm0_fit_m", s.hm0Fit},      {"tm02_target_s", s.tm02Target},
                                {"tm02_fit_s", s.tm02Fit},    {"tp_target_s", s.tpTarget},
                                {"tp_fit_s", s.tpFit},        {"residual_l2", s.residualL2},
                                {"judged_on", judgedOn(options)}, {"note", judgement(options)},
                                {"iterations", s.iterations}, {"octaves", std::move(octaves)}};
  if (!options.out.empty()) result["out"] = options.out;
  out << result.dump(2) << '\n';
}

}  // namespace

int runFit(const FitOptions& options, std::ostream& out) {
  if (options.model != "perlin" && options.model != "group") {
    throw InputError("--model: '" + options.model +
                     "' is not allowed; must be one of: group, perlin");
  }
  const int octaves = options.octaves.value_or(isPerlin(options) ? 8 : 24);
  requireInRange("--octaves", octaves, Range::within(1, 64), "");
  const double from_deg = options.from_deg.value_or(0.0);
  requireInRange("--from-deg", from_deg, Range::within(-360.0, 360.0), "°");
  requireInRange("--depth", options.depth, Range::above(0.0).orInfinite(), "m");
  const SpectrumSource source =
      spectrumFrom(options.spectrum, options.record, options.time, options.format);
  requireWritableFile(options.out);
  OctaveFitOptions fitOptions;
  fitOptions.octaves = octaves;
  fitOptions.toward = towardFromCompassFrom(from_deg);
  fitOptions.depth = options.depth;
  if (!options.from_deg) {
    spdlog::warn("a frequency spectrum has no direction: waves from 0 deg assumed; see --from-deg");
  }
  const OctaveFit fit = isPerlin(options) ? fitPerlinOctaves(source.spectrum.energy, fitOptions)
                                          : fitGroupOctaves(source.spectrum.energy, fitOptions);
  if (fit.summary.usable) writeSeaState(options.out, asSeaState(fit, source, options));
  (options.json ? writeJson : writeText)(fit, source, options, out);
  return fit.summary.usable ? 0 : 1;
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
  command->add_option("--model", options->model, "kind of octaves: perlin or group (default perlin)");
  command->add_option("--octaves", options->octaves, "octaves to fit (default 8 Perlin or 24 group octaves)");
  command->add_option("--from-deg", options->from_deg,
                      "compass direction the waves come from: a frequency spectrum does not say "
                      "(default 0, with a warning)");
  command->add_option("--depth", options->depth, "water depth, m (default: deep)");
  command->add_option("--out", options->out, "sea state file to write")->required();
  command->add_flag("--json", options->json, "machine-readable");
  command->footer(
      "Families:\n" + spectrumFamilies() + "File formats:\n" + spectrumFileFormats() +
      "Examples:\n  seaway fit 41010.data_spec --record 0 --from-deg 196 --out sea.yaml\n"
      "  seaway fit jonswap:2.5,8,3.3 --from-deg 270 --out sea.yaml");
  command->callback([=, &chosen] { chosen = [=] { return runFit(*options, std::cout); }; });
}

}  // namespace seaway::bridge
