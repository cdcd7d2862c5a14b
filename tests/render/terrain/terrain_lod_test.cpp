#include "render/terrain/terrain_lod.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "tests/render/terrain/grounds.h"

namespace seaway::render {
namespace {

using Corners = std::vector<glm::vec3>;

Corners select(const TerrainMap& map, const Camera& camera,
               const TerrainSelection& selection = {}) {
  Corners corners;
  TerrainLod(map).select(map, camera, selection, corners);
  return corners;
}

/// The height's number in the map that a corner is.
std::pair<int, int> node(const TerrainMap& map, const Camera& camera, const glm::vec3& corner) {
  const glm::dvec2 at =
      (glm::dvec2(corner) + glm::dvec2(camera.position) - map.least()) / map.grid().spacing;
  return {static_cast<int>(std::lround(at.x)), static_cast<int>(std::lround(at.y))};
}

/// Without the curtains at the map's edges, whose triangles stand upright.
bool isGround(const glm::vec3* t) {
  const glm::vec2 a(t[1] - t[0]), b(t[2] - t[0]);
  return std::abs(a.x * b.y - a.y * b.x) > 1e-3f;
}

/// All around: nothing of the map is out of view.
Camera highAbove(double height) {
  return test::looking({0.0, 0.0, height}, 0.0, -90.0, 120.0, {400, 400});
}

TEST(TerrainLod, TrianglesMeetWithoutCracksWhateverTheirSizes) {
  const auto map =
      test::ground({129, 65}, 8.0, [](glm::dvec2 p) { return test::roughIsland(p, 700.0); });
  const Camera camera = highAbove(900.0);
  std::map<std::pair<std::pair<int, int>, std::pair<int, int>>, int> edges;
  const Corners corners = select(*map, camera, {.tolerance = 4.0});
  ASSERT_GT(corners.size(), 300u);
  ASSERT_LT(corners.size(), 3u * 2 * 128 * 64 / 4);  // of several sizes
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    if (!isGround(&corners[i])) continue;
    for (int k = 0; k < 3; ++k) {
      auto a = node(*map, camera, corners[i + k]), b = node(*map, camera, corners[i + (k + 1) % 3]);
      ++edges[std::minmax(a, b)];
    }
  }
  for (const auto& [edge, count] : edges) {
    const auto& [a, b] = edge;
    const bool border = (a.first == b.first && (a.first == 0 || a.first == 128)) ||
                        (a.second == b.second && (a.second == 0 || a.second == 64));
    EXPECT_EQ(count, border ? 1 : 2)
        << a.first << ' ' << a.second << ' ' << b.first << ' ' << b.second;
  }
}

/// Largest difference of the drawn heights from the map's own at its nodes, in pixels as seen from
/// the camera, and of those where the map's height is within 1 m of the still water.
std::pair<double, double> errorInPixels(const TerrainMap& map, const Camera& camera,
                                        const Corners& corners) {
  double worst = 0.0, worstAtShore = 0.0;
  const double pixels = 0.5 * camera.size.y / std::tan(0.5 * camera.verticalFieldOfView);
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    if (!isGround(&corners[i])) continue;
    std::array<std::pair<int, int>, 3> at;
    for (int k = 0; k < 3; ++k) at[k] = node(map, camera, corners[i + k]);
    const auto [left, right] = std::minmax({at[0].first, at[1].first, at[2].first});
    const auto [low, high] = std::minmax({at[0].second, at[1].second, at[2].second});
    const glm::dvec2 a(at[0].first, at[0].second), b(at[1].first, at[1].second),
        c(at[2].first, at[2].second);
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    for (int y = low; y <= high; ++y) {
      for (int x = left; x <= right; ++x) {
        const glm::dvec2 p(x, y);
        const double v = ((p.x - a.x) * (c.y - a.y) - (p.y - a.y) * (c.x - a.x)) / area;
        const double w = ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / area;
        if (v < -1e-9 || w < -1e-9 || v + w > 1.0 + 1e-9) continue;
        const double drawn = corners[i].z + v * double(corners[i + 1].z - corners[i].z) +
                             w * double(corners[i + 2].z - corners[i].z);
        const double height = map.grid().heights[y * map.grid().count.x + x];
        const glm::dvec3 place(map.least() + p * map.grid().spacing, height);
        const glm::dvec3 off = place - camera.position;
        const double axial = glm::dot(off, camera.forward());
        if (axial < camera.nearDistance) continue;
        const double error = pixels * std::abs(drawn - height) / axial;
        worst = std::max(worst, error);
        if (std::abs(height) < 1.0) worstAtShore = std::max(worstAtShore, error);
      }
    }
  }
  return {worst, worstAtShore};
}

TEST(TerrainLod, NoHeightIsFartherOffThanTheToleranceSays) {
  const auto map =
      test::ground({257, 257}, 8.0, [](glm::dvec2 p) { return test::roughIsland(p, 1500.0); });
  for (const glm::dvec3 eye :
       {glm::dvec3(0.0, -900.0, 20.0), {-700.0, 300.0, 300.0}, {100.0, -1200.0, 700.0}}) {
    for (const double tolerance : {0.35, 0.7, 2.8}) {
      SCOPED_TRACE(std::to_string(eye.z) + " m, " + std::to_string(tolerance) + " px");
      const Camera camera = test::looking(eye, 80.0, -15.0, 60.0, {640, 360});
      const Corners corners = select(*map, camera, {.tolerance = tolerance});
      const auto [worst, atShore] = errorInPixels(*map, camera, corners);
      EXPECT_LE(worst, tolerance);
      EXPECT_GT(worst, 0.02 * tolerance);  // the bound is not met by drawing all there is
    }
  }
}

TEST(TerrainLod, FarAwayFewTrianglesAreEnough) {
  const auto map =
      test::ground({513, 513}, 4.0, [](glm::dvec2 p) { return test::roughIsland(p, 1500.0); });
  const auto count = [&](double away) {
    return select(*map, test::looking({0.0, -away, 30.0}, 90.0, 0.0, 60.0, {640, 360})).size() / 3;
  };
  const std::size_t near = count(1500.0), middle = count(6000.0), far = count(24000.0);
  EXPECT_LT(near, 2u * 512 * 512 / 8);
  EXPECT_LT(middle, near / 2);
  EXPECT_LT(far, middle / 2);
  EXPECT_GT(far, 20u);
}

TEST(TerrainLod, WhatIsOutOfViewOrTooLowIsLeftOut) {
  const auto map =
      test::ground({129, 129}, 8.0, [](glm::dvec2 p) { return test::roughIsland(p, 700.0); });
  const Camera towards = test::looking({0.0, -900.0, 30.0}, 90.0, 0.0);
  const Camera away = test::looking({0.0, -900.0, 30.0}, -90.0, 0.0);
  EXPECT_GT(select(*map, towards).size(), 0u);
  EXPECT_EQ(select(*map, away).size(), 0u);
  EXPECT_EQ(select(*map, towards, {.lowest = map->highest() + 1.0}).size(), 0u);
  EXPECT_LT(select(*map, towards, {.lowest = 0.0}).size(), select(*map, towards).size());
  for (const glm::vec3& corner : select(*map, towards, {.side = TerrainSide::mirrored})) {
    EXPECT_GE(corner.z, -map->highest());
  }
}

TEST(TerrainLodHard, OneCellOddCountsAndFlatGroundAreDrawn) {
  for (const glm::ivec2 count : {glm::ivec2(2, 2), {38, 2}, {4, 6}, {65, 65}}) {
    const auto map = test::ground(count, 100.0, [](glm::dvec2) { return 5.0; });
    const Corners corners = select(*map, highAbove(4000.0));
    double area = 0.0;
    for (std::size_t i = 0; i < corners.size(); i += 3) {
      const glm::vec2 a(corners[i + 1] - corners[i]), b(corners[i + 2] - corners[i]);
      area += 0.5 * std::abs(a.x * b.y - a.y * b.x);
    }
    const double whole = 1e4 * (count.x - 1) * (count.y - 1);
    EXPECT_NEAR(area, whole, 1e-4 * whole);
  }
}

TEST(TerrainLodHard, CamerasUnderOnAndFarFromTheGroundSelectFinitePlaces) {
  const auto map =
      test::ground({129, 129}, 8.0, [](glm::dvec2 p) { return test::roughIsland(p, 700.0); });
  const double here = map->heightAt({0.0, 0.0});
  for (const double z : {here + 0.01, here - 5.0, -1000.0, 1e5}) {
    const Camera camera = test::looking({0.0, 0.0, z}, 30.0, -20.0);
    Corners corners = select(*map, camera);
    bendToSea(camera, corners);
    EXPECT_LE(corners.size(), 3u * 2 * (128 * 128 + 4 * 128));
    for (const glm::vec3& corner : corners) {
      EXPECT_TRUE(std::isfinite(corner.x + corner.y + corner.z));
    }
  }
}

}  // namespace
}  // namespace seaway::render
