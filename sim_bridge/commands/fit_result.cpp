#include "sim_bridge/commands/fit_result.h"

#include <spdlog/fmt/fmt.h>

#include <nlohmann/json.hpp>
#include <ostream>

#include "sim_bridge/output/number_text.h"
#include "surface/angles.h"
#include "surface/spectra/steepness.h"

namespace seaway::bridge {
namespace {

using Json = nlohmann::ordered_json;

bool isPerlin(const FitResult& result) { return result.options.model == "perlin"; }

/// Numbers that JSON has no word for are null.
Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json asJson(const OctaveEntry& octave) {
  Json entry{{"kind", kindName(octave.kind)}, {"standard_deviation_m", octave.standardDeviation}};
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

Json asJson(const SeaParameters& parameters) {
  Json systems = Json::array();
  for (const WaveSystem& system : parameters.systems) {
    Json entry;
    const auto add = [&](const std::string& key, const Estimate& estimate, double scale = 1.0) {
      entry[key] = finite(estimate.value * scale);
      entry[key + "_standard_deviation"] = finite(estimate.deviation * scale);
    };
    add("hm0_m", system.significantWaveHeight);
    add("tp_s", system.peakPeriod);
    add("gamma", system.peakEnhancement);
    entry["from_deg"] = finite(compassFromFromToward(system.toward.value));
    entry["from_deg_standard_deviation"] = finite(degreesFromRadians(system.toward.deviation));
    add("spread_s", system.spreadExponent);
    systems.push_back(std::move(entry));
  }
  return {{"usable", parameters.usable},
          {"message", parameters.message},
          {"systems", std::move(systems)},
          {"bins", parameters.bins},
          {"zero_bins_left_out", parameters.zeroBins},
          {"deviance", parameters.deviance},
          {"aic_one_system", finite(parameters.aicOfOne)},
          {"aic_two_systems", finite(parameters.aicOfTwo)}};
}

Json asJson(const BuoyVerification& verification) {
  Json list = Json::array();
  for (const ReadBack& q : verification.quantities) {
    list.push_back({{"name", q.name},
                    {"unit", q.unit},
                    {"asked", finite(q.asked)},
                    {"read", finite(q.read)},
                    {"standard_error", finite(q.standardError)}});
  }
  return {{"hours", verification.hours},
          {"agrees_within_three_standard_errors", verification.agrees},
          {"quantities", std::move(list)}};
}

bool isTooSteep(const OctaveFitSummary& s) {
  return averageSteepness(s.hm0Target, s.tm02Target) > limitingSteepness(s.tm02Target);
}

std::string plusMinus(const Estimate& estimate, double scale = 1.0) {
  return fmt::format("{:.3g} +- {:.2g}", scale * estimate.value, scale * estimate.deviation);
}

void writeParameters(const SeaParameters& parameters, double degrees, std::ostream& out) {
  if (!parameters.usable) {
    out << "parameters: not usable: " << parameters.message << '\n';
    return;
  }
  out << fmt::format(
      "parameters by the gamma likelihood, {:g} degrees of freedom a bin, {} bins, {} that read "
      "zero left out; +- one standard deviation\n",
      degrees, parameters.bins, parameters.zeroBins);
  for (const WaveSystem& system : parameters.systems) {
    out << fmt::format("  H_m0 {} m, T_p {} s, gamma {}", plusMinus(system.significantWaveHeight),
                       plusMinus(system.peakPeriod), plusMinus(system.peakEnhancement));
    if (std::isfinite(system.toward.value)) {
      out << fmt::format(
          ", from {:.0f} +- {:.1g} deg, s {}", compassFromFromToward(system.toward.value),
          degreesFromRadians(system.toward.deviation), plusMinus(system.spreadExponent));
    }
    out << '\n';
  }
  if (std::isfinite(parameters.aicOfOne + parameters.aicOfTwo)) {
    out << fmt::format("  AIC {:.1f} with one system, {:.1f} with two\n", parameters.aicOfOne,
                       parameters.aicOfTwo);
  }
}

void writeVerification(const BuoyVerification& verification, std::ostream& out) {
  out << fmt::format("a buoy in the fitted field, {:g} h: {}\n", verification.hours,
                     verification.agrees ? "all within three standard errors"
                                         : "NOT all within three standard errors");
  out << fmt::format("  {:<28} {:>9} {:>9} {:>9}\n", "", "asked", "read", "std error");
  for (const ReadBack& q : verification.quantities) {
    out << fmt::format("  {:<28} {:>9.3f} {:>9.3f} {:>9.3f}\n", q.name + " " + q.unit, q.asked,
                       q.read, q.standardError);
  }
}

}  // namespace

std::string judgedOn(const FitResult& result) { return isPerlin(result) ? "S(k)" : "S(f)"; }

std::string judgementNote(const FitResult& result) {
  return isPerlin(result)
             ? "A Perlin fit is made and judged on the wave-number spectrum S(k): at a fixed point "
               "such a field is nearly flat in frequency up to its peak."
             : "A group fit is made and judged on S(f), the spectrum at a fixed point.";
}

FittedSeaState seaStateOf(const FitResult& result) {
  const OctaveFitSummary& s = result.fit.summary;
  const FitOptions& options = result.options;
  FittedSeaState seaState;
  for (const Octave& octave : result.fit.octaves) {
    seaState.octaves.push_back(entryOf(octave, options.depth));
  }
  FitProvenance& provenance = seaState.provenance;
  provenance.source = result.source.source;
  provenance.recordTime = result.source.recordTime;
  provenance.model = options.model;
  provenance.options =
      fmt::format("octaves {}, {}, depth_m {}, starts {}, seed {}", result.fit.octaves.size(),
                  result.directional ? std::string("the record's directions")
                                     : "from_deg " + numberText(options.from_deg.value_or(0.0)),
                  numberText(options.depth), options.starts, options.seed);
  provenance.judgedOn = judgedOn(result);
  provenance.hm0Target = s.hm0Target;
  provenance.hm0Fit = s.hm0Fit;
  provenance.tm02Target = s.tm02Target;
  provenance.tm02Fit = s.tm02Fit;
  provenance.tpTarget = s.tpTarget;
  provenance.tpFit = s.tpFit;
  provenance.residual = s.residualL2;
  return seaState;
}

void writeFitText(const FitResult& result, std::ostream& out) {
  const OctaveFitSummary& s = result.fit.summary;
  const SpectrumSource& source = result.source;
  out << fmt::format("{}{}{}: {} octaves, {}\n", source.source,
                     source.recordTime.empty() ? "" : ", ", source.recordTime,
                     result.fit.octaves.size(), s.usable ? "usable" : "not usable: " + s.message);
  out << fmt::format("          {:>9} {:>9}\n", "target", "fit");
  out << fmt::format("H_m0  m   {:>9.3f} {:>9.3f}\n", s.hm0Target, s.hm0Fit);
  out << fmt::format("T_m02 s   {:>9.3f} {:>9.3f}\n", s.tm02Target, s.tm02Fit);
  out << fmt::format("T_p   s   {:>9.3f} {:>9.3f}\n", s.tpTarget, s.tpFit);
  if (isTooSteep(s)) {
    out << fmt::format("steeper than seas get before they break: 1/{:.1f}, limit 1/{:.1f}\n",
                       1.0 / averageSteepness(s.hm0Target, s.tm02Target),
                       1.0 / limitingSteepness(s.tm02Target));
  }
  out << fmt::format("residual on {}, relative L2: {:.3f}\n", judgedOn(result), s.residualL2);
  if (s.residualGrid > 0.0) out << fmt::format("residual on E(f, theta): {:.3f}\n", s.residualGrid);
  if (!isPerlin(result)) {
    out << fmt::format("wave numbers off the dispersion relation: {:.1f} % rms\n",
                       100.0 * s.waveNumberDeviation);
  }
  if (result.directional) {
    out << fmt::format("direction off by {:.1f} deg, spread by {:.1f} deg, rms over the energy\n",
                       degreesFromRadians(s.directionError), degreesFromRadians(s.spreadError));
  }
  out << judgementNote(result) << '\n';
  if (result.parameters) {
    writeParameters(*result.parameters, result.options.degreesOfFreedom, out);
  }
  if (result.verification) writeVerification(*result.verification, out);
  if (s.usable && !result.options.out.empty()) out << "written: " << result.options.out << '\n';
  if (s.usable && !result.options.report.empty()) {
    out << "written: " << result.options.report << "/report.html, sea.yaml\n";
  }
}

void writeFitJson(const FitResult& result, std::ostream& out) {
  const OctaveFitSummary& s = result.fit.summary;
  Json octaves = Json::array();
  for (const Octave& octave : result.fit.octaves) {
    octaves.push_back(asJson(entryOf(octave, result.options.depth)));
  }
  Json json{{"source", result.source.source},
            {"record_time", result.source.recordTime},
            {"model", result.options.model},
            {"usable", s.usable},
            {"message", s.message},
            {"hm0_target_m", s.hm0Target},
            {"hm0_fit_m", s.hm0Fit},
            {"tm02_target_s", s.tm02Target},
            {"tm02_fit_s", s.tm02Fit},
            {"tp_target_s", s.tpTarget},
            {"tp_fit_s", s.tpFit},
            {"average_steepness", finite(averageSteepness(s.hm0Target, s.tm02Target))},
            {"limiting_steepness", finite(limitingSteepness(s.tm02Target))},
            {"steeper_than_limit", isTooSteep(s)},
            {"residual_l2", finite(s.residualL2)},
            {"residual_grid_l2", s.residualGrid},
            {"wave_number_deviation", s.waveNumberDeviation},
            {"direction_error_deg", degreesFromRadians(s.directionError)},
            {"spread_error_deg", degreesFromRadians(s.spreadError)},
            {"judged_on", judgedOn(result)},
            {"note", judgementNote(result)},
            {"iterations", s.iterations},
            {"octaves", std::move(octaves)}};
  if (result.parameters) json["parameters"] = asJson(*result.parameters);
  if (result.verification) json["verification"] = asJson(*result.verification);
  if (!result.options.out.empty()) json["out"] = result.options.out;
  if (!result.options.report.empty()) json["report"] = result.options.report + "/report.html";
  out << json.dump(2) << '\n';
}

}  // namespace seaway::bridge
