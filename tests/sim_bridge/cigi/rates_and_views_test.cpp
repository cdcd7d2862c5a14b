#include "sim_bridge/cigi/host_views.h"
#include "surface/angles.h"
#include "tests/sim_bridge/cigi/session_fixture.h"

/// Entities that go on by their rates, and what a host sees.
namespace seaway::bridge::cigi {
namespace {

class CigiRates : public test::SessionTest {
 protected:
  CigiRates() { make(synchronous()); }
  static EntityControl ship() {
    return {.entity = 0, .state = 1, .yaw = 90.0f, .latitude = 0.0, .longitude = 1.0};
  }
  void frame(std::uint32_t number, double t, std::vector<Packet> packets) {
    hostTime = t;
    give(number, std::move(packets));
  }
  /// Metres east of where it began, on the equator of WGS84.
  double east() const {
    return (water.entities.at(0).place.longitude_deg - 1.0) * pi / 180.0 * 6378137.0;
  }
};
using CigiRatesHard = CigiRates;

TEST_F(CigiRates, AnEntityGoesOnAlongItsBodyUntilItIsToldOtherwise) {
  frame(1, 0.0, {ship(), RateControl{.entity = 0, .bodyAxes = true, .x = 8.0f}});
  EXPECT_NEAR(east(), 0.0, 1e-6);
  for (std::uint32_t i = 1; i <= 50; ++i) frame(1 + i, 0.1 * i, {});
  EXPECT_NEAR(east(), 40.0, 1e-4);
  frame(60, 6.0, {RateControl{.entity = 0}});
  EXPECT_NEAR(east(), 48.0, 1e-4);
  frame(61, 9.0, {});
  EXPECT_NEAR(east(), 48.0, 1e-4);
}

TEST_F(CigiRates, APositionThatAFrameBringsCountsAndWorldRatesGoNorthEastDown) {
  frame(1, 0.0, {ship(), RateControl{.entity = 0, .x = 3.0f, .y = 4.0f, .z = -1.0f}});
  frame(2, 2.0, {});
  EXPECT_NEAR(east(), 8.0, 1e-4);
  // 6335.4 km: radius of curvature of the meridian at the equator.
  EXPECT_NEAR(water.entities.at(0).place.latitude_deg * pi / 180.0 * 6335439.0, 6.0, 1e-3);
  EXPECT_NEAR(water.entities.at(0).height, 2.0 - 10.0, 1e-9);  // the water level is 10 m
  frame(3, 3.0, {ship()});
  EXPECT_NEAR(east(), 0.0, 1e-6);
}

// A turn of 90° in 10 s at 10 m/s is a quarter of a circle of radius v/ω = 63.66 m.
TEST_F(CigiRates, ASteadyTurnIsACircle) {
  frame(1, 0.0, {ship(), RateControl{.entity = 0, .bodyAxes = true, .x = 10.0f, .yaw = 9.0f}});
  for (std::uint32_t i = 1; i <= 600; ++i) frame(1 + i, i / 60.0, {});
  const double radius = 10.0 / radiansFromDegrees(9.0);
  // Chords of 1/60 s are short of their arc by (ωΔt)²/24 of it, 3e-7; headings are rounded as
  // below.
  EXPECT_NEAR(east(), radius, 1e-3);
  // 600 additions in single precision, each rounded by up to 8e-6°.
  EXPECT_NEAR(water.entities.at(0).heading_deg, 180.0, 5e-3);
}

TEST_F(CigiRates, AnOwnClocksTicksMoveEntitiesBetweenFrames) {
  SessionOptions options = asynchronous();
  options.hostClock = false;
  make(options);
  give(1, {ship(), RateControl{.entity = 0, .bodyAxes = true, .x = 6.0f}}, 100.0);
  for (int i = 1; i <= 30; ++i) tick(100.0 + 0.1 * i);
  EXPECT_NEAR(east(), 18.0, 1e-4);
  EXPECT_EQ(water.entityTimes.back(), 103.0);
}

TEST_F(CigiRatesHard, RatesThatCannotBeAndTimesThatLeapMoveNothing) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  frame(1, 0.0,
        {ship(), RateControl{.entity = 0, .bodyAxes = true, .x = nan},
         RateControl{.entity = 77, .x = 5.0f},
         RateControl{.entity = 0, .part = 3, .toPart = true, .x = 5.0f}});
  frame(2, 1.0, {});
  EXPECT_NEAR(east(), 0.0, 1e-6);
  frame(3, 1.0, {RateControl{.entity = 0, .bodyAxes = true, .x = 5.0f}});
  frame(4, 1000.0, {});
  EXPECT_NEAR(east(), 0.0, 1e-6);
  frame(5, 900.0, {});
  EXPECT_NEAR(east(), 0.0, 1e-6);
  frame(6, 901.0, {EntityControl{.entity = 0, .state = 2}});
  frame(7, 902.0, {ship()});
  frame(8, 903.0, {});
  EXPECT_NEAR(east(), 0.0, 1e-6);
}

TEST(CigiHostViews, KeepWhatAPacketDoesNotEnable) {
  HostViews views;
  views.set(ViewControl{.view = 2,
                        .xEnabled = true,
                        .pitchEnabled = true,
                        .entity = 1,
                        .x = 4.0f,
                        .y = 9.0f,
                        .pitch = -5.0f});
  EXPECT_TRUE(views.set(ViewDefinition{
      .view = 2, .topEnabled = true, .bottomEnabled = true, .top = 20.0f, .bottom = -20.0f}));
  views.set(ViewControl{.view = 2, .yawEnabled = true, .entity = 1, .yaw = 30.0f});
  const HostView& view = views.views().at(2);
  EXPECT_EQ(view.x, 4.0);
  EXPECT_EQ(view.y, 0.0);
  EXPECT_EQ(view.pitch_deg, -5.0);
  EXPECT_EQ(view.yaw_deg, 30.0);
  EXPECT_EQ(view.top_deg - view.bottom_deg, 40.0);
  EXPECT_TRUE(view.isCentred());
}

TEST(CigiHostViews, AGroupsPacketIsForAllViewsInIt) {
  HostViews views;
  for (const std::uint16_t number : {1, 2, 3}) {
    views.set(
        ViewDefinition{.view = number, .group = static_cast<std::uint8_t>(number == 3 ? 0 : 7)});
  }
  views.set(ViewControl{.view = 1, .entity = 4});
  views.set(ViewControl{.view = 3, .entity = 4});
  views.set(ViewControl{.view = 0, .group = 7, .zEnabled = true, .entity = 5, .z = -2.0f});
  EXPECT_EQ(views.views().at(1).entity, 5);
  EXPECT_EQ(views.views().at(2).z, -2.0);
  EXPECT_EQ(views.views().at(3).entity, 4);
}

TEST(CigiHostViewsHard, WindowsThatCannotBeDrawnChangeNothing) {
  HostViews views;
  EXPECT_FALSE(views.set(ViewDefinition{.view = 1, .orthographic = true}));
  EXPECT_FALSE(views.set(ViewDefinition{.view = 1, .mirror = 1}));
  EXPECT_FALSE(views.set(ViewDefinition{.view = 1, .topEnabled = true, .top = 89.0f}));
  EXPECT_FALSE(views.set(ViewDefinition{
      .view = 1, .topEnabled = true, .bottomEnabled = true, .top = -10.0f, .bottom = 10.0f}));
  EXPECT_TRUE(views.views().empty());
  for (std::uint16_t i = 0; i < 1000; ++i) views.set(ViewControl{.view = i});
  EXPECT_LE(views.views().size(), 64u);
}

}  // namespace
}  // namespace seaway::bridge::cigi
