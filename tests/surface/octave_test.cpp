#include "surface/field/octave.h"

#include <gtest/gtest.h>

#include <cmath>

#include "surface/constants.h"
#include "surface/dispersion.h"
#include "surface/field/wave_field.h"

namespace seaway {
namespace {

TEST(Octave, AGroupOctaveHasTheBandwidthAskedAtAFixedPoint) {
  const Octave octave = makeGroupOctave(0.2, 0.125, 0.02, 0.0, 0.4);
  const double k = waveNumber(2.0 * pi * 0.125);
  EXPECT_DOUBLE_EQ(octave.waveNumber, k);
  EXPECT_DOUBLE_EQ(groupBandCycles * groupSpeed(k) / octave.lengthAlong, 0.02);
  EXPECT_DOUBLE_EQ(groupBandCycles * 2.0 * pi / octave.lengthAcross / k, 0.4);
  EXPECT_DOUBLE_EQ(dominantWavelength(octave), 2.0 * pi / k);
}

TEST(Octave, ARegularWavesStandardDeviationIsItsAmplitudeOverRootTwo) {
  EXPECT_DOUBLE_EQ(makeRegularWave(1.0, 0.1, 0.0).standardDeviation, std::sqrt(0.5));
}

TEST(Octave, MeanSquareSlopesAreThoseOfSampledSlopes) {
  for (const Octave& octave :
       {makePerlinOctave(0.3, 7.0, 0.5), makeGroupOctave(0.3, 0.4, 0.15, 0.5, 0.8),
        makeRegularWave(0.3, 0.4, 0.5)}) {
    const WaveField field({octave});
    double sum = 0.0;
    constexpr int side = 300;
    for (int y = 0; y < side; ++y) {
      std::vector<glm::dvec2> points;
      for (int x = 0; x < side; ++x) points.push_back({x * 2.7, y * 2.9});
      std::vector<SurfaceSample> samples(points.size());
      field.sample(points, 0.3 * y, samples);
      for (const SurfaceSample& sample : samples) sum += glm::dot(sample.slope, sample.slope);
    }
    // About 13 000 independent cells: sampling error near 1 %; 4 % is 4 of those deviations.
    EXPECT_NEAR(sum / (side * side) / meanSquareSlope(octave), 1.0, 0.04);
  }
}

}  // namespace
}  // namespace seaway
