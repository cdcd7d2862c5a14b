#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim_bridge/cigi/sea_water.h"
#include "surface/input_error.h"
#include "tests/sim_bridge/service/served_waters.h"

namespace seaway::bridge::cigi {
namespace {

struct Viewed {
  Viewed() : waters(test::pilotScene("effects: {wake: off}\n", "0")) {}
  HostEntity ship(glm::dvec2 place, double heading_deg) const {
    const HostedPose pose = waters.poseAt(place, heading_deg);
    return {
        .entity = 0, .place = {pose.latitude_deg, pose.longitude_deg}, .heading_deg = heading_deg};
  }
  test::ServedWaters waters;
  FrameMaker frames{waters.sea};
  SeaWater water{waters.sea, &frames};
};

// Two hosts sail a hull each of the same vessel; each sees the buoy from its own.
TEST(CigiSeaWaterViews, EachHostsViewStandsOnItsOwnHull) {
  Viewed viewed;
  const HostEntity towards = viewed.ship({40.0, -60.0}, 0.0);  // the buoy lies ahead
  const HostEntity away = viewed.ship({40.0, -60.0}, 180.0);
  viewed.water.entitiesAt(1, 0.0, std::span(&towards, 1));
  viewed.water.entitiesAt(2, 0.0, std::span(&away, 1));
  for (const std::uint32_t host : {1u, 2u}) {
    viewed.water.viewAsked(
        host, {.view = 3, .xEnabled = true, .zEnabled = true, .entity = 0, .x = 9.0f, .z = -4.0f});
    viewed.water.viewDefined(
        host,
        {.view = 3, .topEnabled = true, .bottomEnabled = true, .top = 15.0f, .bottom = -15.0f});
  }
  const auto objectsOf = [&](const std::string& camera) {
    const auto frame = viewed.frames.draw({.camera = camera, .t = 0.0, .size = {160, 120}});
    // In the middle third: the hull under the eye is behind it or at the lower rim.
    std::size_t count = 0;
    for (int y = 40; y < 80; ++y) {
      for (int x = 53; x < 107; ++x) {
        const auto at = static_cast<std::size_t>(y * 160 + x);
        count += frame->classes[at] == render::PixelClass::object ? 1 : 0;
      }
    }
    return count;
  };
  EXPECT_GT(objectsOf("cigi:1:3"), 20u);
  EXPECT_EQ(objectsOf("cigi:2:3"), 0u);
}

TEST(CigiSeaWaterViews, AWindowThatIsNotCentredShowsThingsWhereItsEdgesPutThem) {
  Viewed viewed;
  const HostEntity towards = viewed.ship({40.0, -60.0}, 0.0);  // the buoy lies ahead
  viewed.water.entitiesAt(1, 0.0, std::span(&towards, 1));
  const auto define = [&](std::uint16_t view, float left, float right) {
    viewed.water.viewAsked(
        1, {.view = view, .xEnabled = true, .zEnabled = true, .entity = 0, .x = 9.0f, .z = -4.0f});
    viewed.water.viewDefined(1, {.view = view,
                                 .leftEnabled = true,
                                 .rightEnabled = true,
                                 .topEnabled = true,
                                 .bottomEnabled = true,
                                 .left = left,
                                 .right = right,
                                 .top = 15.0f,
                                 .bottom = -15.0f});
  };
  // Mean column of the buoy, above the hull at the lower rim.
  const auto columnOf = [&](std::uint16_t view) {
    const auto frame = viewed.frames.draw(
        {.camera = "cigi:1:" + std::to_string(view), .t = 0.0, .size = {160, 120}});
    double columns = 0.0, count = 0.0;
    for (int y = 40; y < 80; ++y) {
      for (int x = 0; x < 160; ++x) {
        if (frame->classes[static_cast<std::size_t>(y * 160 + x)] != render::PixelClass::object)
          continue;
        columns += x;
        count += 1.0;
      }
    }
    EXPECT_GT(count, 10.0);
    return columns / count;
  };
  const auto tangent = [](double degrees) { return std::tan(degrees * std::acos(-1.0) / 180.0); };
  define(4, -10.0f, 20.0f);
  define(5, -20.0f, 10.0f);
  const double first = columnOf(4), second = columnOf(5);
  // Both have the same ray there, by their own edges; pixels are a hundredth of a radian and less.
  const auto rayOf = [&](double column, double left, double right) {
    return tangent(left) + (column + 0.5) / 160.0 * (tangent(right) - tangent(left));
  };
  EXPECT_NEAR(rayOf(first, -10.0, 20.0), rayOf(second, -20.0, 10.0), 0.004);
  EXPECT_GT(second, first + 40.0);
}

TEST(CigiSeaWaterViews, AreGoneWithTheirHost) {
  Viewed viewed;
  viewed.water.viewAsked(1, {.view = 0, .entity = 0});
  viewed.water.viewAsked(1, {.view = 1, .entity = 9});  // no vessel of the scene
  EXPECT_EQ(viewed.frames.cameras(), (std::vector<std::string>{"bow", "mast", "cigi:1:0"}));
  viewed.water.hostGone(1);
  EXPECT_EQ(viewed.frames.cameras(), (std::vector<std::string>{"bow", "mast"}));
}

TEST(CigiSeaWater, AClampedEntityFloatsOnTheWater) {
  Viewed viewed;
  viewed.waters.sea.setOctaves({makeRegularWave(1.0, 1.0 / 8.0, 0.0, 0.0)});
  HostEntity ship = viewed.ship({30.0, 0.0}, 90.0);
  ship.clamp = 2;
  ship.height = 0.5;
  viewed.water.entitiesAt(1, 2.0, std::span(&ship, 1));
  const ServedHull hull = viewed.waters.sea.hulls(2.0).at(0);
  const SurfaceSample water = viewed.waters.sea.surface()->sample({30.0, 0.0}, 2.0);
  // A wave of 100 m under a hull of 12 m: smoothed by a fortieth.
  EXPECT_NEAR(hull.pose.height, water.height + 0.5, 0.03);
  EXPECT_NEAR(std::tan(hull.pose.pitch), water.slope.x, 0.003);
}

}  // namespace
}  // namespace seaway::bridge::cigi
