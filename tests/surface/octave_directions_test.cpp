#include "surface/fit/octave_directions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "surface/angles.h"
#include "surface/field/group_spectrum.h"
#include "surface/fit/octave_fit.h"
#include "surface/spectra/families.h"

namespace seaway {
namespace {

constexpr double mean = 1.3;  // rad, toward
constexpr int count = 24;

std::vector<Octave> sea(double exponent, double peakEnhancement = 3.3,
                        double depth = std::numeric_limits<double>::infinity()) {
  const OctaveFit fit = fitGroupOctaves(jonswap({1.12, 5.6, peakEnhancement}),
                                        {.octaves = octavesBeforeSpreading(count),
                                         .toward = mean,
                                         .directionalWidth = directionalWidthFor(exponent),
                                         .depth = depth});
  EXPECT_TRUE(fit.summary.usable);
  return spreadDirections(fit.octaves, exponent, count);
}

struct Moments {
  double density = 0.0;
  std::complex<double> first{0.0};  // of heave and slope, about `mean`

  double offset_deg() const { return degreesFromRadians(std::arg(first)); }
  double spread_deg() const {
    return degreesFromRadians(std::sqrt(2.0 * std::max(0.0, 1.0 - std::abs(first))));
  }
};

// What a buoy reads at a frequency, from the octaves' own spectra: ⟨k⊥²⟩/k² of an octave is what
// its mean-square slope has beyond the carrier's, its group being endless along the way.
Moments at(const std::vector<Octave>& octaves, double frequency, double depth) {
  Moments moments;
  double slopes = 0.0, carriers = 0.0;
  for (Octave octave : octaves) {
    const WaveBand band = bandOf(octave, depth);
    const double cells = groupBandCycles / band.bandwidth;
    const double density = octave.standardDeviation * octave.standardDeviation * cells *
                           groupEnvelopeDensity((frequency - band.frequency) * cells);
    octave.lengthAlong = std::numeric_limits<double>::infinity();
    octave.standardDeviation = 1.0;
    const double perCarrier = meanSquareSlope(octave) / (octave.waveNumber * octave.waveNumber);
    moments.density += density;
    moments.first += std::polar(density, octave.toward - mean);
    slopes += density * perCarrier;
    carriers += density;
  }
  moments.first /= moments.density * std::sqrt(slopes / carriers);
  return moments;
}

double spreadOf_deg(double exponent) {
  return degreesFromRadians(std::sqrt(2.0 / (exponent + 1.0)));
}

void expectMomentsByFrequency(double exponent, double peakEnhancement, double depth,
                              double spreadTolerance_deg) {
  const std::vector<Octave> octaves = sea(exponent, peakEnhancement, depth);
  double highest = 0.0;
  for (double f = 0.1; f < 0.5; f += 0.002) {
    highest = std::max(highest, at(octaves, f, depth).density);
  }
  for (double f = 0.1; f < 0.5; f += 0.002) {
    const Moments moments = at(octaves, f, depth);
    if (moments.density < 0.3 * highest) continue;
    EXPECT_NEAR(moments.offset_deg(), 0.0, 5.0) << f;  // asked of a buoy at the peak; here anywhere
    EXPECT_NEAR(moments.spread_deg(), spreadOf_deg(exponent), spreadTolerance_deg) << f;
  }
}

TEST(OctaveDirections, MeanAndSpreadAreRightAtEveryEnergeticFrequency) {
  const double deep = std::numeric_limits<double>::infinity();
  for (const double peakEnhancement : {1.0, 3.3, 7.0}) {
    SCOPED_TRACE(peakEnhancement);
    expectMomentsByFrequency(10.0, peakEnhancement, deep, 5.0);
    expectMomentsByFrequency(5.0, peakEnhancement, deep, 5.0);
    expectMomentsByFrequency(50.0, peakEnhancement, deep, 5.0);
  }
  expectMomentsByFrequency(10.0, 3.3, 3.0, 5.0);
}

TEST(OctaveDirections, ThePairsHaveTheFirstMomentAskedForAndTheSeaItsMeanDirection) {
  for (const double exponent : {0.5, 2.0, 10.0, 25.0}) {
    const std::vector<Octave> octaves = sea(exponent);
    std::complex<double> all{0.0};
    double pairs = 0.0, variance = 0.0;
    for (std::size_t i = 0; i < octaves.size(); ++i) {
      Octave octave = octaves[i];
      const double v = octave.standardDeviation * octave.standardDeviation;
      octave.lengthAlong = std::numeric_limits<double>::infinity();
      octave.standardDeviation = 1.0;
      const double own = octave.waveNumber / std::sqrt(meanSquareSlope(octave));
      all += std::polar(v * own, octave.toward - mean);
      const auto twin = [&](std::size_t j) {
        return j < octaves.size() && octaves[j].waveNumber == octave.waveNumber;
      };
      if (!twin(i + 1) && !(i > 0 && twin(i - 1))) continue;
      pairs += v * own * std::cos(octave.toward - mean);
      variance += v;
    }
    EXPECT_NEAR(pairs / variance, exponent / (exponent + 1.0), 1e-9) << exponent;
    // The lone ones, alternately left and right, leave less leaning than the largest one's share.
    EXPECT_NEAR(degreesFromRadians(std::arg(all)), 0.0, 1.5) << exponent;
  }
}

TEST(OctaveDirections, KeepsTheCountTheVarianceAndTheFrequencies) {
  const OctaveFit fit = fitGroupOctaves(jonswap({1.12, 5.6, 3.3}), {.octaves = 16});
  const std::vector<Octave> octaves = spreadDirections(fit.octaves, 10.0, count);
  ASSERT_EQ(octaves.size(), static_cast<std::size_t>(count));
  double before = 0.0, after = 0.0;
  for (const Octave& o : fit.octaves) before += o.standardDeviation * o.standardDeviation;
  for (const Octave& o : octaves) after += o.standardDeviation * o.standardDeviation;
  EXPECT_NEAR(after, before, 1e-14);
  EXPECT_TRUE(std::is_sorted(octaves.begin(), octaves.end(), [](const auto& a, const auto& b) {
    return a.waveNumber < b.waveNumber;
  }));
}

TEST(OctaveDirections, InfiniteExponentIsOneDirectionOfNarrowOctaves) {
  const double endless = std::numeric_limits<double>::infinity();
  for (const Octave& octave : sea(endless)) EXPECT_EQ(octave.toward, mean);
  EXPECT_EQ(directionalWidthFor(endless), 0.05);
  EXPECT_EQ(directionalWidthFor(10.0), 0.35);
  EXPECT_NEAR(directionalWidthFor(75.0), std::sqrt(2.0 / 76.0), 1e-12);
}

TEST(OctaveDirectionsHard, FewOctavesAreStillAnswered) {
  for (int wanted = 1; wanted <= 5; ++wanted) {
    const int fitted = octavesBeforeSpreading(wanted);
    std::vector<Octave> octaves;
    for (int i = 0; i < fitted; ++i)
      octaves.push_back(makeGroupOctave(0.1, 0.1 + 0.1 * i, 0.05, 0.0, 0.35));
    const auto spread = spreadDirections(octaves, 5.0, static_cast<std::size_t>(wanted));
    EXPECT_EQ(spread.size(), static_cast<std::size_t>(wanted));
    double across = 0.0;  // octaves of one variance balance
    for (const Octave& o : spread) {
      across += o.standardDeviation * o.standardDeviation * std::sin(o.toward);
    }
    EXPECT_NEAR(across, 0.0, 0.01 * 0.2) << wanted;  // but for the alternation
  }
  EXPECT_TRUE(spreadDirections({}, 10.0, 24).empty());
}

}  // namespace
}  // namespace seaway
