#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <random>
#include <string>

#include "surface/field/kernels/field_blocks.h"
#include "surface/field/wave_field.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/random_points.h"

/// The fast kernels against the double reference, on every instruction set this machine has.
namespace seaway {
namespace {

using test_support::randomPoints;

std::vector<Octave> octavesOf(OctaveKind kind, int count, double depth) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  std::vector<Octave> octaves;
  for (int i = 0; i < count; ++i) {
    const double f = 0.08 * std::pow(1.06, i), a = 0.05 + 0.003 * i, toward = uniform(random);
    if (kind == OctaveKind::group)
      octaves.push_back(makeGroupOctave(a, f, 0.15 * f, toward, 0.5, depth));
    if (kind == OctaveKind::perlin)
      octaves.push_back(makePerlinOctave(a, 0.9 / (f * f), toward, depth));
    if (kind == OctaveKind::regular)
      octaves.push_back(makeRegularWave(a, f, toward, uniform(random), depth));
  }
  return octaves;
}

std::vector<Octave> mixedOctaves(int count, double depth) {
  std::vector<Octave> octaves;
  for (const OctaveKind kind : {OctaveKind::group, OctaveKind::perlin, OctaveKind::regular}) {
    for (const Octave& octave : octavesOf(kind, count, depth)) octaves.push_back(octave);
  }
  return octaves;
}

class FieldKernels : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!forceKernelTarget(GetParam())) GTEST_SKIP() << "no " << GetParam() << " on this machine";
  }
  void TearDown() override { forceKernelTarget(""); }
};
using FieldKernelsHard = FieldKernels;

TEST_P(FieldKernelsHard, AgreeWithTheReferenceFarAwayAndLate) {
  for (const double depth : {5.0, 1e9}) {
    for (const OctaveKind kind : {OctaveKind::group, OctaveKind::perlin, OctaveKind::regular}) {
      const WaveField field(octavesOf(kind, 13, depth), {.depth = depth, .current = {0.5, -0.3}});
      for (const double reach : {1e3, 1e7, 1e8}) {
        for (const double t : {12.3, 1e7, 1e9}) {
          const auto points = randomPoints(300, reach);
          std::vector<SurfaceSample> fast(points.size()), truth(points.size());
          const SampleOptions options{.orbitalVelocity = true};
          field.sample(points, t, fast, options);
          field.sampleReference(points, t, truth, options);
          // Issue: 1e-5 H_m0 + 2e-6 m, and beyond that the spacing of doubles times the slope.
          const double spacing = std::nextafter(reach, INFINITY) - reach;
          const double allowed = 1e-5 * field.significantWaveHeight() + 2e-6 + 4.0 * spacing;
          double largest = 0.0;
          for (std::size_t i = 0; i < points.size(); ++i) {
            const double error = std::abs(fast[i].height - truth[i].height);
            largest = std::max(largest, error);
            EXPECT_LE(error, fast[i].bound);
            EXPECT_NEAR(fast[i].slope.x, truth[i].slope.x, allowed);
            EXPECT_NEAR(fast[i].verticalVelocity, truth[i].verticalVelocity, allowed);
            if (kind == OctaveKind::perlin) continue;
            EXPECT_NEAR(fast[i].orbitalVelocity.x, truth[i].orbitalVelocity.x, allowed);
            EXPECT_NEAR(fast[i].orbitalVelocity.z, truth[i].orbitalVelocity.z, allowed);
          }
          EXPECT_LE(largest, allowed) << static_cast<int>(kind) << ' ' << reach << ' ' << t;
        }
      }
    }
  }
}

TEST_P(FieldKernels, OnePointGivesTheBitsOfAnyBatch) {
  for (const int count : {1, 3, 4, 5, 16, 17, 70}) {
    const WaveField field(mixedOctaves(count, 20.0), {.depth = 20.0, .current = {0.2, 0.1}});
    const auto points = randomPoints(300, 2e3);
    for (const double tolerance : {0.0, 0.5 * field.standardDeviation()}) {
      const SampleOptions options{.tolerance = tolerance,
                                  .shortestWavelength = tolerance > 0.0 ? 20.0 : 0.0};
      std::vector<SurfaceSample> batch(points.size()), parts(points.size());
      field.sample(points, 4.2, batch, options);
      for (std::size_t i = 0; i < points.size(); i += 7) {
        const std::size_t n = std::min<std::size_t>(7, points.size() - i);
        field.sample(std::span(points).subspan(i, n), 4.2, std::span(parts).subspan(i, n), options);
      }
      const FieldAtTime now = field.at(4.2);
      for (std::size_t i = 0; i < points.size(); ++i) {
        const SurfaceSample single = now.sample(points[i], options);
        for (const SurfaceSample& other : {single, parts[i]}) {
          EXPECT_EQ(other.height, batch[i].height) << count;
          EXPECT_EQ(other.slope, batch[i].slope);
          EXPECT_EQ(other.verticalVelocity, batch[i].verticalVelocity);
          EXPECT_EQ(other.error, batch[i].error);
        }
      }
    }
  }
}

TEST_P(FieldKernels, ArraysHoldTheSameValues) {
  const WaveField field(mixedOctaves(5, 1e9));
  const auto points = randomPoints(1000, 2e3);
  std::vector<double> x, y;
  for (const glm::dvec2& point : points) x.push_back(point.x), y.push_back(point.y);
  std::vector<float> height(1000), slopeX(1000), rate(1000);
  std::vector<SurfaceSample> samples(1000);
  field.at(3.0).sample(x, y, {.height = height, .slopeX = slopeX, .slopeY = {}, .rate = rate});
  field.sample(points, 3.0, samples);
  for (std::size_t i = 0; i < 1000; ++i) {
    EXPECT_EQ(height[i], static_cast<float>(samples[i].height));
    EXPECT_EQ(slopeX[i], static_cast<float>(samples[i].slope.x));
    EXPECT_EQ(rate[i], static_cast<float>(samples[i].verticalVelocity));
  }
}

TEST_P(FieldKernels, HeightsAloneAreTheSameHeights) {
  const WaveField field(mixedOctaves(7, 1e9));
  const auto points = randomPoints(300, 2e3);
  std::vector<SurfaceSample> whole(points.size()), heights(points.size());
  const FieldAtTime now = field.at(3.0);
  now.sample(points, whole);
  now.sample(points, heights, {.derivatives = false});
  std::vector<double> x, y;
  for (const glm::dvec2& point : points) x.push_back(point.x), y.push_back(point.y);
  std::vector<float> array(points.size());
  now.sample(x, y, {.height = array, .slopeX = {}, .slopeY = {}, .rate = {}});
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(heights[i].height, whole[i].height);
    EXPECT_EQ(now.sample(points[i], {.derivatives = false}).height, whole[i].height);
    EXPECT_EQ(array[i], static_cast<float>(whole[i].height));
    EXPECT_TRUE(std::isnan(heights[i].slope.x) && std::isnan(heights[i].verticalVelocity));
  }
}

TEST_P(FieldKernelsHard, PointsBesideLatticeLinesAreRight) {
  // One octave whose lattice lines lie at whole metres.
  Octave octave = makeGroupOctave(0.5, 0.2, 0.05, 0.0, 0.5);
  octave.lengthAlong = octave.lengthAcross = 1.0;
  const WaveField field({octave});
  std::vector<glm::dvec2> points;
  for (int cell = -50; cell < 50; ++cell) {
    for (const double off : {-1e-14, -1e-16, 0.0, 1e-16, 1e-14})
      points.push_back({cell + off, cell - off});
  }
  std::vector<SurfaceSample> fast(points.size()), truth(points.size());
  field.sample(points, 0.0, fast);
  field.sampleReference(points, 0.0, truth);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(fast[i].height, truth[i].height, fast[i].bound);
    EXPECT_NEAR(fast[i].slope.x, truth[i].slope.x, 2e-5);
  }
}

TEST_P(FieldKernelsHard, PointsThatAreNotFiniteHarmNobodyElse) {
  const WaveField field(mixedOctaves(3, 1e9));
  std::vector<glm::dvec2> points = randomPoints(100, 1e3);
  std::vector<SurfaceSample> clean(100), spoilt(100);
  field.sample(points, 1.0, clean);
  points[10] = {NAN, 0.0};
  points[11] = {0.0, -INFINITY};
  field.sample(points, 1.0, spoilt);
  for (std::size_t i = 0; i < 100; ++i) {
    if (i == 10 || i == 11) {
      EXPECT_EQ(statusText(spoilt[i].status), "not_finite");
      EXPECT_TRUE(std::isnan(spoilt[i].height));
    } else {
      EXPECT_EQ(spoilt[i].height, clean[i].height);
    }
  }
  EXPECT_EQ(statusText(field.at(NAN).sample({1.0, 2.0}).status), "not_finite");
}

TEST_P(FieldKernels, PreparedQueriesAllocateNothing) {
  const WaveField field(mixedOctaves(8, 1e9));
  const FieldAtTime now = field.at(2.0);
  const auto points = randomPoints(600, 1e3);
  std::vector<SurfaceSample> samples(points.size());
  const std::size_t before = test_support::allocationCount();
  now.sample(points, samples, {.orbitalVelocity = true});
  now.sample(points[0]);
  field.sample(points, 3.0, samples);
  EXPECT_EQ(test_support::allocationCount(), before);
}

/// Height, slope along x and rate of six octaves of a kind at one point and time.
std::array<float, 3> pinnedSample(OctaveKind kind) {
  std::vector<Octave> octaves;
  for (int i = 0; i < 6; ++i) {
    const double f = 0.08 + 0.02 * i, toward = 0.3 * i;
    if (kind == OctaveKind::group)
      octaves.push_back(makeGroupOctave(0.1, f, 0.15 * f, toward, 0.5));
    if (kind == OctaveKind::perlin) octaves.push_back(makePerlinOctave(0.1, 0.9 / (f * f), toward));
    if (kind == OctaveKind::regular) octaves.push_back(makeRegularWave(0.1, f, toward, 0.1 * i));
  }
  const SurfaceSample sample = WaveField(octaves, {.seed = 7}).at(123.25).sample({1234.5, -678.25});
  return {static_cast<float>(sample.height), static_cast<float>(sample.slope.x),
          static_cast<float>(sample.verticalVelocity)};
}

TEST_P(FieldKernels, BitsArePinned) {
  // A change of these numbers changes every user's sea. With fused multiply-add (AVX2, AVX-512) all
  // machines agree; SSE4 has none and rounds otherwise.
  using Bits = std::array<float, 3>;
  const bool fused = std::string(GetParam()) != "SSE4";
  EXPECT_EQ(pinnedSample(OctaveKind::group),
            fused ? (Bits{-0x1.3b85d2p-4f, 0x1.0ae77ap-7f, -0x1.0a5ad8p-2f})
                  : (Bits{-0x1.3b85c4p-4f, 0x1.0ae77ap-7f, -0x1.0a5ad6p-2f}));
  EXPECT_EQ(pinnedSample(OctaveKind::perlin),
            fused ? (Bits{-0x1.5ca5fp-3f, 0x1.534042p-8f, -0x1.04a3bep-3f})
                  : (Bits{-0x1.5ca5f4p-3f, 0x1.53404p-8f, -0x1.04a3bap-3f}));
  EXPECT_EQ(pinnedSample(OctaveKind::regular),
            (Bits{0x1.e7b334p-4f, -0x1.359fd2p-9f, -0x1.52b54p-7f}));
}

TEST(FieldKernelMemory, AnOctaveTakesAtMost256Bytes) {
  EXPECT_LE(sizeof(GroupBlock) / octavesPerBlock, 256u);
  EXPECT_LE(sizeof(PerlinBlock) / octavesPerBlock, 256u);
  EXPECT_LE(sizeof(GroupOctave) + sizeof(Octave), 256u + 32u);
}

std::string nameOfTarget(const testing::TestParamInfo<const char*>& info) { return info.param; }
INSTANTIATE_TEST_SUITE_P(Targets, FieldKernels, testing::Values("AVX3", "AVX2", "SSE4"),
                         nameOfTarget);
INSTANTIATE_TEST_SUITE_P(Targets, FieldKernelsHard, testing::Values("AVX3", "AVX2", "SSE4"),
                         nameOfTarget);

}  // namespace
}  // namespace seaway
