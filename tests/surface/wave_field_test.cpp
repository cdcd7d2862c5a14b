#include "surface/field/wave_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "surface/fit/octave_fit.h"
#include "surface/input_error.h"
#include "surface/spectra/families.h"
#include "surface/water_surface.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/random_points.h"

namespace seaway {
namespace {

using test_support::randomPoints;

WaveField makeField(double height = 1.12, std::uint64_t seed = 7) {
  return WaveField(fitPerlinOctaves(jonswap({height, 5.6, 3.3})).octaves, {.seed = seed});
}

TEST(WaveField, RealisesTheWaveHeightAsked) {
  const WaveField field = makeField();
  EXPECT_NEAR(field.significantWaveHeight(), 1.12, 1e-9);
  double squares = 0.0;
  const auto points = randomPoints(40000, 50e3);
  std::vector<SurfaceSample> samples(points.size());
  for (const double t : {0.0, 100.3, 5000.7}) {
    field.sample(points, t, samples);
    for (const SurfaceSample& sample : samples) squares += sample.height * sample.height / 120000.0;
  }
  EXPECT_NEAR(4.0 * std::sqrt(squares), 1.12, 0.02 * 1.12);  // issue: 2 %; sampling error 0.2 %
}

TEST(WaveField, GivesTheSameBitsForAnyBatch) {
  const WaveField field = makeField();
  const auto points = randomPoints(1000, 1e4);
  std::vector<SurfaceSample> whole(points.size()), part(points.size());
  field.sample(points, 12.5, whole);
  for (const std::size_t batch : {1u, 3u, 64u, 999u}) {
    for (std::size_t i = 0; i < points.size(); i += batch) {
      const std::size_t n = std::min(batch, points.size() - i);
      field.sample(std::span(points).subspan(i, n), 12.5, std::span(part).subspan(i, n));
    }
    EXPECT_EQ(std::memcmp(whole.data(), part.data(), whole.size() * sizeof(SurfaceSample)), 0)
        << batch;
  }
}

TEST(WaveField, LeftOutOctavesAreReportedAndTheErrorIsAsStated) {
  const WaveField field = makeField();
  const auto points = randomPoints(20000, 20e3);
  std::vector<SurfaceSample> exact(points.size()), rough(points.size());
  field.sample(points, 3.0, exact);
  for (const double tolerance : {0.03, 0.08, 0.15}) {
    field.sample(points, 3.0, rough, {.tolerance = tolerance});
    double squares = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      squares +=
          std::pow(rough[i].height - exact[i].height, 2) / static_cast<double>(points.size());
    }
    EXPECT_LE(rough[0].error, tolerance);
    EXPECT_TRUE(has(rough[0].status, SampleStatus::truncated));
    EXPECT_NEAR(std::sqrt(squares) / rough[0].error, 1.0, 0.05);  // 20 000 samples, several a cell
  }
}

TEST(WaveField, WithoutAToleranceNothingIsLeftOut) {
  const WaveField field = makeField();
  SurfaceSample sample;
  field.sample(std::vector<glm::dvec2>{{1.0, 2.0}}, 0.0, std::span(&sample, 1));
  EXPECT_EQ(sample.error, 0.0);
  EXPECT_EQ(statusText(sample.status), "ok");
  EXPECT_GT(sample.bound, 0.0);
  EXPECT_LT(sample.bound, 1e-5 * 1.12 + 2e-6);  // the kernels' float arithmetic
}

TEST(WaveField, AStillSeaIsFlatAndHoldsNoOctave) {
  const WaveField field({makePerlinOctave(0.0, 10.0, 0.0)});
  EXPECT_TRUE(field.octaves().empty());
  EXPECT_EQ(field.heightBound(), 0.0);
  SurfaceSample sample;
  field.sample(std::vector<glm::dvec2>{{1.0, 2.0}}, 0.0, std::span(&sample, 1));
  EXPECT_EQ(sample.height, 0.0);
  EXPECT_EQ(sample.normal(), glm::dvec3(0, 0, 1));
}

TEST(WaveField, SamplingAllocatesNothing) {
  const WaterSurface surface(makeField());
  const auto points = randomPoints(500, 1e3);
  std::vector<SurfaceSample> samples(points.size());
  const std::size_t before = test_support::allocationCount();
  surface.sample(points, 1.0, samples);
  surface.sample(points[0], 2.0, {.tolerance = 0.05});
  EXPECT_EQ(test_support::allocationCount(), before);
}

TEST(WaveField, SeedsGiveOtherSeasOfTheSameHeight) {
  const WaterSurface a(makeField(1.12, 1)), b(makeField(1.12, 2));
  EXPECT_NE(a.sample({10.0, 5.0}, 0.0).height, b.sample({10.0, 5.0}, 0.0).height);
  EXPECT_EQ(a.waves().significantWaveHeight(), b.waves().significantWaveHeight());
}

TEST(WaveField, WavesShorterThanACutOffAreLeftOutAndReported) {
  const WaveField field({makePerlinOctave(0.1, 30.0, 0.0), makePerlinOctave(0.3, 3.0, 0.0)});
  const WaveField longOnly({makePerlinOctave(0.1, 30.0, 0.0), makePerlinOctave(0.0, 3.0, 0.0)});
  const auto points = randomPoints(100, 1e3);
  std::vector<SurfaceSample> cut(points.size()), alone(points.size());
  field.sample(points, 2.0, cut, {.shortestWavelength = cutoffFor(80.0)});
  longOnly.sample(points, 2.0, alone);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(cut[i].height, alone[i].height);
  EXPECT_NEAR(cut[0].error, 0.3, 1e-12);
  EXPECT_TRUE(has(cut[0].status, SampleStatus::truncated));
}

TEST(WaveField, OrderOfOctavesDoesNotChangeTheirRank) {
  const WaveField field({makePerlinOctave(0.1, 10.0, 0.0), makePerlinOctave(0.3, 30.0, 0.0)});
  EXPECT_EQ(field.octaves()[0].standardDeviation, 0.3);
  EXPECT_EQ(field.octavesFor(0.1), 1u);
  EXPECT_EQ(field.octavesFor(0.0999), 2u);
  EXPECT_EQ(field.octavesFor(1.0), 0u);
}

TEST(WaveFieldHard, PointsThatAreNotFiniteHarmNobodyElse) {
  const WaveField field = makeField();
  const std::vector<glm::dvec2> points = {{1.0, 2.0}, {NAN, 0.0}, {INFINITY, 0.0}, {3.0, 4.0}};
  std::vector<SurfaceSample> samples(4);
  field.sample(points, 0.0, samples);
  for (const int bad : {1, 2}) {
    EXPECT_EQ(statusText(samples[bad].status), "not_finite");
    EXPECT_TRUE(std::isnan(samples[bad].height));
  }
  SurfaceSample alone;
  field.sample(std::span(points).subspan(3), 0.0, std::span(&alone, 1));
  EXPECT_EQ(alone.height, samples[3].height);
  field.sample(points, NAN, samples);
  EXPECT_EQ(statusText(samples[0].status), "not_finite");
}

TEST(WaveFieldHard, FarFromTheAnchorAndLateHeightsAreFiniteBoundedAndMoving) {
  const WaveField field = makeField();
  for (const double far : {1e5, 1e7, 1e8}) {
    for (const double t : {0.0, 1e7, 1e9}) {
      const std::vector<glm::dvec2> points = {{far, -far}, {far + 10.0, -far}};
      std::vector<SurfaceSample> samples(2);
      field.sample(points, t, samples);
      for (const SurfaceSample& sample : samples) {
        EXPECT_LT(std::abs(sample.height), field.heightBound());
        EXPECT_LT(sample.bound, 1e-4);  // doubles are spaced 1.5e-8 m at 1e8 m
      }
      EXPECT_NE(samples[0].height, samples[1].height);
    }
  }
}

TEST(WaveFieldHard, OctavesOutOfRangeAreRejectedByNumberAndName) {
  Octave bad = makePerlinOctave(0.1, 10.0, 0.0);
  bad.latticeSize = -10.0;
  try {
    WaveField field({makePerlinOctave(0.1, 10.0, 0.0), bad});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "octave 2: lattice size -10 is not allowed; must be > 0 m");
  }
  EXPECT_THROW(WaveField({}, {.depth = 0.0}), InputError);
  EXPECT_THROW(WaveField({}, {.current = {NAN, 0.0}}), InputError);
}

}  // namespace
}  // namespace seaway
