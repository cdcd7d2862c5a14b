#include "surface/terrain/terrain_map.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <limits>
#include <memory>

#include "surface/input_error.h"
#include "surface/surface_ray.h"
#include "surface/water_kinematics.h"
#include "surface/water_surface.h"
#include "tests/support/allocation_counter.h"

namespace seaway {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TerrainMap::Grid hills(glm::ivec2 count = {9, 7}) {
  TerrainMap::Grid grid{{-20.0, 5.0}, {4.0, 3.0}, count, {}};
  for (int i = 0; i < count.x * count.y; ++i) {
    grid.heights.push_back(static_cast<float>(6.0 * std::sin(1.7 * i) + 0.25 * (i % 5)));
  }
  return grid;
}

/// A beach that rises eastwards, 0.1 m a metre, from 0 at x = 0; 400 m each way.
std::shared_ptr<const TerrainMap> beach() {
  return std::make_shared<const TerrainMap>(
      TerrainMap::Grid{{-200.0, -200.0}, {400.0, 400.0}, {2, 2}, {-20.0f, 20.0f, -20.0f, 20.0f}});
}

WaterSurface wavySea() {
  return WaterSurface(WaveField({makeGroupOctave(0.3, 0.2, 0.03, 0.4, 0.5)}));
}

TEST(TerrainMap, HeightsAreThoseOfTheGridAndLinearBetweenThem) {
  const TerrainMap map(hills());
  const auto& grid = map.grid();
  for (int row = 0; row < grid.count.y; ++row) {
    for (int column = 0; column < grid.count.x; ++column) {
      const glm::dvec2 place = grid.origin + glm::dvec2(column, row) * grid.spacing;
      EXPECT_EQ(map.heightAt(place), grid.heights[row * grid.count.x + column]);
    }
  }
  // The middle of a cell is the mean of its corners.
  const double mean =
      0.25 * (double(grid.heights[0]) + grid.heights[1] + grid.heights[9] + grid.heights[10]);
  EXPECT_NEAR(map.heightAt({-18.0, 6.5}), mean, 1e-12);
}

TEST(TerrainMap, HeightsAreContinuousAcrossCells) {
  const TerrainMap map(hills());
  for (double x = -20.0; x <= 12.0; x += 0.13) {
    for (double y = 5.0; y <= 23.0; y += 0.11) {
      // No slope of this map is more than `steepest`; without a jump a step of 1 µm stays below.
      const double here = map.heightAt({x, y});
      for (const glm::dvec2 step : {glm::dvec2(1e-6, 0.0), glm::dvec2(0.0, 1e-6)}) {
        const double there = map.heightAt(glm::min(glm::dvec2(x, y) + step, map.most()));
        EXPECT_LE(std::abs(there - here), 1.01e-6 * map.steepest() + 1e-12);
      }
    }
  }
}

TEST(TerrainMap, BeyondTheMapThereIsNoGround) {
  const TerrainMap map(hills());
  EXPECT_TRUE(std::isfinite(map.heightAt(map.least())));
  EXPECT_TRUE(std::isfinite(map.heightAt(map.most())));
  for (const glm::dvec2 place : {glm::dvec2(-20.001, 6.0),
                                 {12.001, 6.0},
                                 {0.0, 4.999},
                                 {0.0, 23.001},
                                 {1e300, 6.0},
                                 {NAN, 6.0},
                                 {0.0, -infinity}}) {
    EXPECT_EQ(map.heightAt(place), -infinity);
  }
}

TEST(TerrainMap, SamplesAreDryWhereGroundStandsAboveTheWater) {
  WaterSurface water = wavySea();
  const WaterSurface open = water;
  water.setTerrain(beach());
  int dry = 0, wet = 0;
  for (double x = -30.0; x <= 30.0; x += 0.37) {
    const glm::dvec2 place(x, 7.0);
    const SurfaceSample before = open.sample(place, 5.0), sample = water.sample(place, 5.0);
    if (before.height > 0.1 * x) {
      ++wet;
      EXPECT_EQ(sample.status, SampleStatus::ok);
      EXPECT_EQ(sample.height, before.height);
    } else {
      ++dry;
      EXPECT_TRUE(has(sample.status, SampleStatus::dry));
      EXPECT_TRUE(std::isnan(sample.height) && std::isnan(sample.slope.x));
      EXPECT_EQ(sample.error, 0.0);
    }
    EXPECT_NEAR(water.bedAt(place), 0.1 * x, 1e-12);
  }
  EXPECT_GT(dry, 50);
  EXPECT_GT(wet, 50);
  EXPECT_EQ(open.bedAt({0.0, 0.0}), -infinity);
}

TEST(TerrainMap, AnswersAreTheSameBitsAloneInBatchesAndPrepared) {
  WaterSurface water = wavySea();
  water.setTerrain(beach());
  std::array<glm::dvec2, 101> places;
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = {-25.0 + 0.5 * double(i), 3.0};
  std::array<SurfaceSample, 101> batch, prepared;
  water.sample(places, 2.0, batch);
  const SurfaceAtTime now = water.at(2.0);
  now.sample(places, prepared);
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  for (std::size_t i = 0; i < places.size(); ++i) {
    const SurfaceSample alone = water.sample(places[i], 2.0);
    EXPECT_EQ(bits(batch[i].height), bits(alone.height));
    EXPECT_EQ(bits(prepared[i].height), bits(alone.height));
    EXPECT_EQ(batch[i].status, alone.status);
    EXPECT_EQ(now.sample(places[i]).status, alone.status);
  }
}

TEST(TerrainMap, QueriesAllocateNothing) {
  WaterSurface water = wavySea();
  water.setTerrain(beach());
  std::array<glm::dvec2, 64> places;
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = {-25.0 + double(i), 3.0};
  std::array<SurfaceSample, 64> samples;
  const SurfaceAtTime now = water.at(2.0);
  const std::size_t before = test_support::allocationCount();
  now.sample(places, samples);
  EXPECT_EQ(test_support::allocationCount(), before);
}

TEST(TerrainMap, PointsInTheGroundHaveNoWaterMotion) {
  WaterSurface water = wavySea();
  water.setTerrain(beach());
  const SurfaceAtTime now = water.at(1.0);
  const std::array<glm::dvec3, 3> points{
      {{-50.0, 0.0, -4.0}, {-50.0, 0.0, -6.0}, {50.0, 0.0, -1.0}}};
  std::array<WaterKinematics, 3> motion;
  sampleKinematics(now, points, motion);
  EXPECT_TRUE(std::isfinite(motion[0].velocity.x));
  for (const int i : {1, 2}) {
    EXPECT_TRUE(has(motion[i].status, SampleStatus::belowBed));
    EXPECT_TRUE(std::isnan(motion[i].velocity.x));
  }
}

TEST(TerrainMap, OutlineAndTerrainBothApply) {
  WaterSurface water = wavySea();
  water.setTerrain(beach());
  const std::vector<OutlinePolygon> north{
      {{{{-500.0, 0.0}, {500.0, 0.0}, {500.0, 500.0}, {-500.0, 500.0}}}}};
  water.setOutline(std::make_shared<const WaterOutline>(north));
  const auto dry = [&](double x, double y) {
    return has(water.sample({x, y}, 0.0).status, SampleStatus::dry);
  };
  EXPECT_FALSE(dry(-50.0, 50.0));
  EXPECT_TRUE(dry(50.0, 50.0));    // on the beach
  EXPECT_TRUE(dry(-50.0, -50.0));  // outside the outline
}

TEST(TerrainMap, RaysEndAtGroundThatStandsAboveTheWater) {
  WaterSurface water{WaveField({})};
  water.setTerrain(beach());
  const SurfaceAtTime now = water.at(0.0);
  // From 30 m up eastwards and down: water before the beach, then none.
  const auto distance = [&](double downwards) {
    return distanceToWater(now, {-100.0, 0.0, 30.0},
                           glm::normalize(glm::dvec3(1.0, 0.0, -downwards)), {.curved = false});
  };
  ASSERT_TRUE(distance(0.5));
  EXPECT_NEAR(*distance(0.5), 60.0 * std::sqrt(1.25), 1e-3);
  EXPECT_FALSE(distance(0.25));  // the beach, 3.3 m up, is in front of still water 120 m away
}

TEST(TerrainMapHard, BrokenGridsAreRefused) {
  const auto refused = [](auto change) {
    TerrainMap::Grid grid = hills();
    change(grid);
    try {
      TerrainMap map(std::move(grid));
    } catch (const InputError& fault) {
      return std::string(fault.what());
    }
    return std::string();
  };
  EXPECT_EQ(refused([](auto&) {}), "");
  EXPECT_EQ(refused([](auto& g) { g.heights[13] = NAN; }),
            "terrain: the height in column 4 of row 1 is not finite");
  EXPECT_NE(refused([](auto& g) { g.heights[0] = static_cast<float>(infinity); }), "");
  EXPECT_NE(refused([](auto& g) { g.heights.pop_back(); }), "");
  EXPECT_NE(refused([](auto& g) { g.spacing.x = 0.0; }), "");
  EXPECT_NE(refused([](auto& g) { g.origin.y = NAN; }), "");
  EXPECT_NE(refused([](auto& g) { g.count = {1, 63}; }), "");
  EXPECT_EQ(refused([](auto& g) {
              g.count = {8192, 8192};
            }),
            "terrain: 8192 x 8192 heights are not allowed; 18948609 at the most");
}

TEST(TerrainMapHard, AllUnderWaterAndAllAboveItAreOrdinary) {
  for (const float height : {-30.0f, 30.0f}) {
    WaterSurface water = wavySea();
    water.setTerrain(std::make_shared<const TerrainMap>(
        TerrainMap::Grid{{-9.0, -9.0}, {18.0, 18.0}, {2, 2}, {height, height, height, height}}));
    const SurfaceSample on = water.sample({0.0, 0.0}, 0.0), off = water.sample({10.0, 0.0}, 0.0);
    EXPECT_EQ(has(on.status, SampleStatus::dry), height > 0.0f);
    EXPECT_EQ(off.status, SampleStatus::ok);
    EXPECT_EQ(water.bedAt({0.0, 0.0}), height);
  }
}

TEST(TerrainMapHard, PointsAndTimesThatAreNotFiniteKeepTheirStatus) {
  WaterSurface water = wavySea();
  water.setTerrain(beach());
  for (const glm::dvec2 place : {glm::dvec2(NAN, 0.0), {0.0, infinity}}) {
    const SurfaceSample sample = water.sample(place, 0.0);
    EXPECT_TRUE(has(sample.status, SampleStatus::notFinite));
    EXPECT_FALSE(has(sample.status, SampleStatus::dry));
  }
}

}  // namespace
}  // namespace seaway
