#include "surface/outline/water_outline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <string>

#include "surface/field/octave.h"
#include "surface/input_error.h"
#include "surface/surface_ray.h"
#include "surface/water_surface.h"
#include "tests/support/allocation_counter.h"

namespace seaway {
namespace {

using Ring = std::vector<glm::dvec2>;

Ring square(double half, glm::dvec2 middle = {0.0, 0.0}) {
  return {middle + glm::dvec2(-half, -half), middle + glm::dvec2(half, -half),
          middle + glm::dvec2(half, half), middle + glm::dvec2(-half, half)};
}

WaterOutline outlineOf(std::vector<OutlinePolygon> polygons) { return WaterOutline(polygons); }

std::string faultOf(std::vector<OutlinePolygon> polygons) {
  try {
    outlineOf(std::move(polygons));
  } catch (const InputError& fault) {
    return fault.what();
  }
  return "";
}

/// Even-odd by a ray to the east over all edges: what the index is checked against.
bool insideByRay(const std::vector<Ring>& rings, glm::dvec2 p) {
  bool inside = false;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const glm::dvec2 a = ring[i], b = ring[(i + 1) % ring.size()];
      if ((a.y <= p.y) == (b.y <= p.y)) continue;
      if (p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
    }
  }
  return inside;
}

TEST(WaterOutline, ASquareWithAHoleHoldsWhatLiesBetween) {
  const WaterOutline outline = outlineOf({{{square(100.0), square(30.0)}}});
  EXPECT_DOUBLE_EQ(outline.area(), 200.0 * 200.0 - 60.0 * 60.0);
  for (double x = -120.25; x < 121.0; x += 0.5) {
    for (double y = -120.25; y < 121.0; y += 7.5) {
      const double far = std::max(std::abs(x), std::abs(y));
      EXPECT_EQ(outline.contains({x, y}), far < 100.0 && far > 30.0) << x << ' ' << y;
    }
  }
}

TEST(WaterOutline, RingsMayTurnEitherWayAndRepeatTheirFirstPoint) {
  Ring outer = square(100.0), hole = square(30.0);
  std::reverse(outer.begin(), outer.end());
  outer.push_back(outer.front());
  const WaterOutline outline = outlineOf({{{outer, hole}}});
  EXPECT_DOUBLE_EQ(outline.area(), 200.0 * 200.0 - 60.0 * 60.0);
  EXPECT_TRUE(outline.contains({50.0, 0.0}));
  EXPECT_FALSE(outline.contains({0.0, 0.0}));
}

TEST(WaterOutline, AConcaveBayIsDryLand) {
  // A U: two arms 10 m wide joined at the foot.
  const WaterOutline outline =
      outlineOf({{{{{0, 0}, {30, 0}, {30, 40}, {20, 40}, {20, 10}, {10, 10}, {10, 40}, {0, 40}}}}});
  EXPECT_TRUE(outline.contains({5.0, 35.0}));
  EXPECT_TRUE(outline.contains({25.0, 35.0}));
  EXPECT_TRUE(outline.contains({15.0, 5.0}));
  EXPECT_FALSE(outline.contains({15.0, 35.0}));
  EXPECT_FALSE(outline.contains({15.0, 10.5}));
}

TEST(WaterOutline, SeveralPolygonsAreAllWater) {
  const WaterOutline outline =
      outlineOf({{{square(10.0)}}, {{square(10.0, {50.0, 0.0})}}, {{square(10.0, {15.0, 0.0})}}});
  for (const double x : {-5.0, 8.0, 15.0, 24.0, 50.0}) EXPECT_TRUE(outline.contains({x, 0.0})) << x;
  for (const double x : {-11.0, 30.0, 61.0}) EXPECT_FALSE(outline.contains({x, 0.0})) << x;
}

TEST(WaterOutline, APointThatIsNotFiniteIsDry) {
  const WaterOutline outline = outlineOf({{{square(1.0)}}});
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const double x : {nan, infinity, -infinity}) {
    EXPECT_FALSE(outline.contains({x, 0.0}));
    EXPECT_FALSE(outline.contains({0.0, x}));
  }
}

/// A shore of `count` points with bays, about `middle`.
Ring roughShore(int count, double radius, glm::dvec2 middle) {
  Ring ring;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    const double r = radius * (1.0 + 0.3 * std::sin(5.0 * angle) + 0.1 * std::sin(37.0 * angle));
    ring.push_back(middle + r * glm::dvec2(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

TEST(WaterOutlineHard, TheIndexAgreesWithARayOverAllEdgesFarFromTheAnchor) {
  const glm::dvec2 middle(180e3, -90e3);
  const std::vector<Ring> rings{roughShore(4001, 5000.0, middle), roughShore(301, 900.0, middle)};
  const WaterOutline outline = outlineOf({{rings}});
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> off(-7500.0, 7500.0);
  int wet = 0;
  for (int i = 0; i < 4000; ++i) {
    const glm::dvec2 point = middle + glm::dvec2(off(random), off(random));
    ASSERT_EQ(outline.contains(point), insideByRay(rings, point)) << point.x << ' ' << point.y;
    wet += outline.contains(point);
  }
  // Within five standard deviations of the count.
  const double share = outline.area() / (15000.0 * 15000.0);
  EXPECT_NEAR(wet, 4000.0 * share, 5.0 * std::sqrt(4000.0 * share * (1.0 - share)));
}

TEST(WaterOutlineHard, PointsThroughVerticesAndAlongEdgesAreOnTheRightSide) {
  // The grid of the index, the edges and the points all share coordinates.
  const WaterOutline outline = outlineOf({{{square(64.0), square(16.0)}}});
  for (int x = -80; x <= 80; ++x) {
    for (int y = -80; y <= 80; ++y) {
      const int far = std::max(std::abs(x), std::abs(y));
      if (far == 64 || far == 16) continue;  // on an edge: either side
      ASSERT_EQ(outline.contains({x, y}), far < 64 && far > 16) << x << ' ' << y;
    }
  }
}

TEST(WaterOutline, BoxesWithoutWaterAreTold) {
  const WaterOutline outline = outlineOf({{{square(1000.0), square(600.0)}}});
  EXPECT_TRUE(outline.mayMeet({-2000.0, -2000.0}, {2000.0, 2000.0}));
  EXPECT_TRUE(outline.mayMeet({790.0, 0.0}, {791.0, 1.0}));
  EXPECT_FALSE(outline.mayMeet({1001.0, -5000.0}, {5000.0, 5000.0}));
  EXPECT_FALSE(outline.mayMeet({-100.0, -100.0}, {100.0, 100.0}));  // the island
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> off(-1300.0, 1300.0), size(0.0, 300.0);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec2 least(off(random), off(random)), most = least + glm::dvec2(size(random));
    if (outline.mayMeet(least, most)) continue;
    for (int k = 0; k < 20; ++k) {
      std::uniform_real_distribution<double> part(0.0, 1.0);
      ASSERT_FALSE(
          outline.contains(least + (most - least) * glm::dvec2(part(random), part(random))));
    }
  }
}

TEST(WaterOutline, DegenerateRingsAreRefused) {
  EXPECT_EQ(faultOf({}), "has no polygon");
  EXPECT_EQ(faultOf({{{}}}), "polygon 0, ring 0: is missing");
  EXPECT_EQ(faultOf({{{{{0, 0}, {1, 0}, {1, 0}, {0, 0}}}}}),
            "polygon 0, ring 0: has 2 different points; needs 3 or more");
  EXPECT_EQ(faultOf({{{square(9.0), {{0, 0}, {1, 1}, {2, 2}}}}}), "polygon 0, ring 1: has no area");
  EXPECT_EQ(faultOf({{{{{0, 0}, {1, std::nan("")}, {1, 1}}}}}),
            "polygon 0, ring 0: has a point that is not finite");
  EXPECT_EQ(faultOf({{{{{0, 0}, {10, 10}, {10, 0}, {0, 4}}}}}),
            "polygon 0: its edges cross each other");
  EXPECT_EQ(faultOf({{{square(9.0), square(3.0, {8.0, 0.0})}}}),
            "polygon 0: its edges cross each other");
}

WaterSurface lake() {
  WaterSurface water{WaveField({makeGroupOctave(0.1, 0.3, 0.03, 0.0, 0.4)})};
  const std::vector<OutlinePolygon> polygons{{{square(100.0)}}};
  water.setOutline(std::make_shared<WaterOutline>(polygons));
  return water;
}

TEST(WaterOutline, QueriesOutsideAreNotANumberAndSayDry) {
  const WaterSurface water = lake();
  const std::vector<glm::dvec2> points{{0.0, 0.0}, {101.0, 0.0}, {99.0, -99.0}, {0.0, 1e6}};
  std::vector<SurfaceSample> samples(points.size());
  water.sample(points, 3.0, samples, {.orbitalVelocity = true});
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool wet = i % 2 == 0;
    const SurfaceSample single = water.at(3.0).sample(points[i]);
    EXPECT_EQ(has(samples[i].status, SampleStatus::dry), !wet);
    EXPECT_EQ(has(single.status, SampleStatus::dry), !wet);
    for (const double value : {samples[i].height, samples[i].slope.x, samples[i].verticalVelocity,
                               samples[i].orbitalVelocity.z, single.height}) {
      EXPECT_EQ(std::isnan(value), !wet);
    }
  }
  EXPECT_EQ(statusText(samples[1].status), "dry");
  EXPECT_EQ(statusText(samples[0].status), "ok");
}

TEST(WaterOutline, WaterInsideHasTheBitsOfASeaWithoutOutline) {
  const WaterSurface bounded = lake(), endless{bounded.waves()};
  for (double x = -90.0; x < 95.0; x += 11.0) {
    EXPECT_EQ(bounded.sample({x, 4.0}, 7.0).height, endless.sample({x, 4.0}, 7.0).height);
  }
}

TEST(WaterOutline, RaysEndOnTheGroundAroundTheWater) {
  const WaterSurface water = lake();
  const SurfaceAtTime now = water.at(2.0);
  const glm::dvec3 down = glm::normalize(glm::dvec3(1.0, 0.0, -1.0));
  ASSERT_TRUE(distanceToWater(now, {50.0, 0.0, 10.0}, down).has_value());
  EXPECT_NEAR(*distanceToWater(now, {50.0, 0.0, 10.0}, down), 10.0 * std::sqrt(2.0), 1.0);
  EXPECT_FALSE(distanceToWater(now, {95.0, 0.0, 10.0}, down).has_value());
  EXPECT_FALSE(distanceToWater(now, {-150.0, 0.0, 10.0}, down).has_value());
  // Over the ground into the lake.
  EXPECT_TRUE(
      distanceToWater(now, {-150.0, 0.0, 10.0}, glm::normalize(glm::dvec3(10.0, 0.0, -1.0))));
}

TEST(WaterOutline, QueriesAllocateNothing) {
  const WaterSurface water = lake();
  const SurfaceAtTime now = water.at(1.0);
  std::vector<glm::dvec2> points(500, glm::dvec2(99.0, 100.0));
  std::vector<SurfaceSample> samples(points.size());
  const auto before = test_support::allocationCount();
  now.sample(points, samples);
  EXPECT_EQ(test_support::allocationCount(), before);
}

}  // namespace
}  // namespace seaway
