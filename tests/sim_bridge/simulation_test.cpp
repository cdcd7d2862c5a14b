#include "sim_bridge/simulation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim_bridge/scene/scene_loader.h"
#include "surface/angles.h"
#include "surface/input_error.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

using Replacements = std::vector<std::pair<std::string, std::string>>;

Scene sceneWith(const Replacements& replacements = {}) {
  const test::TempFolder folder;
  return loadScene(test::writeScene(folder, replacements));
}

// Metres north and east of the start, from WGS84's radii of curvature there: good to d²/R, under
// 2 mm at 120 m.
glm::dvec2 metresFrom(double latitude_deg, double longitude_deg, const GeodeticPosition& place) {
  const double e2 = 0.00669437999014;
  const double s = std::sin(radiansFromDegrees(latitude_deg));
  const double w = std::sqrt(1.0 - e2 * s * s);
  const double meridional = 6378137.0 * (1.0 - e2) / (w * w * w);
  const double normal = 6378137.0 / w;
  return {radiansFromDegrees(place.latitude_deg - latitude_deg) * meridional,
          radiansFromDegrees(place.longitude_deg - longitude_deg) * normal *
              std::cos(radiansFromDegrees(latitude_deg))};
}

GeodeticPosition placeOf(const Simulation& simulation) {
  return simulation.sea().geodesy.geodeticFromSeaPlane(simulation.vessels()[0].pose().position);
}

TEST(Simulation, StraightVesselSailsItsTrueHeading) {
  const Scene scene = sceneWith({{"turn_deg_s: 1", "turn_deg_s: 0"}});
  const Sea sea = buildSea(scene);
  const Simulation moved = Simulation(scene, sea).movedTo(20.0);
  const glm::dvec2 track = metresFrom(28.878, -78.467, placeOf(moved));
  EXPECT_NEAR(track.x, 120.0 * std::cos(radiansFromDegrees(30.0)), 2e-3);
  EXPECT_NEAR(track.y, 120.0 * std::sin(radiansFromDegrees(30.0)), 2e-3);
}

TEST(Simulation, TurningVesselSailsAnArcToStarboard) {
  const Scene scene = sceneWith();
  const Sea sea = buildSea(scene);
  const Simulation moved = Simulation(scene, sea).movedTo(20.0);
  const double radius = 6.0 / radiansFromDegrees(1.0);
  const double from = radiansFromDegrees(30.0);
  const double to = radiansFromDegrees(50.0);
  const glm::dvec2 track = metresFrom(28.878, -78.467, placeOf(moved));
  EXPECT_NEAR(track.x, radius * (std::sin(to) - std::sin(from)), 2e-3);
  EXPECT_NEAR(track.y, radius * (std::cos(from) - std::cos(to)), 2e-3);
  const VesselPose pose = moved.vessels()[0].pose();
  // 120 m east turn the meridian by 6e-4 degrees.
  EXPECT_NEAR(sea.geodesy.trueHeadingFromDirection(pose.position, pose.direction), 50.0, 1e-3);
}

TEST(SimulationHard, HeadingIsTrueNorthFarFromTheAnchor) {
  const Scene scene = sceneWith({{"anchor: {latitude_deg: 28.878, longitude_deg: -78.467}",
                                  "anchor: {latitude_deg: 60, longitude_deg: 0}"},
                                 {"latitude_deg: 28.878, longitude_deg: -78.467, heading_deg: 30",
                                  "latitude_deg: 60, longitude_deg: 2.7, heading_deg: 30"}});
  const Sea sea = buildSea(scene);
  const Simulation simulation(scene, sea);
  const VesselPose pose = simulation.vessels()[0].pose();
  EXPECT_NEAR(sea.geodesy.trueHeadingFromDirection(pose.position, pose.direction), 30.0, 1e-9);
  // Grid convergence there is about 2.7° sin 60°.
  EXPECT_NEAR(30.0 - degreesFromRadians(pi / 2.0 - pose.direction), 2.34, 0.05);
}

TEST(Simulation, SameSceneGivesTheSameBitsHoweverItIsStepped) {
  const Scene scene = sceneWith();
  const Sea sea = buildSea(scene);
  Simulation stepped(scene, sea);
  for (int i = 0; i < 250; ++i) stepped.step();
  const Simulation replayed = Simulation::replayed(scene, sea, 5.0);
  const VesselPose a = stepped.vessels()[0].pose();
  const VesselPose b = replayed.vessels()[0].pose();
  EXPECT_EQ(stepped.time(), replayed.time());
  EXPECT_EQ(a.height, b.height);
  EXPECT_EQ(a.roll, b.roll);
  EXPECT_EQ(a.pitch, b.pitch);
  EXPECT_EQ(a.position, b.position);
}

TEST(Simulation, LookingAtAMomentBetweenStepsDoesNotChangeTheMotion) {
  const Scene scene = sceneWith();
  const Sea sea = buildSea(scene);
  Simulation watched(scene, sea);
  Simulation alone(scene, sea);
  for (int i = 0; i < 50; ++i) {
    const Simulation moment = watched.movedTo(watched.time() + 0.007);
    EXPECT_NEAR(moment.time(), watched.time() + 0.007, 1e-12);
    watched.step();
    alone.step();
  }
  EXPECT_EQ(watched.vessels()[0].pose().roll, alone.vessels()[0].pose().roll);
}

TEST(Simulation, FarReplayForgetsTheStart) {
  const Scene scene = sceneWith({{"speed_m_s: 6", "speed_m_s: 1"}});
  const Sea sea = buildSea(scene);
  Simulation whole(scene, sea);
  whole.stepTo(700.0);
  const Simulation recent = Simulation::replayed(scene, sea, 700.0);  // from 100 s on
  EXPECT_NEAR(whole.vessels()[0].pose().roll, recent.vessels()[0].pose().roll, 1e-9);
  EXPECT_NEAR(whole.vessels()[0].pose().height, recent.vessels()[0].pose().height, 1e-9);
}

TEST(Simulation, MotionSwitchedOffKeepsVesselsUpright) {
  const Scene scene = sceneWith({{"run:", "effects: {vessel_motion: off}\nrun:"}});
  const Sea sea = buildSea(scene);
  const Simulation moved = Simulation(scene, sea).movedTo(3.0);
  EXPECT_EQ(moved.vessels()[0].pose().height, 0.0);
  EXPECT_EQ(moved.vessels()[0].pose().roll, 0.0);
  EXPECT_NE(moved.vessels()[0].waterHeight(), 0.0);
}

TEST(Simulation, LedgerTellsOfWavesAndMotion) {
  const Scene scene = sceneWith();
  const Sea sea = buildSea(scene);
  EffectLedger ledger(scene.effects);
  Simulation(scene, sea).step(&ledger);
  for (const EffectReport& report : ledger.report()) {
    const bool runs = report.effect == Effect::waves || report.effect == Effect::vesselMotion ||
                      report.effect == Effect::trail;
    EXPECT_EQ(report.state, runs ? EffectState::on : EffectState::idle);
  }
}

TEST(SimulationHard, VesselThatLeavesTheGeodesysRangeIsReported) {
  const Scene scene = sceneWith({{"start: {latitude_deg: 28.878", "start: {latitude_deg: 33.385"},
                                 {"heading_deg: 30", "heading_deg: 0"},
                                 {"speed_m_s: 6", "speed_m_s: 60"},
                                 {"turn_deg_s: 1", "turn_deg_s: 0"}});
  const Sea sea = buildSea(scene);
  Simulation simulation(scene, sea);
  EXPECT_THROW(simulation.stepTo(60.0), InputError);
}

}  // namespace
}  // namespace seaway::bridge
