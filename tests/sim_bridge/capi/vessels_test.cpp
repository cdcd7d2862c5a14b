#include <algorithm>
#include <cmath>

#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/simulation.h"
#include "tests/sim_bridge/capi/support.h"

namespace seaway::bridge::test {
namespace {

seaway_pose poseOf(const seaway_sea* sea, std::size_t vessel) {
  seaway_pose pose = seaway_pose_default();
  EXPECT_EQ(seaway_sea_vessel_pose(sea, vessel, &pose), SEAWAY_OK) << seaway_last_error();
  return pose;
}

double highestOf(const std::vector<double>& heights) {
  double highest = 0.0;
  for (const double height : heights) highest = std::max(highest, std::abs(height));
  return highest;
}

/// The drifter is sailed by its host along its own bow for `seconds`, 6 m/s; the sea is stepped.
void sailDrifter(seaway_sea* sea, double seconds) {
  const seaway_pose start = poseOf(sea, 1);
  for (double t = 0.1; t <= seconds + 1e-9; t += 0.1) {
    seaway_pose pose = seaway_pose_default();
    pose.east = start.east;
    pose.north = start.north + 6.0 * t;
    ASSERT_EQ(seaway_sea_place_vessel(sea, 1, t, &pose), SEAWAY_OK) << seaway_last_error();
    ASSERT_EQ(seaway_sea_step_to(sea, t), SEAWAY_OK) << seaway_last_error();
  }
}

TEST(CapiVessels, AreFoundByName) {
  const SeaPointer sea = seaFrom(boats);
  std::size_t vessel = 77;
  ASSERT_EQ(seaway_sea_find_vessel(sea.get(), "drifter", &vessel), SEAWAY_OK);
  EXPECT_EQ(vessel, 1u);
  EXPECT_EQ(seaway_sea_find_vessel(sea.get(), "drifer", &vessel), SEAWAY_NOT_FOUND);
  EXPECT_NE(std::string(seaway_last_error()).find("did you mean 'drifter'"), std::string::npos);
  EXPECT_EQ(vessel, 1u);
}

TEST(CapiVessels, SailAsTheSimulationHasThem) {
  const SeaPointer sea = seaFrom(boats);
  ASSERT_EQ(seaway_sea_step_to(sea.get(), 3.0), SEAWAY_OK);
  const Scene scene = sceneFromText(boats, SEAWAY_SOURCE_DIR "/configs/scenes");
  const Sea truth = buildSea(scene);
  Simulation simulation(scene, truth);
  simulation.stepTo(3.0);
  const auto expected = simulation.vessels()[0].pose();
  const seaway_pose pose = poseOf(sea.get(), 0);
  EXPECT_EQ(pose.east, expected.position.x);
  EXPECT_EQ(pose.north, expected.position.y);
  EXPECT_EQ(pose.height, expected.height);
  EXPECT_NEAR(pose.heading_deg, 0.0, 1e-6);
  EXPECT_NEAR(pose.latitude_deg, 51.98 + 18.0 / 111.27e3, 1e-6);
}

TEST(CapiVessels, AreWhereTheirHostPlacesThem) {
  const SeaPointer sea = seaFrom(boats);
  seaway_pose pose = seaway_pose_default();
  pose.frame = SEAWAY_GEODETIC;
  pose.latitude_deg = 51.981;
  pose.longitude_deg = 4.051;
  pose.height = 0.3;
  pose.heading_deg = 250.0;
  pose.pitch_deg = 2.0;
  pose.roll_deg = -3.0;
  ASSERT_EQ(seaway_sea_place_vessel(sea.get(), 1, 0.1, &pose), SEAWAY_OK) << seaway_last_error();
  ASSERT_EQ(seaway_sea_step_to(sea.get(), 0.1), SEAWAY_OK);
  const seaway_pose now = poseOf(sea.get(), 1);
  EXPECT_NEAR(now.latitude_deg, 51.981, 1e-9);
  EXPECT_NEAR(now.longitude_deg, 4.051, 1e-9);
  EXPECT_NEAR(now.height, 0.3, 1e-12);
  EXPECT_NEAR(now.heading_deg, 250.0, 1e-9);
  EXPECT_NEAR(now.pitch_deg, 2.0, 1e-12);
  EXPECT_NEAR(now.roll_deg, -3.0, 1e-12);
}

TEST(CapiVessels, LieBetweenTheirHostsPoses) {
  const SeaPointer sea = seaFrom(boats);
  const seaway_pose start = poseOf(sea.get(), 1);
  for (const double t : {0.2, 0.4}) {
    seaway_pose pose = start;
    pose.east = start.east + 10.0 * t;
    pose.heading_deg = t == 0.2 ? 350.0 : 10.0;
    ASSERT_EQ(seaway_sea_place_vessel(sea.get(), 1, t, &pose), SEAWAY_OK) << seaway_last_error();
  }
  ASSERT_EQ(seaway_sea_step_to(sea.get(), 0.3), SEAWAY_OK);
  EXPECT_NEAR(poseOf(sea.get(), 1).east, start.east + 3.0, 1e-9);
  EXPECT_NEAR(std::cos(poseOf(sea.get(), 1).heading_deg * M_PI / 180.0), 1.0, 1e-9);
  // After the last pose on for a second, then at rest.
  ASSERT_EQ(seaway_sea_step_to(sea.get(), 3.0), SEAWAY_OK);
  EXPECT_NEAR(poseOf(sea.get(), 1).east, start.east + 14.0, 1e-6);
}

TEST(CapiVessels, LeaveTheWakeOfTheirHostsTrack) {
  const SeaPointer sea = seaFrom(boats);
  const seaway_pose start = poseOf(sea.get(), 1);
  // 30 m east of the drifter's track, far from the pilot's.
  const seaway_listener listener{start.east + 12.0, start.north + 20.0, 40.0};
  ASSERT_EQ(seaway_sea_listen(sea.get(), 1, &listener), SEAWAY_OK) << seaway_last_error();
  ASSERT_NO_FATAL_FAILURE(sailDrifter(sea.get(), 8.0));
  Line beside(60);
  for (std::size_t i = 0; i < 60; ++i) {
    beside.east[i] = start.east + 4.0;
    beside.north[i] = start.north + 0.7 * static_cast<double>(i);
  }
  seaway_sample_options options = seaway_sample_options_default();
  options.own_vessel = 1;  // not the pilot's
  const double felt = highestOf(heightsOf(sea.get(), 8.0, beside.points(), &options));
  EXPECT_GT(felt, 0.05);  // a 12 m launch at 6 m/s leaves waves of some decimetres
  const SeaPointer idle = seaFrom(boats);
  ASSERT_EQ(seaway_sea_listen(idle.get(), 1, &listener), SEAWAY_OK);
  ASSERT_EQ(seaway_sea_step_to(idle.get(), 8.0), SEAWAY_OK);
  EXPECT_EQ(highestOf(heightsOf(idle.get(), 8.0, beside.points(), &options)), 0.0);
}

TEST(CapiVessels, DoNotFeelTheirOwnWake) {
  const SeaPointer sea = seaFrom(boats);
  ASSERT_NO_FATAL_FAILURE(sailDrifter(sea.get(), 6.0));
  const seaway_pose pose = poseOf(sea.get(), 1);
  Line astern(40);
  for (std::size_t i = 0; i < 40; ++i) {
    astern.east[i] = pose.east;
    astern.north[i] = pose.north - 0.5 * static_cast<double>(i);
  }
  const seaway_points points = astern.points();
  seaway_sample_options options = seaway_sample_options_default();
  const std::vector<double> all = heightsOf(sea.get(), 6.0, points, &options);
  options.own_vessel = 2;
  const std::vector<double> others = heightsOf(sea.get(), 6.0, points, &options);
  double difference = 0.0;
  for (std::size_t i = 0; i < 40; ++i)
    difference = std::max(difference, std::abs(all[i] - others[i]));
  EXPECT_GT(difference, 0.05);
}

TEST(CapiVesselsHard, RefusePosesThatCannotBe) {
  const SeaPointer sea = seaFrom(boats);
  const seaway_pose start = poseOf(sea.get(), 1);
  const auto place = [&](double t, const seaway_pose& pose) {
    return seaway_sea_place_vessel(sea.get(), 1, t, &pose);
  };
  seaway_pose pose = start;
  EXPECT_EQ(place(NAN, pose), SEAWAY_BAD_ARGUMENT);
  EXPECT_EQ(place(-0.1, pose), SEAWAY_BAD_ARGUMENT);  // before the sea's time
  for (double seaway_pose::*member :
       {&seaway_pose::east, &seaway_pose::height, &seaway_pose::heading_deg}) {
    pose = start;
    pose.*member = NAN;
    EXPECT_EQ(place(0.1, pose), SEAWAY_BAD_ARGUMENT);
  }
  pose = start;
  pose.east = 600e3;
  EXPECT_EQ(place(0.1, pose), SEAWAY_BAD_ARGUMENT);
  pose = start;
  pose.frame = 2;
  EXPECT_EQ(place(0.1, pose), SEAWAY_BAD_ARGUMENT);
  EXPECT_EQ(place(0.1, start), SEAWAY_OK);
  EXPECT_EQ(place(0.1, start), SEAWAY_BAD_ARGUMENT);  // no later than the last
  EXPECT_EQ(seaway_sea_place_vessel(sea.get(), 2, 0.2, &start), SEAWAY_NOT_FOUND);
  EXPECT_EQ(seaway_sea_step_to(sea.get(), 0.2), SEAWAY_OK);
}

}  // namespace
}  // namespace seaway::bridge::test
