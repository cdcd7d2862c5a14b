#include "sim_bridge/commands/fit_report.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "sim_bridge/output/atomic_file.h"
#include "sim_bridge/report/html_page.h"
#include "sim_bridge/report/plot.h"
#include "surface/angles.h"
#include "surface/fit/field_reading.h"

namespace seaway::bridge {
namespace {

std::string number(double value, int digits = 3) { return fmt::format("{:.{}f}", value, digits); }

void addSummary(const FitResult& result, HtmlPage& page) {
  const OctaveFitSummary& s = result.fit.summary;
  page.table({"", "target", "fit", "unit"},
             {{"H_m0, significant wave height", number(s.hm0Target), number(s.hm0Fit), "m"},
              {"T_m02, mean zero-crossing period", number(s.tm02Target), number(s.tm02Fit), "s"},
              {"T_p, peak period", number(s.tpTarget), number(s.tpFit), "s"}});
  std::vector<std::vector<std::string>> rows{
      {"relative L2 residual on " + judgedOn(result), number(s.residualL2)}};
  if (s.residualGrid > 0.0) {
    rows.push_back({"relative L2 residual over frequency and direction", number(s.residualGrid)});
  }
  if (result.options.model == "group") {
    rows.push_back({"wave numbers off the dispersion relation, rms over the energy",
                    number(100.0 * s.waveNumberDeviation, 1) + " %"});
  }
  if (result.directional) {
    rows.push_back({"mean direction off the target, rms over the energy",
                    number(degreesFromRadians(s.directionError), 1) + " deg"});
    rows.push_back({"directional spread off the target, rms over the energy",
                    number(degreesFromRadians(s.spreadError), 1) + " deg"});
  }
  rows.push_back({"solver iterations", std::to_string(s.iterations)});
  page.table({"quality of the fit", ""}, rows);
  page.paragraph(judgementNote(result));
}

void addVerification(const FitResult& result, HtmlPage& page) {
  if (!result.verification) return;
  const BuoyVerification& verification = *result.verification;
  page.heading("What a buoy reads in the fitted field");
  std::vector<std::vector<std::string>> rows;
  for (const ReadBack& q : verification.quantities) {
    rows.push_back({q.name + ", " + q.unit, number(q.asked), number(q.read),
                    number(q.standardError), number(q.deviations(), 1)});
  }
  page.table({"", "asked", "read", "standard error", "deviation in standard errors"}, rows);
  page.paragraph(fmt::format(
      "A simulated heave-slope buoy, {:g} h: {} within three standard errors of such a record.",
      verification.hours, verification.agrees ? "all" : "not all"));
}

std::string estimateText(const Estimate& estimate, double scale, int digits) {
  if (!std::isfinite(estimate.value)) return "not known";
  return number(scale * estimate.value, digits) + " ± " +
         number(scale * estimate.deviation, digits);
}

void addParameters(const FitResult& result, HtmlPage& page) {
  if (!result.parameters) return;
  const SeaParameters& parameters = *result.parameters;
  page.heading("Parameters of the sea");
  if (!parameters.usable) {
    page.paragraph("Not usable: " + parameters.message);
    return;
  }
  std::vector<std::vector<std::string>> rows;
  for (const WaveSystem& system : parameters.systems) {
    Estimate from = system.toward;
    from.value = compassFromFromToward(from.value);
    from.deviation = degreesFromRadians(from.deviation);
    rows.push_back({"system " + std::to_string(rows.size() + 1),
                    estimateText(system.significantWaveHeight, 1.0, 2),
                    estimateText(system.peakPeriod, 1.0, 2),
                    estimateText(system.peakEnhancement, 1.0, 1), estimateText(from, 1.0, 0),
                    estimateText(system.spreadExponent, 1.0, 1)});
  }
  page.table({"", "H_m0, m", "T_p, s", "gamma", "from, deg", "s of cos^2s(θ/2)"}, rows);
  page.paragraph(fmt::format(
      "JONSWAP systems by the gamma likelihood with {:g} degrees of freedom a bin; {} bins, {} "
      "that read zero left out; ± one standard deviation. AIC {:.1f} with one system, {:.1f} with "
      "two.",
      result.options.degreesOfFreedom, parameters.bins, parameters.zeroBins, parameters.aicOfOne,
      parameters.aicOfTwo));
}

std::vector<Curve> spectra(const FitResult& result, double floor) {
  const auto lifted = [&](std::vector<double> values) {
    for (double& value : values) {
      if (value < floor) value = std::nan("");
    }
    return values;
  };
  const FrequencySpectrum& target = result.source.spectrum.energy;
  const FrequencySpectrum& model = result.fit.model.energy;
  std::vector<Curve> curves;
  curves.push_back({"target", target.frequency, lifted(target.density), CurveStyle::line});
  curves.push_back({"fit", model.frequency, lifted(model.density), CurveStyle::dashed});
  if (result.verification) {
    const FrequencySpectrum& buoy = result.verification->analysis.spectrum;
    curves.push_back(
        {"buoy in the fitted field", buoy.frequency, lifted(buoy.density), CurveStyle::points});
  }
  return curves;
}

void addSpectra(const FitResult& result, HtmlPage& page) {
  const FrequencySpectrum& target = result.source.spectrum.energy;
  const double highest = *std::max_element(target.density.begin(), target.density.end());
  const double peak = 1.0 / std::max(result.fit.summary.tpTarget, 1e-6);
  const double shown = std::min(target.highest(), 4.0 * peak);
  page.heading("Spectrum");
  page.figure(svgOf("Frequency spectrum", {"frequency, Hz", false, target.lowest(), shown},
                    {"S(f), m²/Hz", false, 0.0}, spectra(result, 0.0)),
              "Target, fit in closed form and, where asked for, a simulated buoy's estimate.");
  page.figure(
      svgOf("Frequency spectrum, logarithmic",
            {"frequency, Hz", false, target.lowest(), target.highest()},
            {"S(f), m²/Hz", true, 1e-4 * highest, 2.0 * highest}, spectra(result, 1e-5 * highest)),
      "The same; the tail carries the slopes.");
}

/// The model at the frequencies of a spectrum's bins.
double modelAt(const FitResult& result, double f) { return result.fit.model.energy.at(f); }

void addResiduals(const FitResult& result, HtmlPage& page) {
  const FrequencySpectrum& target = result.source.spectrum.energy;
  const double highest = *std::max_element(target.density.begin(), target.density.end());
  Curve residual{"(fit − target)/largest density", {}, {}, CurveStyle::boxes};
  for (std::size_t i = 0; i < target.frequency.size(); ++i) {
    residual.x.push_back(target.frequency[i]);
    residual.y.push_back(100.0 * (modelAt(result, target.frequency[i]) - target.density[i]) /
                         highest);
  }
  page.figure(
      svgOf("Residual in each band", {"frequency, Hz", false, target.lowest(), target.highest()},
            {"% of the largest density"}, {residual}),
      "Fit less target in each of the target's bins.");
}

void addOctaves(const FitResult& result, HtmlPage& page) {
  BarPlot bars{"Octaves", {"standard deviation, m", false, 0.0}, {}, {}};
  for (const Octave& octave : result.fit.octaves) {
    const OctaveEntry entry = entryOf(octave, result.options.depth);
    bars.names.push_back(entry.frequency ? number(*entry.frequency, 3) + " Hz"
                                         : number(*entry.latticeSize, 1) + " m");
    bars.values.push_back(octave.standardDeviation);
  }
  page.heading("Octaves");
  page.figure(svgOf(bars),
              "Standard deviation of the height of each octave; group octaves by "
              "frequency, Perlin octaves by lattice size.");
}

/// Compass directions made continuous about a middle one, so that north does not cut a curve.
std::vector<double> unwrapped(const std::vector<DirectionalMoments>& moments,
                              const std::vector<double>& density, double floor, double middle) {
  std::vector<double> result;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const bool known = moments[i].hasFirst() && density[i] > floor;
    const double from = compassFromFromToward(moments[i].meanDirection());
    result.push_back(known ? middle + std::remainder(from - middle, 360.0) : std::nan(""));
  }
  return result;
}

std::vector<double> spreads(const std::vector<DirectionalMoments>& moments,
                            const std::vector<double>& density, double floor) {
  std::vector<double> result;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const bool known = moments[i].hasFirst() && density[i] > floor;
    result.push_back(known ? degreesFromRadians(moments[i].spread()) : std::nan(""));
  }
  return result;
}

void addDirections(const FitResult& result, HtmlPage& page) {
  const DirectionalSpectrum& target = result.source.spectrum;
  const DirectionalSpectrum& model = result.fit.model;
  const auto peak = static_cast<std::size_t>(
      std::max_element(target.energy.density.begin(), target.energy.density.end()) -
      target.energy.density.begin());
  const double floor = 0.01 * target.energy.density[peak];
  double middle = compassFromFromToward(target.moments[peak].meanDirection());
  if (!std::isfinite(middle)) middle = 180.0;
  std::vector<Curve> directions, widths;
  const auto add = [&](const char* label, const FrequencySpectrum& energy,
                       const std::vector<DirectionalMoments>& moments, CurveStyle style) {
    directions.push_back(
        {label, energy.frequency, unwrapped(moments, energy.density, floor, middle), style});
    widths.push_back({label, energy.frequency, spreads(moments, energy.density, floor), style});
  };
  add("target", target.energy, target.moments, CurveStyle::line);
  add("fit", model.energy, model.moments, CurveStyle::dashed);
  if (result.verification) {
    const BuoyAnalysis& buoy = result.verification->analysis;
    add("buoy in the fitted field", buoy.spectrum, buoy.directions, CurveStyle::points);
  }
  page.heading("Directions");
  const Axis frequency{"frequency, Hz", false, target.energy.lowest(), target.energy.highest()};
  page.figure(svgOf("Mean direction", frequency, {"from, deg clockwise from north"}, directions),
              "Where the density is above 1 % of its largest.");
  page.figure(svgOf("Directional spread", frequency, {"√(2(1 − r₁)), deg", false, 0.0}, widths),
              "Where the density is above 1 % of its largest.");
}

/// Compass directions that waves come from, every 5°, and the rings of a polar map.
void addPolar(const FitResult& result, HtmlPage& page) {
  constexpr std::size_t directions = 72, rings = 48;
  const FrequencySpectrum& target = result.source.spectrum.energy;
  const double peak = 1.0 / std::max(result.fit.summary.tpTarget, 1e-6);
  const double outer = std::min(target.highest(), 2.5 * peak);
  PolarMap map{"Fitted directional spectrum",
               "E(f, θ), m²/Hz/rad",
               "rings: frequency, Hz; waves "
               "from",
               {},
               {},
               {}};
  for (std::size_t r = 0; r < rings; ++r) {
    map.radius.push_back(target.lowest() + (outer - target.lowest()) * static_cast<double>(r) /
                                               static_cast<double>(rings - 1));
  }
  const FieldReading field =
      readField(result.fit.octaves, map.radius, directions, result.options.depth);
  const double step = 360.0 / static_cast<double>(directions);
  for (std::size_t d = 0; d < directions; ++d) {
    map.direction_deg.push_back(step * static_cast<double>(d));
  }
  for (std::size_t r = 0; r < rings; ++r) {
    for (std::size_t d = 0; d < directions; ++d) {
      // Waves from compass A go toward 270° − A; the grid's directions start east, 5° apart.
      const auto toward = static_cast<std::size_t>(
                              std::lround(compassWrapped(270.0 - map.direction_deg[d]) / step)) %
                          directions;
      map.value.push_back(field.spectrum.at(r, toward));
    }
  }
  page.figure(svgOf(map),
              "The fitted field's energy over frequency and the compass direction that "
              "waves come from, in closed form.");
}

void addProvenance(const FitResult& result, HtmlPage& page) {
  const FitProvenance provenance = seaStateOf(result).provenance;
  page.heading("Provenance");
  page.table({"", ""}, {{"spectrum", provenance.source},
                        {"record", provenance.recordTime.empty() ? "—" : provenance.recordTime},
                        {"model", provenance.model},
                        {"options", provenance.options}});
  for (const std::string& note : result.source.notes) page.paragraph("Reader: " + note);
}

}  // namespace

void writeFitReport(const FitResult& result, const std::filesystem::path& folder) {
  HtmlPage page("Seaway fit: " + std::filesystem::path(result.source.source).filename().string());
  page.paragraph(fmt::format("{}{} {} octaves; the fit is usable.", result.source.recordTime,
                             result.source.recordTime.empty() ? "" : ":",
                             result.fit.octaves.size()));
  addSummary(result, page);
  addVerification(result, page);
  addParameters(result, page);
  addSpectra(result, page);
  addResiduals(result, page);
  addOctaves(result, page);
  if (result.directional) addDirections(result, page);
  if (result.options.model == "group") addPolar(result, page);
  addProvenance(result, page);
  AtomicFile html(folder / "report.html");
  html.stream() << page.text();
  writeSeaState(folder / "sea.yaml", seaStateOf(result));
  html.commit();
}

}  // namespace seaway::bridge
