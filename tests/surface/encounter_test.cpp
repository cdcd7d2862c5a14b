#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "surface/constants.h"
#include "surface/dispersion.h"
#include "surface/fit/octave_fit.h"
#include "surface/parallel_sampling.h"
#include "surface/spectra/buoy_analysis.h"
#include "surface/spectra/families.h"

/// What a vessel in following seas meets, by its speed: `./test -R Encounter -V` prints the table.
namespace seaway {
namespace {

constexpr double step = 0.5;           // s
constexpr std::size_t samples = 2400;  // 20 min a run
constexpr std::size_t runCount = 96;   // 2 km apart, beyond any crest: independent

/// Runs along +x at `speed` through a long-crested sea that goes the same way.
struct Runs {
  double variance = 0.0;       // mean over runs, m²
  double rateVariance = 0.0;   // of dη/dt on board, m²/s²
  double scatterOfHm0 = 0.0;   // coefficient of variation of H_m0 between runs
  FrequencySpectrum spectrum;  // by encounter frequency, mean over runs
};

Runs sail(const WaveField& field, double speed) {
  std::vector<glm::dvec2> lanes(runCount);
  std::vector<BuoyRecord> records(runCount);
  std::vector<SurfaceSample> out(runCount);
  Runs result;
  for (std::size_t n = 0; n < samples; ++n) {
    const double t = step * static_cast<double>(n);
    for (std::size_t i = 0; i < runCount; ++i) {
      lanes[i] = {speed * t + 700.0 * static_cast<double>(i), 2000.0 * static_cast<double>(i)};
    }
    field.sample(lanes, t, out);
    for (std::size_t i = 0; i < runCount; ++i) {
      records[i].heave.push_back(out[i].height);
      records[i].slopeEast.push_back(out[i].slope.x);
      records[i].slopeNorth.push_back(out[i].slope.y);
      const double rate = out[i].verticalVelocity + speed * out[i].slope.x;
      result.rateVariance += rate * rate / static_cast<double>(samples * runCount);
    }
  }
  double sum = 0.0, squares = 0.0;
  for (BuoyRecord& record : records) {
    record.timeStep = step;
    double variance = 0.0;
    for (const double h : record.heave) variance += h * h / static_cast<double>(samples);
    result.variance += variance / runCount;
    sum += std::sqrt(variance) / runCount;
    squares += variance / runCount;
    const FrequencySpectrum one = analyseBuoy(record, {.segment = 300.0}).spectrum;
    if (result.spectrum.frequency.empty()) {
      result.spectrum = {one.frequency, std::vector<double>(one.frequency.size(), 0.0)};
    }
    for (std::size_t b = 0; b < one.density.size(); ++b) {
      result.spectrum.density[b] += one.density[b] / runCount;
    }
  }
  result.scatterOfHm0 = std::sqrt(std::max(0.0, squares / (sum * sum) - 1.0));
  return result;
}

/// What linear theory says: each frequency of the sea is met at |f − kU/2π|.
struct Expected {
  double variance = 0.0, rateVariance = 0.0;
  std::vector<double> bands;  // variance by encounter frequency, bands of `width` Hz
};
constexpr double width = 0.04;
constexpr std::size_t bandCount = 12;

/// `sea` is what a buoy reads in the field: the fit's own residual is not what is looked at here.
Expected theory(const FrequencySpectrum& sea, double speed) {
  Expected result{0.0, 0.0, std::vector<double>(bandCount, 0.0)};
  constexpr int count = 20000;
  const double df = (sea.highest() - sea.lowest()) / count;
  for (int i = 0; i < count; ++i) {
    const double f = sea.lowest() + (i + 0.5) * df;
    const double met = std::abs(f - waveNumber(2.0 * pi * f) * speed / (2.0 * pi));
    const double part = sea.at(f) * df;
    result.variance += part;
    result.rateVariance += part * std::pow(2.0 * pi * met, 2);
    const auto band = static_cast<std::size_t>(met / width);
    if (band < bandCount) result.bands[band] += part;
  }
  return result;
}

std::vector<double> bandsOf(const FrequencySpectrum& spectrum) {
  std::vector<double> bands(bandCount, 0.0);
  const double df = spectrum.frequency[1] - spectrum.frequency[0];
  for (std::size_t i = 0; i < spectrum.frequency.size(); ++i) {
    const auto band = static_cast<std::size_t>(spectrum.frequency[i] / width);
    if (band < bandCount) bands[band] += spectrum.density[i] * df;
  }
  return bands;
}

TEST(EncounterHard, AVesselMeetsTheSeaThatLinearTheorySays) {
  OctaveFitOptions options;
  options.octaves = 24;
  const OctaveFit fit = fitGroupOctaves(jonswap({1.12, 5.6, 3.3}), options);
  const FrequencySpectrum& sea = fit.model.energy;
  const WaveField field(fit.octaves, {.seed = 7});
  const double peak = 2.0 * pi / 5.6, groups = groupSpeed(waveNumber(peak));
  std::printf("speed/c_g  H_m0, m  rate rms/theory  largest band error/m0  scatter of H_m0\n");
  double scatterAtRest = 0.0;
  for (const double part : {0.0, 0.5, 1.0, 2.0}) {
    const Runs runs = sail(field, part * groups);
    const Expected expected = theory(sea, part * groups);
    const double rate = std::sqrt(runs.rateVariance / expected.rateVariance);
    const auto bands = bandsOf(runs.spectrum);
    double largest = 0.0;
    for (std::size_t b = 0; b < bandCount; ++b) {
      largest = std::max(largest, std::abs(bands[b] - expected.bands[b]) / expected.variance);
    }
    std::printf("%9.1f  %7.3f  %15.3f  %21.3f  %15.3f\n", part, 4.0 * std::sqrt(runs.variance),
                rate, largest, runs.scatterOfHm0);
    if (part == 0.0) scatterAtRest = runs.scatterOfHm0;
    // The mean over runs scatters by that of one run over √96.
    const double scatter = runs.scatterOfHm0 / std::sqrt(1.0 * runCount);
    EXPECT_NEAR(std::sqrt(runs.variance) / field.standardDeviation(), 1.0, 4.0 * scatter);
    // The fit's own residual leaves 2 % of the variance in the wrong band. Where the vessel outruns
    // half the groups an octave's band folds onto itself: right to first order in its width only.
    EXPECT_NEAR(rate, 1.0, 0.03 + 4.0 * scatter);
    EXPECT_LT(largest, part < 1.0 ? 0.03 : 0.13);
    EXPECT_LT(runs.scatterOfHm0, 8.0 * scatterAtRest);
  }
}

}  // namespace
}  // namespace seaway
