#include "sim_bridge/vessel/hosted_vessel.h"

#include <gtest/gtest.h>

#include <cmath>

#include "surface/constants.h"

namespace seaway::bridge {
namespace {

BoxHull launch() {
  BoxHull hull;
  hull.length = 12.0;
  hull.beam = 3.6;
  hull.depth = 2.0;
  hull.givenDraft = 0.55;
  hull.centreOfGravityAboveKeel = 1.25;
  return hull;
}

VesselPose at(double x, double y, double direction = 0.0) { return {{x, y}, direction, 0, 0, 0}; }

HostedVessel hostedAt(const VesselPose& now) {
  return HostedVessel(launch(), 10.0, now, VesselTrack(Course({0, 0}, 0.0, 0.0, 0.0)));
}

TEST(HostedVessel, LiesOnTheStraightLineBetweenItsHostsPoses) {
  HostedVessel vessel = hostedAt(at(0, 0, 3.0));
  ASSERT_TRUE(vessel.place(11.0, at(4, 2, -3.0)));
  vessel.moveTo(10.5);
  EXPECT_NEAR(vessel.pose().position.x, 2.0, 1e-12);
  EXPECT_NEAR(vessel.pose().position.y, 1.0, 1e-12);
  // The short way round: half of 2π − 6 on from 3.
  EXPECT_NEAR(std::remainder(vessel.pose().direction - pi, 2.0 * pi), 0.0, 1e-12);
}

TEST(HostedVessel, GoesOnForASecondAfterTheLastPoseAndRests) {
  HostedVessel vessel = hostedAt(at(0, 0));
  ASSERT_TRUE(vessel.place(11.0, at(5, 0)));
  vessel.moveTo(11.5);
  EXPECT_NEAR(vessel.pose().position.x, 7.5, 1e-12);
  EXPECT_NEAR(vessel.speed(), 5.0, 1e-9);
  vessel.moveTo(15.0);
  EXPECT_NEAR(vessel.pose().position.x, 10.0, 1e-12);
  EXPECT_EQ(vessel.speed(), 0.0);
}

TEST(HostedVessel, StaysWhereItIsUntilALeapAndHasNoSpeedFromIt) {
  HostedVessel vessel = hostedAt(at(0, 0));
  ASSERT_TRUE(vessel.place(11.0, at(1000, 0)));
  vessel.moveTo(10.99);
  EXPECT_EQ(vessel.pose().position.x, 0.0);
  vessel.moveTo(11.0);
  EXPECT_EQ(vessel.pose().position.x, 1000.0);
  EXPECT_EQ(vessel.speed(), 0.0);
}

TEST(HostedVessel, TakesPosesAtRisingTimesAlone) {
  HostedVessel vessel = hostedAt(at(0, 0));
  EXPECT_FALSE(vessel.place(9.9, at(1, 0)));
  EXPECT_TRUE(vessel.place(10.0, at(1, 0)));
  EXPECT_FALSE(vessel.place(10.0, at(2, 0)));
  EXPECT_TRUE(vessel.place(10.1, at(2, 0)));
  EXPECT_FALSE(vessel.place(10.05, at(3, 0)));
  EXPECT_EQ(vessel.pose().position.x, 1.0);
}

TEST(HostedVesselHard, HoldsNoMoreForAHostThatIsNeverSteppedTo) {
  HostedVessel vessel = hostedAt(at(0, 0));
  for (int i = 1; i <= 20'000; ++i) ASSERT_TRUE(vessel.place(10.0 + 1e-3 * i, at(1e-3 * i, 0)));
  const std::size_t memory = vessel.memoryBytes();
  for (int i = 20'001; i <= 40'000; ++i) {
    ASSERT_TRUE(vessel.place(10.0 + 1e-3 * i, at(1e-3 * i, 0)));
  }
  EXPECT_EQ(vessel.memoryBytes(), memory);
  vessel.moveTo(50.0);
  EXPECT_NEAR(vessel.pose().position.x, 40.0, 1e-9);
}

TEST(HostedVessel, CarriesTheWaterThatItsBoxDisplaces) {
  HostedVessel vessel = hostedAt(at(0, 0));
  const WaterSurface calm{WaveField({})};
  vessel.readWater(calm, 0);
  EXPECT_NEAR(vessel.submergedVolume(), vessel.mass() / seaWaterDensity, 1e-9);
  EXPECT_EQ(vessel.waterHeight(), 0.0);
}

}  // namespace
}  // namespace seaway::bridge
