#include "render/ripples.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "render/band_limit.h"
#include "tests/render/seas.h"

namespace seaway::render {
namespace {

TEST(Ripples, PatchHasUnitMeanSquareSlopeNoMeanAndTiles) {
  constexpr int side = 128;
  const auto texels = rippleTexture(side);
  glm::dvec2 mean(0.0);
  double meanSquare = 0.0, stepInside = 0.0, stepAcrossSeam = 0.0;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const glm::vec3 texel = texels[y * side + x];
      mean += glm::dvec2(texel) / double(side * side);
      meanSquare += texel.z / double(side * side);
      EXPECT_FLOAT_EQ(texel.z, texel.x * texel.x + texel.y * texel.y);
    }
    stepInside += glm::distance(glm::vec2(texels[y * side + 63]), glm::vec2(texels[y * side + 64]));
    stepAcrossSeam += glm::distance(glm::vec2(texels[y * side + 127]), glm::vec2(texels[y * side]));
  }
  EXPECT_NEAR(meanSquare, 1.0, 1e-5);                  // float rounding
  EXPECT_NEAR(glm::length(mean), 0.0, 1e-6);           // whole waves only
  EXPECT_NEAR(stepAcrossSeam / stepInside, 1.0, 0.4);  // like any other column
}

TEST(Ripples, BringSlopesUpToCoxAndMunkAndNeverBeyond) {
  const WaterSurface water = test::moderateSea();
  const double carried = BandLimit(water.waves()).totalSlope();
  for (const double wind : {0.0, 3.0, 12.0, 30.0}) {
    const Ripples ripples = ripplesFor(water.waves(), wind);
    const double total = carried + 2.0 * ripples.layerSlope + ripples.hairSlope;
    EXPECT_NEAR(total, std::max(coxMunkMeanSquareSlope(wind), carried), 1e-12) << wind;
    EXPECT_GE(ripples.layerSlope, 0.0);
  }
}

TEST(Ripples, TextureCoordinatesStayExactFarFromTheAnchor) {
  const Ripples ripples = ripplesFor(test::moderateSea().waves(), 7.0);
  const glm::dvec2 far(1e7, -3e6), step(0.01, 0.02);
  const glm::dvec2 a = ripples.textureCoordinate(0, far, 1e5);
  const glm::dvec2 b = ripples.textureCoordinate(0, far + step, 1e5);
  const glm::dvec2 wanted = ripples.textureFromWorld[0] * step;
  const glm::dvec2 moved = glm::fract(b - a + 0.5) - 0.5;
  EXPECT_LE(glm::distance(moved, wanted), 1e-8);  // 1e7 m times 2⁻⁵³, some operations
}

}  // namespace
}  // namespace seaway::render
