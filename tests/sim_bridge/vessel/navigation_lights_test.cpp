#include "sim_bridge/vessel/navigation_lights.h"

#include <gtest/gtest.h>

#include "render/shading/shading_constants.h"
#include "surface/angles.h"

namespace seaway::bridge {
namespace {

VesselModel workboat() {
  VesselModel model;
  model.hull.length = 24.0;
  model.hull.beam = 7.5;
  model.hull.depth = 4.2;
  model.hull.givenDraft = 1.3;
  return model;
}

/// Colours seen from a compass bearing off the bow, 500 m off: R, G and W for each lamp that shows.
std::string coloursFrom(double fromBow_deg, bool isUnderWay,
                        const VesselModel& model = workboat()) {
  VesselPose pose;
  pose.direction = 0.7;
  std::vector<render::Lamp> lamps;
  addNavigationLights(model, pose, isUnderWay, lamps);
  const glm::dvec3 ahead = pose.worldFromBody() * glm::dvec3(1.0, 0.0, 0.0);
  const double direction = std::atan2(ahead.y, ahead.x) - radiansFromDegrees(fromBow_deg);
  const glm::dvec3 eye(500.0 * unitVector(direction), 5.0);
  std::string seen;
  for (const render::Lamp& lamp : lamps) {
    if (render::shownPart(lamp, eye) < 0.5) continue;
    const bool red = lamp.colour.r > 4.0f * lamp.colour.g,
               green = lamp.colour.g > 4.0f * lamp.colour.r;
    seen += red ? 'R' : green ? 'G' : 'W';
  }
  return seen;
}

TEST(NavigationLights, ShowByTheArcsOfTheRegulations) {
  // Masthead 225°, sidelights 112.5°, stern 135°; positive bearings are to starboard.
  EXPECT_EQ(coloursFrom(0.0, true), "WRG");
  EXPECT_EQ(coloursFrom(45.0, true), "WG");
  EXPECT_EQ(coloursFrom(110.0, true), "WG");
  EXPECT_EQ(coloursFrom(-45.0, true), "WR");
  EXPECT_EQ(coloursFrom(-110.0, true), "WR");
  EXPECT_EQ(coloursFrom(120.0, true), "W");
  EXPECT_EQ(coloursFrom(180.0, true), "W");
}

TEST(NavigationLights, AtAnchorOneShowsAllRoundAndNoneWhereTheModelSaysSo) {
  for (const double bearing : {0.0, 90.0, 180.0, -100.0}) {
    EXPECT_EQ(coloursFrom(bearing, false), "W") << bearing;
  }
  VesselModel model = workboat();
  model.lights.shown = LightsShown::none;
  EXPECT_EQ(coloursFrom(0.0, true, model), "");
  model.lights.shown = LightsShown::underWay;
  EXPECT_EQ(coloursFrom(0.0, false, model), "WRG");
}

TEST(NavigationLights, StandWhereTheModelPutsThemElseOnTheHull) {
  VesselModel model = workboat();
  std::vector<render::Lamp> lamps;
  addNavigationLights(model, {}, true, lamps);
  ASSERT_EQ(lamps.size(), 4u);
  for (const render::Lamp& lamp : lamps) {
    EXPECT_GT(lamp.position.z, 1.0);
    EXPECT_LE(glm::length(lamp.position), 0.55 * 24.0);
  }
  EXPECT_GT(lamps[0].position.z, lamps[1].position.z);  // the masthead light is highest
  EXPECT_DOUBLE_EQ(lamps[1].position.z, lamps[2].position.z);
  model.lights.masthead = {1.0, 0.0, 9.0};
  lamps.clear();
  VesselPose pose;
  pose.position = {100.0, 50.0};
  addNavigationLights(model, pose, true, lamps);
  EXPECT_NEAR(lamps[0].position.z, 9.0, 1e-12);
  EXPECT_NEAR(glm::length(glm::dvec2(lamps[0].position) - pose.position), 1.0, 1e-12);
}

}  // namespace
}  // namespace seaway::bridge
