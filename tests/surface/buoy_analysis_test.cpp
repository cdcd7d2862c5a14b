#include "surface/spectra/buoy_analysis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "surface/angles.h"
#include "surface/constants.h"
#include "surface/field/wave_field.h"
#include "surface/input_error.h"

namespace seaway {
namespace {

constexpr double timeStep = 0.5;
constexpr double binWidth = 1.0 / 256.0;  // Hz, of the default segment

/// A regular wave as a buoy meets it: η = a cos(k·x − ωt + phase) at x = 0, with its slopes.
struct Wave {
  double amplitude, frequency, toward, phase = 0.0;
};

BuoyRecord recordOf(const std::vector<Wave>& waves, std::size_t samples = 8192) {
  BuoyRecord record{timeStep, std::vector<double>(samples), std::vector<double>(samples),
                    std::vector<double>(samples)};
  for (const Wave& wave : waves) {
    const double omega = 2.0 * pi * wave.frequency;
    const double k = omega * omega / standardGravity;
    for (std::size_t i = 0; i < samples; ++i) {
      const double angle = wave.phase - omega * timeStep * static_cast<double>(i);
      record.heave[i] += wave.amplitude * std::cos(angle);
      record.slopeEast[i] -= wave.amplitude * k * std::cos(wave.toward) * std::sin(angle);
      record.slopeNorth[i] -= wave.amplitude * k * std::sin(wave.toward) * std::sin(angle);
    }
  }
  return record;
}

double standardDeviation(const std::vector<double>& values) {
  double sum = 0.0, squares = 0.0;
  for (const double value : values) {
    sum += value;
    squares += value * value;
  }
  const auto count = static_cast<double>(values.size());
  return std::sqrt(squares / count - sum * sum / count / count);
}

TEST(BuoyAnalysis, ReadsARegularWavesHeightPeriodAndDirection) {
  for (const double toward_deg : {0.0, 37.0, 90.0, 135.0, 180.0, -74.0}) {
    const double frequency = 32.0 * binWidth;  // on a bin: Hann's three bins hold all of it
    const auto sea = analyseBuoy(recordOf({{0.8, frequency, radiansFromDegrees(toward_deg), 0.3}}));
    // Closed forms: m₀ = a²/2, one frequency, one direction; rounding of 512-point sums.
    EXPECT_NEAR(sea.significantWaveHeight, 4.0 * 0.8 / std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(sea.peakPeriod, 1.0 / frequency, 1e-9);
    for (const DirectionalMoments& direction : {sea.peak, sea.overall}) {
      EXPECT_NEAR(
          std::remainder(direction.meanDirection() - radiansFromDegrees(toward_deg), 2.0 * pi), 0.0,
          1e-9);
      EXPECT_NEAR(direction.spread(), 0.0, 1e-6);  // √ of the rounding of r₁
      EXPECT_NEAR(direction.a2, std::cos(2.0 * radiansFromDegrees(toward_deg)), 1e-9);
      EXPECT_NEAR(direction.b2, std::sin(2.0 * radiansFromDegrees(toward_deg)), 1e-9);
    }
    EXPECT_NEAR(sea.waveNumber[31] * standardGravity, std::pow(2.0 * pi * frequency, 2), 1e-9);
    EXPECT_NEAR(sea.kurtosis, 1.5, 1e-9);  // of a sine
    EXPECT_NEAR(sea.skewness, 0.0, 1e-9);
    // Hann spreads the line over f ± Δf, 1/6 of the energy each: m₂/m₀ = f² + Δf²/3.
    EXPECT_NEAR(sea.zeroCrossingPeriod,
                1.0 / std::sqrt(frequency * frequency + binWidth * binWidth / 3.0), 1e-9);
  }
}

TEST(BuoyAnalysis, ReadsTheDirectionOfAWaveOfTheField) {
  for (const double from_deg : {16.0, 106.0, 196.0, 286.0}) {
    const double toward = towardFromCompassFrom(from_deg);
    const WaveField field({makeRegularWave(0.5, 0.18, toward)});
    BuoyRecord record;
    for (int i = 0; i < 4096; ++i) {
      const SurfaceSample sample = field.at(timeStep * i).sample(glm::dvec2(120.0, -40.0));
      record.heave.push_back(sample.height);
      record.slopeEast.push_back(sample.slope.x);
      record.slopeNorth.push_back(sample.slope.y);
    }
    const BuoyAnalysis sea = analyseBuoy(record);
    EXPECT_NEAR(compassFromFromToward(sea.peak.meanDirection()), from_deg,
                0.01);  // float samples, leakage
    EXPECT_NEAR(sea.significantWaveHeight, 2.0 * std::sqrt(2.0) * 0.5, 1e-3);  // leakage off a bin
  }
}

TEST(BuoyAnalysis, TellsTwoCrossingWavesOfDifferentFrequencyApart) {
  const double swell = 20.0 * binWidth, windSea = 50.0 * binWidth;
  const auto sea = analyseBuoy(recordOf({{1.0, swell, 0.0}, {0.5, windSea, pi / 2.0}}));
  EXPECT_NEAR(sea.directions[19].meanDirection(), 0.0, 1e-9);
  EXPECT_NEAR(sea.directions[49].meanDirection(), pi / 2.0, 1e-9);
  EXPECT_NEAR(sea.peakPeriod, 1.0 / swell, 1e-9);
  // Energies 4 : 1. Overall a₁ = 4/5, b₁ = 1/5; rounding in the empty bins.
  EXPECT_NEAR(sea.overall.meanDirection(), std::atan2(0.2, 0.8), 1e-9);
  EXPECT_NEAR(sea.overall.spread(), std::sqrt(2.0 * (1.0 - std::sqrt(0.68))), 1e-9);
}

TEST(BuoyAnalysis, SpreadsTwoCrossingWavesOfOneBinAboutTheirMean) {
  // A beat of 16 384 s, which the record holds whole: phases pass through all differences.
  const double frequency = 32.0 * binWidth, beat = 1.0 / 16384.0;
  const auto sea = analyseBuoy(
      recordOf({{0.5, frequency, pi / 4.0}, {0.5, frequency + beat, -pi / 4.0}}, 32768));
  // Ends of the record are weighted less than its middle: one segment in 127.
  EXPECT_NEAR(sea.peak.a1, std::cos(pi / 4.0), 0.02);
  EXPECT_NEAR(sea.peak.b1, 0.0, 0.02);
  EXPECT_NEAR(sea.peak.a2, 0.0, 0.02);
  EXPECT_NEAR(sea.peak.b2, 0.0, 0.02);
}

BuoyRecord whiteNoise(double sigma, std::size_t samples) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal(0.0, sigma);
  BuoyRecord record;
  for (std::size_t i = 0; i < samples; ++i) {
    record.heave.push_back(normal(random));
    record.slopeEast.push_back(normal(random));
    record.slopeNorth.push_back(normal(random));
  }
  return record;
}

TEST(BuoyAnalysis, WhiteNoiseHasTheLevelOfItsVarianceOverTheNyquistFrequency) {
  const BuoyAnalysis sea = analyseBuoy(whiteNoise(0.3, 200000));
  const double level = 2.0 * 0.3 * 0.3 * timeStep;
  double mean = 0.0, scatter = 0.0;
  // The lowest bins lose to the removed mean, the last has no mirror image.
  const std::size_t first = 2, last = sea.spectrum.density.size() - 2;
  const auto count = static_cast<double>(last - first + 1);
  for (std::size_t i = first; i <= last; ++i) mean += sea.spectrum.density[i] / count;
  for (std::size_t i = first; i <= last; ++i) {
    scatter += std::pow(sea.spectrum.density[i] / mean - 1.0, 2) / count;
  }
  EXPECT_NEAR(mean / level, 1.0, 0.015);  // 200 000 values: √(2/200 000) = 0.3 %
  // Var S/S² = 2/ν; 250 bins, neighbours correlated: 15 %.
  EXPECT_NEAR(scatter * sea.degreesOfFreedom / 2.0, 1.0, 0.3);
  EXPECT_NEAR(sea.kurtosis, 3.0, 0.04);  // 3.6 √(24/200 000)
  EXPECT_NEAR(sea.overall.a1, 0.0, 0.01);
}

TEST(BuoyAnalysis, HoldsTheRecordsVariance) {
  std::vector<Wave> waves;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  // Lines four bins apart share no bin under Hann; on bins nothing leaks.
  for (int line = 10; line < 200; line += 4) {
    waves.push_back(
        {0.1 * uniform(random), line * binWidth, 6.28 * uniform(random), 6.28 * uniform(random)});
  }
  BuoyRecord record = recordOf(waves);
  for (double& height : record.heave) height += 5.0;  // the mean does not count
  EXPECT_NEAR(analyseBuoy(record).significantWaveHeight, 4.0 * standardDeviation(record.heave),
              1e-10);
  const BuoyRecord noise = whiteNoise(1.0, 100000);
  // Bins 0 and 1 lose 1.5 of 256 to the mean, half as much in height, and the ends count less.
  EXPECT_NEAR(analyseBuoy(noise).significantWaveHeight / (4.0 * standardDeviation(noise.heave)),
              1.0, 0.005);
}

TEST(BuoyAnalysis, StatesTheScatterOfWaveHeightsOfRecordsOfItsLength) {
  // Noise smoothed over 8 samples, a sea of bandwidth a few bins wide or more.
  const BuoyRecord noise = whiteNoise(1.0, 400000);
  BuoyRecord smooth = noise;
  for (std::size_t i = 8; i < noise.heave.size(); ++i) {
    for (std::size_t j = 1; j < 8; ++j) smooth.heave[i] += noise.heave[i - j];
  }
  std::vector<double> heights;
  double stated = 0.0;
  constexpr std::size_t length = 4000, records = 99;
  for (std::size_t r = 1; r <= records; ++r) {
    const auto part = [&](const std::vector<double>& series) {
      const auto first = series.begin() + static_cast<std::ptrdiff_t>(r * length);
      return std::vector<double>(first, first + length);
    };
    const auto sea = analyseBuoy(
        {timeStep, part(smooth.heave), part(smooth.slopeEast), part(smooth.slopeNorth)});
    heights.push_back(sea.significantWaveHeight);
    stated += sea.significantWaveHeightError / records;
  }
  // The scatter of 99 heights is itself known to 7 %; half-weighted ends of 32 segments add 3 %.
  EXPECT_NEAR(standardDeviation(heights) / stated, 1.0, 0.22);
}

TEST(BuoyAnalysisHard, FlatWaterHasNoHeightAndNoDirection) {
  const BuoyAnalysis sea = analyseBuoy(recordOf({}));
  EXPECT_EQ(sea.significantWaveHeight, 0.0);
  EXPECT_EQ(sea.significantWaveHeightError, 0.0);
  for (const double undefined :
       {sea.peakPeriod, sea.zeroCrossingPeriod, sea.kurtosis, sea.skewness,
        sea.overall.meanDirection(), sea.overall.spread(), sea.peak.meanDirection()}) {
    EXPECT_TRUE(std::isnan(undefined));
  }
}

TEST(BuoyAnalysisHard, RecordsThatCannotBeReadAreRefused) {
  const BuoyRecord sound = recordOf({{1.0, 0.1, 0.0}}, 600);
  EXPECT_NO_THROW(analyseBuoy(sound, {.segment = 300.0}));
  const double nan = std::nan("");
  for (const double segment : {300.6 + timeStep, 3.9, 0.0, -256.0, nan, HUGE_VAL}) {
    EXPECT_THROW(analyseBuoy(sound, {.segment = segment}), InputError) << segment;
  }
  const std::vector<std::function<void(BuoyRecord&)>> faults = {
      [](BuoyRecord& record) { record.slopeEast.pop_back(); },
      [&](BuoyRecord& record) { record.slopeNorth[17] = nan; },
      [](BuoyRecord& record) { record.timeStep = 0.0; }, [](BuoyRecord& record) { record = {}; }};
  for (const auto& spoil : faults) {
    BuoyRecord record = sound;
    spoil(record);
    EXPECT_THROW(analyseBuoy(record), InputError);
  }
}

}  // namespace
}  // namespace seaway
