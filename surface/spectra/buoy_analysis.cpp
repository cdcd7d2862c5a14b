#include "surface/spectra/buoy_analysis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numeric>
#include <span>
#include <sstream>

#include "surface/constants.h"
#include "surface/fft/real_fft.h"
#include "surface/input_error.h"

namespace seaway {
namespace {

constexpr std::size_t fewestSamples = 8;

/// Co- and quad-spectra of heave (1), slope east (2) and slope north (3), one-sided.
struct CrossSpectra {
  double c11 = 0.0, c22 = 0.0, c33 = 0.0, c23 = 0.0, q12 = 0.0, q13 = 0.0;
};

void requireSound(const BuoyRecord& record) {
  if (!(record.timeStep > 0.0) || !std::isfinite(record.timeStep)) {
    throw InputError("a buoy record's time step must be > 0 s");
  }
  const std::size_t size = record.heave.size();
  if (record.slopeEast.size() != size || record.slopeNorth.size() != size) {
    throw InputError("a buoy record needs as many slopes as heaves");
  }
  const auto finite = [](double value) { return std::isfinite(value); };
  for (const auto* series : {&record.heave, &record.slopeEast, &record.slopeNorth}) {
    if (!std::all_of(series->begin(), series->end(), finite)) {
      throw InputError("a buoy record holds a value that is not finite");
    }
  }
}

std::size_t segmentSamples(const BuoyRecord& record, double segment) {
  // The margin takes back the rounding of lengths that are whole multiples of the step.
  const double pairs = std::floor(segment / record.timeStep / 2.0 + 1e-6);
  if (2.0 * pairs >= fewestSamples && 2.0 * pairs <= static_cast<double>(record.heave.size())) {
    return 2 * static_cast<std::size_t>(pairs);
  }
  std::ostringstream message;
  message << "a segment of " << segment << " s is not allowed; must be in ["
          << static_cast<double>(fewestSamples) * record.timeStep << ", " << record.duration()
          << "] s: " << fewestSamples << " samples or more, no longer than the record";
  throw InputError(message.str());
}

std::vector<double> hannWindow(std::size_t size) {
  std::vector<double> window(size);
  for (std::size_t i = 0; i < size; ++i) {
    window[i] = 0.5 - 0.5 * std::cos(2.0 * pi * static_cast<double>(i) / static_cast<double>(size));
  }
  return window;
}

/// Transforms of one windowed segment at a time.
class Segmenter {
 public:
  explicit Segmenter(std::size_t size) : fft_(size), window_(hannWindow(size)), windowed_(size) {}

  double windowPower() const {
    return std::inner_product(window_.begin(), window_.end(), window_.begin(), 0.0);
  }
  std::size_t bins() const { return fft_.bins(); }

  void transform(std::span<const double> segment, std::span<std::complex<double>> out) {
    const double mean =
        std::accumulate(segment.begin(), segment.end(), 0.0) / static_cast<double>(segment.size());
    for (std::size_t i = 0; i < segment.size(); ++i) {
      windowed_[i] = window_[i] * (segment[i] - mean);
    }
    fft_.forward(windowed_, out);
  }

 private:
  RealFft fft_;
  std::vector<double> window_;
  std::vector<double> windowed_;
};

/// Mean over all segments; bins from 1, the lowest above zero, to size/2.
std::vector<CrossSpectra> welch(const BuoyRecord& record, std::size_t size, std::size_t segments) {
  Segmenter segmenter(size);
  std::array<std::vector<std::complex<double>>, 3> bins;
  for (auto& series : bins) series.resize(segmenter.bins());
  std::vector<CrossSpectra> spectra(size / 2);
  const double scale = record.timeStep / segmenter.windowPower() / static_cast<double>(segments);
  for (std::size_t segment = 0; segment < segments; ++segment) {
    const std::size_t first = segment * (size / 2);
    segmenter.transform(std::span(record.heave).subspan(first, size), bins[0]);
    segmenter.transform(std::span(record.slopeEast).subspan(first, size), bins[1]);
    segmenter.transform(std::span(record.slopeNorth).subspan(first, size), bins[2]);
    for (std::size_t m = 1; m <= size / 2; ++m) {
      const double sides = m == size / 2 ? 1.0 : 2.0;  // the Nyquist bin has no mirror image
      const std::complex<double> heave = bins[0][m], east = bins[1][m], north = bins[2][m];
      CrossSpectra& sum = spectra[m - 1];
      sum.c11 += sides * scale * std::norm(heave);
      sum.c22 += sides * scale * std::norm(east);
      sum.c33 += sides * scale * std::norm(north);
      sum.c23 += sides * scale * std::real(std::conj(east) * north);
      sum.q12 -= sides * scale * std::imag(std::conj(heave) * east);
      sum.q13 -= sides * scale * std::imag(std::conj(heave) * north);
    }
  }
  return spectra;
}

DirectionalMoments momentsOf(const CrossSpectra& s) {
  const double slopes = s.c22 + s.c33;
  const double mixed = std::sqrt(s.c11 * slopes);
  return {s.q12 / mixed, s.q13 / mixed, (s.c22 - s.c33) / slopes, 2.0 * s.c23 / slopes};
}

DirectionalMoments weightedMean(const std::vector<DirectionalMoments>& directions,
                                const std::vector<double>& weights) {
  DirectionalMoments sum{0.0, 0.0, 0.0, 0.0};
  double total = 0.0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const DirectionalMoments& d = directions[i];
    if (!(weights[i] > 0.0) || !std::isfinite(d.a1 + d.b1 + d.a2 + d.b2)) continue;
    sum.a1 += weights[i] * d.a1;
    sum.b1 += weights[i] * d.b1;
    sum.a2 += weights[i] * d.a2;
    sum.b2 += weights[i] * d.b2;
    total += weights[i];
  }
  return {sum.a1 / total, sum.b1 / total, sum.a2 / total, sum.b2 / total};
}

void describeDirections(const std::vector<CrossSpectra>& spectra, BuoyAnalysis& result) {
  for (const CrossSpectra& bin : spectra) {
    result.directions.push_back(momentsOf(bin));
    result.waveNumber.push_back(std::sqrt((bin.c22 + bin.c33) / bin.c11));
  }
  const std::vector<double>& density = result.spectrum.density;
  const auto highest = std::max_element(density.begin(), density.end());
  result.peak = result.directions[static_cast<std::size_t>(highest - density.begin())];
  result.overall = weightedMean(result.directions, density);
}

void describeHeights(double duration, BuoyAnalysis& result) {
  const FrequencySpectrum& spectrum = result.spectrum;
  const double width = 1.0 / result.segment;
  double m0 = 0.0, m2 = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < spectrum.density.size(); ++i) {
    const double density = spectrum.density[i], frequency = spectrum.frequency[i];
    m0 += density * width;
    m2 += frequency * frequency * density * width;
    squares += density * density * width;
  }
  result.significantWaveHeight = 4.0 * std::sqrt(m0);
  result.zeroCrossingPeriod = std::sqrt(m0 / m2);
  const double peakPeriod = spectrum.peakPeriod();
  result.peakPeriod = peakPeriod > 0.0 ? peakPeriod : std::nan("");
  // The mean square of a density estimate is 1 + 2/ν times the square of the density.
  squares /= 1.0 + 2.0 / result.degreesOfFreedom;
  result.significantWaveHeightError =
      m0 > 0.0 ? 0.5 * result.significantWaveHeight * std::sqrt(squares / duration) / m0 : 0.0;
}

void describeDistribution(const std::vector<double>& heave, BuoyAnalysis& result) {
  const auto count = static_cast<double>(heave.size());
  const double mean = std::accumulate(heave.begin(), heave.end(), 0.0) / count;
  double second = 0.0, third = 0.0, fourth = 0.0;
  for (const double height : heave) {
    const double offset = height - mean, square = offset * offset;
    second += square / count;
    third += offset * square / count;
    fourth += square * square / count;
  }
  result.skewness = third / std::pow(second, 1.5);
  result.kurtosis = fourth / (second * second);
}

}  // namespace

BuoyAnalysis analyseBuoy(const BuoyRecord& record, const BuoyAnalysisOptions& options) {
  requireSound(record);
  const std::size_t size = segmentSamples(record, options.segment);
  BuoyAnalysis result;
  result.segment = static_cast<double>(size) * record.timeStep;
  result.segments = (record.heave.size() - size) / (size / 2) + 1;
  const auto count = static_cast<double>(result.segments);
  // Half-overlapping Hann windows correlate by 1/6 (Welch 1967).
  result.degreesOfFreedom = 2.0 * count / (1.0 + (count - 1.0) / (18.0 * count));
  const std::vector<CrossSpectra> spectra = welch(record, size, result.segments);
  for (std::size_t i = 0; i < spectra.size(); ++i) {
    result.spectrum.frequency.push_back(static_cast<double>(i + 1) / result.segment);
    result.spectrum.density.push_back(spectra[i].c11);
  }
  describeDirections(spectra, result);
  describeHeights(record.duration(), result);
  describeDistribution(record.heave, result);
  return result;
}

}  // namespace seaway
