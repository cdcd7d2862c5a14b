#include "surface/spectra/frequency_spectrum.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace seaway {
namespace {

/// Abscissa of the vertex of the parabola through three points, for a middle point that is highest.
double parabolaVertex(const double* x, const double* y) {
  const double left = (y[1] - y[0]) / (x[1] - x[0]);
  const double right = (y[2] - y[1]) / (x[2] - x[1]);
  const double curvature = (right - left) / (x[2] - x[0]);
  if (!(curvature < 0.0)) return x[1];
  return 0.5 * (x[0] + x[1]) - 0.5 * left / curvature;
}

}  // namespace

std::optional<std::string> FrequencySpectrum::validate() const {
  if (frequency.size() != density.size()) return "as many densities as frequencies are needed";
  if (frequency.size() < 2) return "at least 2 frequencies are needed";
  for (std::size_t i = 0; i < frequency.size(); ++i) {
    std::ostringstream problem;
    if (!(std::isfinite(frequency[i]) && frequency[i] > 0.0)) {
      problem << "frequency " << frequency[i] << " Hz is not allowed; must be > 0";
    } else if (i > 0 && !(frequency[i] > frequency[i - 1])) {
      problem << "frequency " << frequency[i] << " Hz does not rise above " << frequency[i - 1];
    } else if (!(std::isfinite(density[i]) && density[i] >= 0.0)) {
      problem << "density " << density[i] << " m²/Hz at " << frequency[i]
              << " Hz is not allowed; must be >= 0";
    }
    if (!problem.str().empty()) return problem.str();
  }
  return std::nullopt;
}

double FrequencySpectrum::at(double frequency_hz) const {
  if (!(frequency_hz >= lowest() && frequency_hz <= highest())) return 0.0;
  const auto above = std::upper_bound(frequency.begin(), frequency.end(), frequency_hz);
  if (above == frequency.end()) return density.back();
  const auto i = static_cast<std::size_t>(above - frequency.begin());
  const double fraction = (frequency_hz - frequency[i - 1]) / (frequency[i] - frequency[i - 1]);
  return density[i - 1] + fraction * (density[i] - density[i - 1]);
}

double FrequencySpectrum::moment(int n) const {
  double sum = 0.0;
  for (std::size_t i = 1; i < frequency.size(); ++i) {
    const double left = std::pow(frequency[i - 1], n) * density[i - 1];
    const double right = std::pow(frequency[i], n) * density[i];
    sum += 0.5 * (left + right) * (frequency[i] - frequency[i - 1]);
  }
  return sum;
}

double FrequencySpectrum::significantWaveHeight() const { return 4.0 * std::sqrt(moment(0)); }
double FrequencySpectrum::meanPeriodM01() const { return moment(0) / moment(1); }
double FrequencySpectrum::zeroCrossingPeriod() const { return std::sqrt(moment(0) / moment(2)); }
double FrequencySpectrum::energyPeriod() const { return moment(-1) / moment(0); }

double FrequencySpectrum::peakPeriod() const {
  const auto highestBin = std::max_element(density.begin(), density.end());
  if (highestBin == density.end() || !(*highestBin > 0.0)) return 0.0;
  const auto i = static_cast<std::size_t>(highestBin - density.begin());
  if (i == 0 || i + 1 == density.size()) return 1.0 / frequency[i];
  return 1.0 / parabolaVertex(&frequency[i - 1], &density[i - 1]);
}

}  // namespace seaway
