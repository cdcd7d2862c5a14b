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

FittedSeaState asSeaState(const OctaveFit& fit, const SpectrumSource& source,
                          const FitOptions& options) {
  FittedSeaState seaState;
  for (const Octave& octave : fit.octaves) {
    seaState.octaves.push_back({octave.kind, octave.standardDeviation, octave.latticeSize,
                                compassTowardFromToward(octave.toward)});
  }
  FitProvenance& provenance = seaState.provenance;
  provenance.source = source.source;
  provenance.recordTime = source.recordTime;
  provenance.model = options.model;
  provenance.options =
      fmt::format("octaves {}, from_deg {}, depth_m {}", options.octaves,
                  numberText(options.from_deg.value_or(0.0)), numberText(options.depth));
  provenance.judgedOn = "S(k)";
  provenance.hm0Target = fit.summary.hm0Target;
  provenance.hm0Fit = fit.summary.hm0Fit;
  provenance.tm02Target = fit.summary.tm02Target;
  provenance.tm02Fit = fit.summary.tm02Fit;
  provenance.tpTarget = fit.summary.tpTarget;
  provenance.tpFit = fit.summary.tpFit;
  provenance.residual = fit.summary.residualL2;
  return seaState;
}

constexpr const char* judgement =
    "A Perlin fit is made and judged on the wave-number spectrum S(k): at a fixed point such a "
    "field "
    "is nearly flat in frequency up to its peak.";

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
  out << fmt::format("residual on S(k), relative L2: {:.3f}\n{}\n", s.residualL2, judgement);
  if (s.usable && !options.out.empty()) out << "written: " << options.out << '\n';
}

void writeJson(const OctaveFit& fit, const SpectrumSource& source, const FitOptions& options,
               std::ostream& out) {
  const OctaveFitSummary& s = fit.summary;
  nlohmann::ordered_json octaves = nlohmann::ordered_json::array();
  for (const Octave& octave : fit.octaves) {
    octaves.push_back({{"kind", "perlin"},
                       {"standard_deviation_m", octave.standardDeviation},
                       {"lattice_m", octave.latticeSize},
                       {"toward_deg", compassTowardFromToward(octave.toward)}});
  }
  nlohmann::ordered_json result{{"source", source.source},    {"record_time", source.recordTime},
                                {"model", options.model},     {"usable", s.usable},
                                {"message", s.message},       {"hm0_target_m", s.hm0Target},
                                {"hm0_fit_m", s.hm0Fit},      {"tm02_target_s", s.tm02Target},
                                {"tm02_fit_s", s.tm02Fit},    {"tp_target_s", s.tpTarget},
                                {"tp_fit_s", s.tpFit},        {"residual_l2", s.residualL2},
                                {"judged_on", "S(k)"},        {"note", judgement},
                                {"iterations", s.iterations}, {"octaves", std::move(octaves)}};
  if (!options.out.empty()) result["out"] = options.out;
  out << result.dump(2) << '\n';
}

}  // namespace

int runFit(const FitOptions& options, std::ostream& out) {
  if (options.model != "perlin") {
    throw InputError("--model: '" + options.model + "' is not allowed; must be one of: perlin");
  }
  requireInRange("--octaves", options.octaves, Range::within(1, 32), "");
  const double from_deg = options.from_deg.value_or(0.0);
  requireInRange("--from-deg", from_deg, Range::within(-360.0, 360.0), "°");
  requireInRange("--depth", options.depth, Range::above(0.0).orInfinite(), "m");
  const SpectrumSource source = spectrumFrom(options.spectrum, options.record, options.time);
  requireWritableFile(options.out);
  OctaveFitOptions fitOptions;
  fitOptions.octaves = options.octaves;
  fitOptions.toward = towardFromCompassFrom(from_deg);
  fitOptions.depth = options.depth;
  if (!options.from_deg) {
    spdlog::warn("a frequency spectrum has no direction: waves from 0 deg assumed; see --from-deg");
  }
  const OctaveFit fit = fitPerlinOctaves(source.spectrum, fitOptions);
  if (fit.summary.usable) writeSeaState(options.out, asSeaState(fit, source, options));
  (options.json ? writeJson : writeText)(fit, source, options, out);
  return fit.summary.usable ? 0 : 1;
}

void addFitCommand(CLI::App& app, ChosenCommand& chosen) {
  auto* command = app.add_subcommand("fit", "Fit octaves to a spectrum");
  auto options = std::make_shared<FitOptions>();
  command
      ->add_option("SPECTRUM", options->spectrum,
                   "NDBC spectral density file, jonswap:Hs,Tp,gamma or pm:Hs,Tp")
      ->required();
  command->add_option("--record", options->record, "record of the file, from 0 (default 0)");
  command->add_option("--time", options->time, "record nearest to this time, ISO 8601, UTC");
  command->add_option("--model", options->model, "kind of field: perlin");
  command->add_option("--octaves", options->octaves, "octaves to fit (default 8)");
  command->add_option("--from-deg", options->from_deg,
                      "compass direction the waves come from: a frequency spectrum does not say "
                      "(default 0, with a warning)");
  command->add_option("--depth", options->depth, "water depth, m (default: deep)");
  command->add_option("--out", options->out, "sea state file to write")->required();
  command->add_flag("--json", options->json, "machine-readable");
  command->footer(
      "Examples:\n  seaway fit 41010.data_spec --record 0 --from-deg 196 --out sea.yaml\n"
      "  seaway fit jonswap:2.5,8,3.3 --from-deg 270 --out sea.yaml");
  command->callback([=, &chosen] { chosen = [=] { return runFit(*options, std::cout); }; });
}

}  // namespace seaway::bridge
