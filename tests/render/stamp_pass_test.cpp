#include "render/gl/stamp_pass.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "render/gl/projected_waves.h"
#include "tests/render/seas.h"

namespace seaway::render {
namespace {

constexpr glm::ivec2 size(96, 160);

std::vector<glm::vec4> texelsOf(GLuint texture) {
  std::vector<glm::vec4> texels(static_cast<std::size_t>(size.x) * size.y);
  glGetTextureImage(texture, 0, GL_RGBA, GL_FLOAT,
                    static_cast<GLsizei>(texels.size() * sizeof(glm::vec4)), texels.data());
  return texels;
}

class Stamps : public ::testing::Test {
 protected:
  Stamps() {
    view_.water = &water_;
    view_.camera = test::cameraAt({2e5, -1e5, 6.0}, -20.0);
    view_.time = 3.0;
    projector_ = Projector::aimedAt(view_.camera, water_.heightBound());
  }
  std::vector<glm::vec4> mapWith(std::span<const Stamp> stamps) {
    waves_.fill(view_, *projector_, size, stamps);
    checkGl("stamps");
    return texelsOf(waves_.map().texture());
  }
  /// What stamps should add at a texel: the hump of stamp_bump.glsl in double.
  glm::dvec3 expectedAt(std::span<const Stamp> stamps, int column, int row) const {
    const TwinRow& line = waves_.rows()[static_cast<std::size_t>(row)];
    const glm::dvec2 point = glm::dvec2(view_.camera.position) + glm::dvec2(line.point(column));
    glm::dvec3 sum(0.0);
    for (const Stamp& stamp : stamps) {
      const glm::dvec2 along(std::cos(stamp.toward), std::sin(stamp.toward));
      const glm::dvec2 across(-along.y, along.x);
      const glm::dvec2 offset = point - stamp.centre;
      const glm::dvec2 local =
          glm::dvec2(glm::dot(offset, along), glm::dot(offset, across)) / stamp.halfSize;
      const double inside = std::max(1.0 - glm::dot(local, local), 0.0);
      const double wavelength = 4.0 * std::min(stamp.halfSize.x, stamp.halfSize.y);
      const double kept = line.keptWavelength;
      const double f = std::clamp((wavelength - 0.5 * kept) / (0.5 * kept), 0.0, 1.0);
      const double part = stamp.height * f * f * (3.0 - 2.0 * f);
      const glm::dvec2 slope = -6.0 * inside * inside * local / stamp.halfSize;
      sum += part * glm::dvec3(inside * inside * inside, along * slope.x + across * slope.y);
    }
    return sum;
  }

  HeadlessContext& context_ = test::sharedContext();
  WaterSurface water_ = test::groupSea(1.0, 6.0);
  View view_;
  std::optional<Projector> projector_;
  ProjectedWaves waves_;
};

TEST_F(Stamps, AddTheirHeightsAndSlopesToTheWaveMap) {
  const glm::dvec2 foot(view_.camera.position);
  const glm::dvec2 ahead(std::cos(0.4), std::sin(0.4));  // where the camera looks
  const std::vector<Stamp> stamps{{foot + 12.0 * ahead, 0.7, {3.0, 5.0}, 0.8},
                                  {foot + 14.0 * ahead, 2.0, {4.0, 2.0}, -0.5},
                                  {foot + 60.0 * ahead, 0.0, {20.0, 20.0}, 1.5},
                                  {foot - 500.0 * ahead, 0.0, {10.0, 10.0}, 9.0}};  // out of view
  const std::vector<glm::vec4> plain = mapWith({}), stamped = mapWith(stamps);
  double largest = 0.0;
  for (int row = 0; row < size.y; ++row) {
    for (int column = 0; column < size.x; ++column) {
      const std::size_t i = static_cast<std::size_t>(row) * size.x + column;
      const glm::dvec3 added(stamped[i] - plain[i]), expected = expectedAt(stamps, column, row);
      largest = std::max(largest, std::abs(expected.x));
      // Positions 200 km from the anchor are taken from the camera's foot first, in double.
      ASSERT_LT(glm::length(added - expected), 2e-5) << "texel " << column << ' ' << row;
    }
  }
  EXPECT_GT(largest, 1.0);
}

TEST_F(Stamps, ReachTheDrawnSurfaceAndItsTally) {
  const glm::dvec2 ahead(std::cos(0.4), std::sin(0.4));
  const std::vector<Stamp> stamps{
      {glm::dvec2(view_.camera.position) + 20.0 * ahead, 0.0, {8.0, 8.0}, 7.0}};
  mapWith({});
  EXPECT_LT(waves_.map().tally().largestHeight, 2.0f);
  mapWith(stamps);
  EXPECT_GT(waves_.map().tally().largestHeight, 5.0f);
}

TEST_F(Stamps, CostNoTextureWhileThereAreNone) {
  mapWith({});
  EXPECT_EQ(waves_.stamps(), 0u);
  const std::size_t without = waves_.memoryBytes();
  const std::vector<Stamp> one{{glm::dvec2(view_.camera.position), 0.0, {5.0, 5.0}, 1.0}};
  mapWith(one);
  EXPECT_NE(waves_.stamps(), 0u);
  EXPECT_GT(waves_.memoryBytes(), without);
  mapWith({});
  EXPECT_EQ(waves_.stamps(), 0u);
}

}  // namespace
}  // namespace seaway::render
