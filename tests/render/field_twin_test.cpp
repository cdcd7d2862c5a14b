#include "render/field_twin.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <random>

#include "render/gl/wave_map.h"
#include "render/sea_grid.h"
#include "surface/input_error.h"
#include "tests/render/seas.h"

namespace seaway::render {
namespace {

/// Rows over a camera's view.
std::vector<TwinRow> rowsFor(const Camera& camera, const WaterSurface& water, glm::ivec2 size) {
  const auto projector = Projector::aimedAt(camera, water.heightBound());
  EXPECT_TRUE(projector.has_value());
  return twinRows(*projector, water.waves(), size);
}

/// The map as the shader filled it, (height, slope, missing slope) a texel.
std::vector<glm::vec4> texelsOf(const WaveMap& map) {
  std::vector<glm::vec4> texels(static_cast<std::size_t>(map.size().x) * map.size().y);
  glGetTextureImage(map.texture(), 0, GL_RGBA, GL_FLOAT,
                    static_cast<GLsizei>(texels.size() * sizeof(glm::vec4)), texels.data());
  return texels;
}

std::vector<glm::vec4> filled(WaveMap::Way way, const FieldTwin& twin,
                              const std::vector<TwinRow>& rows, int columns, const Camera& camera) {
  test::sharedContext();
  const GlVertexArray noVertices = makeVertexArray();
  glBindVertexArray(noVertices);
  WaveMap map(way);
  map.fill(twin, rows, columns, camera);
  checkGl("wave map");
  return texelsOf(map);
}

bool sameBits(glm::vec4 a, glm::vec4 b) {
  for (int i = 0; i < 4; ++i) {
    if (std::bit_cast<std::uint32_t>(a[i]) != std::bit_cast<std::uint32_t>(b[i])) return false;
  }
  return true;
}

struct ParityCase {
  const char* name;
  WaterSurface water;
  glm::dvec2 origin{0.0};
  double time = 0.0;
};

/// Stops at the first texel that differs, and prints it.
void expectParity(const ParityCase& parity, WaveMap::Way way) {
  const Camera camera = test::cameraAt({parity.origin, 6.0}, -10.0);
  const glm::ivec2 size(96, 128);
  const std::vector<TwinRow> rows = rowsFor(camera, parity.water, size);
  const FieldTwin twin(parity.water.waves(), parity.time, parity.origin);
  const std::vector<glm::vec4> texels = filled(way, twin, rows, size.x, camera);
  double largest = 0.0;
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const TwinRow& row = rows[static_cast<std::size_t>(y)];
      const glm::vec4 expected(twin.sample(row.point(x), row), row.missingSlope);
      const glm::vec4 texel = texels[static_cast<std::size_t>(y) * size.x + x];
      largest = std::max(largest, std::abs(static_cast<double>(texel.x)));
      ASSERT_TRUE(sameBits(texel, expected))
          << parity.name << ": texel (" << x << ", " << y << ") is height " << texel.x << ", slope "
          << texel.y << ' ' << texel.z << ", missing " << texel.w << "; in C++ " << expected.x
          << ", " << expected.y << ' ' << expected.z << ", " << expected.w;
    }
  }
  EXPECT_GT(largest, 0.1) << parity.name;  // a sea of zeros would agree as well
}

std::vector<ParityCase> parityCases() {
  return {{"groups", test::groupSea(1.2, 6.0)},
          {"perlin", test::moderateSea()},
          {"mixed, on a current in 20 m of water", test::mixedSea()},
          {"storm", test::groupSea(9.0, 12.0)},
          {"groups after 1e7 s", test::groupSea(1.2, 6.0), {0.0, 0.0}, 1e7},
          {"mixed 150 km from the anchor", test::mixedSea(), {-1.06e5, 1.06e5}, 1e7},
          {"groups 1e8 m from the anchor", test::groupSea(1.2, 6.0), {1e8, -3e7}, 3.7}};
}

TEST(FieldTwin, ShaderAndProcessorGiveTheSameBitsInEveryTexel) {
  if (!test::sharedContext().isSoftware()) GTEST_SKIP() << "bits are promised for llvmpipe alone";
  for (const ParityCase& parity : parityCases()) expectParity(parity, WaveMap::Way::fragment);
}

TEST(FieldTwin, ComputeShaderGivesTheSameBitsToo) {
  if (!test::sharedContext().isSoftware()) GTEST_SKIP() << "bits are promised for llvmpipe alone";
  for (const ParityCase& parity : parityCases()) expectParity(parity, WaveMap::Way::compute);
}

/// Largest difference between twin and query of height (m) and slope at random points within
/// `reach` m of a random origin, of a sea that a row carries in full.
glm::dvec2 largestDifference(const WaterSurface& water, double reach, double farthest,
                             double time) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  glm::dvec2 largest(0.0);
  for (int i = 0; i < 40; ++i) {
    const glm::dvec2 origin = farthest * glm::dvec2(unit(random), unit(random));
    const FieldTwin twin(water.waves(), time, origin);
    for (int j = 0; j < 100; ++j) {
      const glm::vec2 offset(reach * glm::dvec2(unit(random), unit(random)) / std::sqrt(2.0));
      const glm::vec3 drawn = twin.sample(offset, TwinRow{});
      const SurfaceSample asked = water.sample(origin + glm::dvec2(offset), time);
      largest.x = std::max(largest.x, std::abs(drawn.x - asked.height));
      largest.y = std::max(largest.y, glm::length(glm::dvec2(drawn.y, drawn.z) - asked.slope));
    }
  }
  return largest;
}

TEST(FieldTwin, AgreesWithQueriesWithinItsStatedBounds) {
  for (const auto& [name, water] :
       {std::pair("groups", test::groupSea(1.2, 6.0)), std::pair("perlin", test::moderateSea()),
        std::pair("mixed", test::mixedSea()), std::pair("storm", test::groupSea(9.0, 12.0))}) {
    const glm::dvec2 near = largestDifference(water, 500.0, 1e3, 3.0);
    const glm::dvec2 far = largestDifference(water, 5000.0, 1e3, 3.0);
    std::printf(
        "%s: H_m0 %.2f m: height %.2g m within 500 m, %.2g m within 5 km; slope %.2g, %.2g\n", name,
        water.waves().significantWaveHeight(), near.x, far.x, near.y, far.y);
    EXPECT_LT(near.x, FieldTwin::heightBound(water.waves(), 500.0)) << name;
    EXPECT_LT(far.x, FieldTwin::heightBound(water.waves(), 5000.0)) << name;
  }
}

TEST(FieldTwinHard, FarFromTheAnchorAndAfterManyDaysItAgreesAsWell) {
  const WaterSurface water = test::mixedSea();
  const double bound = FieldTwin::heightBound(water.waves(), 500.0) + water.waves().bound(2.2e5);
  EXPECT_LT(largestDifference(water, 500.0, 1.5e5, 1e7).x, bound);
}

TEST(FieldTwin, SeasWithMoreOctavesThanTheCardTakesAreRefused) {
  const std::vector<Octave> many(FieldTwin::mostOctaves + 1, makeRegularWave(0.01, 0.2, 0.0));
  EXPECT_THROW(FieldTwin(WaveField(many), 0.0, {0.0, 0.0}), InputError);
}

TEST(FieldTwin, WhereTheFieldHasNoAnswerTheSeaIsStill) {
  const WaterSurface water = test::moderateSea();
  const FieldTwin twin(water.waves(), 2.0 * WaveField::latest, {0.0, 0.0});
  EXPECT_EQ(twin.sample({1.0, 2.0}, TwinRow{}), glm::vec3(0.0f));
}

TEST(WaveMap, TalliesTheLargestHeightAndTheVerticesInView) {
  test::sharedContext();
  const WaterSurface water = test::groupSea(1.2, 6.0);
  const Camera camera = test::cameraAt({0.0, 0.0, 6.0}, -10.0);
  const glm::ivec2 size(80, 60);
  const FieldTwin twin(water.waves(), 3.0, {0.0, 0.0});
  const std::vector<TwinRow> rows = rowsFor(camera, water, size);
  const auto projector = Projector::aimedAt(camera, water.heightBound());
  SeaGrid grid;
  grid.fill(water.at(3.0), camera, projectedLayout(*projector, water.waves(), size));
  const GlVertexArray noVertices = makeVertexArray();
  glBindVertexArray(noVertices);
  for (const WaveMap::Way way : {WaveMap::Way::fragment, WaveMap::Way::compute}) {
    WaveMap map(way);
    map.fill(twin, rows, size.x, camera);
    EXPECT_NEAR(map.tally().largestHeight, grid.largestHeight(), 1e-5);
    // A vertex on the picture's edge may fall to either side.
    EXPECT_NEAR(static_cast<double>(map.tally().verticesInFrustum), grid.verticesInFrustum(camera),
                3.0);
  }
}

}  // namespace
}  // namespace seaway::render
