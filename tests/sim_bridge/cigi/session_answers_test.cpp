#include <limits>

#include "tests/sim_bridge/cigi/session_fixture.h"

/// What is answered, on water whose heights are known in closed form; mean sea level is 10 m below
/// still water.
namespace seaway::bridge::cigi {
namespace {

using test::KnownWater;

class CigiAnswers : public test::SessionTest {
 protected:
  CigiAnswers() { make(synchronous()); }

  static HatHotRequest at(std::uint16_t number, HeightKind kind, double altitude = 0.0) {
    return {.request = number,
            .type = static_cast<std::uint8_t>(kind),
            .latitude = 8.0,
            .longitude = 1.0,
            .altitude = altitude};
  }
  static HatHotRequest onEntity(std::uint16_t number, std::uint16_t entity, double x, double y,
                                double z, HeightKind kind = HeightKind::aboveTerrain) {
    return {.request = number,
            .type = static_cast<std::uint8_t>(kind),
            .entityAxes = true,
            .entity = entity,
            .latitude = x,
            .longitude = y,
            .altitude = z};
  }
  HatHotResponse only() const {
    const auto all = answers<HatHotResponse>();
    EXPECT_EQ(all.size(), 1u);
    return all.empty() ? HatHotResponse{} : all[0];
  }
  double surface(double north = 0.0) const {
    return 10.0 + KnownWater::elevationAt(hostTime, 8.0, north);
  }
};

TEST_F(CigiAnswers, HeightAboveAndOfTheWaterAtTheFramesTime) {
  give(0x1B, {at(1, HeightKind::ofTerrain), at(2, HeightKind::aboveTerrain, 30.0)});
  const auto all = answers<HatHotResponse>();
  ASSERT_EQ(all.size(), 2u);
  EXPECT_TRUE(all[0].valid && all[0].ofTerrain);
  EXPECT_EQ(all[0].height, surface());
  EXPECT_EQ(all[0].hostFrame, 0xB);
  EXPECT_TRUE(all[1].valid && !all[1].ofTerrain);
  EXPECT_EQ(all[1].height, 30.0 - surface());
}

TEST_F(CigiAnswers, TheExtendedAnswerHasBothHeightsMaterialAndNormal) {
  give(1, {at(5, HeightKind::extended, 20.0)});
  const auto all = answers<HatHotExtendedResponse>();
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].request, 5);
  EXPECT_TRUE(all[0].valid);
  EXPECT_EQ(all[0].heightOf, surface());
  EXPECT_EQ(all[0].heightAbove, 20.0 - surface());
  EXPECT_EQ(all[0].material, waterMaterial);
  // The water rises by a half to the north: its normal leans south by atan ½ from the vertical.
  EXPECT_NEAR(std::abs(all[0].normalAzimuth), 180.0, 1e-5);
  EXPECT_NEAR(all[0].normalElevation, 90.0 - std::atan(0.5) * 180.0 / 3.14159265358979, 1e-5);
}

TEST_F(CigiAnswers, WhereThereIsNoWaterTheAnswerIsNotValid) {
  HatHotRequest dry = at(1, HeightKind::ofTerrain);
  dry.longitude = -1.0;
  HatHotRequest extended = at(2, HeightKind::extended);
  extended.longitude = -1.0;
  give(1, {dry, extended, onEntity(3, 77, 0, 0, 0)});
  for (const auto& answer : answers<HatHotResponse>()) EXPECT_FALSE(answer.valid);
  ASSERT_EQ(answers<HatHotExtendedResponse>().size(), 1u);
  EXPECT_FALSE(answers<HatHotExtendedResponse>()[0].valid);
  EXPECT_EQ(counts[Count::invalidPoints], 3u);
}

TEST_F(CigiAnswers, ARequestOfNoKnownTypeIsPassedOver) {
  HatHotRequest strange = at(1, HeightKind::ofTerrain);
  strange.type = 3;
  give(1, {strange});
  EXPECT_EQ(sent.size(), 1u);
  EXPECT_EQ(test::packetsOf(sent[0]).size(), 1u);
  EXPECT_EQ(counts[Count::unsupported], 1u);
}

TEST_F(CigiAnswers, APeriodicRequestIsAnsweredEveryNthFrameUntilItIsAskedOnce) {
  HatHotRequest periodic = at(9, HeightKind::ofTerrain);
  periodic.period = 3;
  std::vector<int> answered;
  for (std::uint32_t frame = 0; frame < 8; ++frame) {
    give(frame + 1, frame == 0 ? std::vector<Packet>{periodic} : std::vector<Packet>{});
    answered.push_back(static_cast<int>(answers<HatHotResponse>().size()));
  }
  EXPECT_EQ(answered, (std::vector<int>{1, 0, 0, 1, 0, 0, 1, 0}));
  give(9, {at(9, HeightKind::ofTerrain)});
  EXPECT_EQ(answers<HatHotResponse>().size(), 1u);
  for (std::uint32_t frame = 10; frame < 16; ++frame) {
    give(frame, {});
    EXPECT_TRUE(answers<HatHotResponse>().empty());
  }
}

// Body axes: x forward, y starboard, z down. Heading 90°: forward is east, starboard is south.
TEST_F(CigiAnswers, APointOfAnEntityFollowsItsPositionHeadingPitchAndRoll) {
  EntityControl ship{
      .entity = 3, .state = 1, .yaw = 90.0f, .latitude = 8.0, .longitude = 1.0, .altitude = 12.0};
  give(1, {ship, onEntity(1, 3, 10.0, 4.0, -2.0)});
  EXPECT_NEAR(water.lastPoint.east, 10.0, 1e-12);
  EXPECT_NEAR(water.lastPoint.north, -4.0, 1e-12);
  EXPECT_NEAR(only().height, 12.0 + 2.0 - surface(-4.0), 1e-12);

  ship.yaw = 0.0f;
  ship.pitch = 90.0f;  // the bow points up
  give(2, {ship, onEntity(1, 3, 10.0, 0.0, 0.0)});
  EXPECT_NEAR(only().height, 12.0 + 10.0 - surface(0.0), 1e-9);

  ship.pitch = 0.0f;
  ship.roll = 90.0f;  // starboard points down
  give(3, {ship, onEntity(1, 3, 0.0, 4.0, 0.0)});
  EXPECT_NEAR(only().height, 12.0 - 4.0 - surface(0.0), 1e-9);

  ship.roll = 0.0f;
  ship.longitude = -1.0;
  give(4, {ship, onEntity(1, 3, 0.0, 0.0, 0.0)});
  EXPECT_FALSE(only().valid);
}

TEST_F(CigiAnswers, APeriodicPointOfAnEntityFollowsItWithoutBeingAskedAgain) {
  EntityControl ship{.entity = 3, .state = 1, .latitude = 8.0, .longitude = 1.0, .altitude = 12.0};
  HatHotRequest request = onEntity(1, 3, 10.0, 0.0, 0.0);
  request.period = 1;
  give(1, {ship, request});
  EXPECT_NEAR(only().height, 12.0 - surface(10.0), 1e-12);
  ship.altitude = 15.0;
  give(2, {ship});
  EXPECT_NEAR(only().height, 15.0 - surface(10.0), 1e-12);
}

TEST_F(CigiAnswers, In40AnEntityIsWhereItsPositionPacketSays) {
  const Dialect dialect{Version::v40, ByteOrder::littleEndian};
  give(1,
       {EntityControl{.entity = 3, .state = 1},
        EntityPosition{
            .entity = 3, .yaw = 180.0f, .latitude = 8.0, .longitude = 1.0, .altitude = 12.0},
        onEntity(1, 3, 10.0, 0.0, 0.0)},
       0.0, dialect);
  EXPECT_NEAR(only().height, 12.0 - surface(-10.0), 1e-9);
  give(2, {EntityControl{.entity = 3, .state = 0}, onEntity(1, 3, 10.0, 0.0, 0.0)}, 0.0, dialect);
  EXPECT_FALSE(only().valid);
}

TEST_F(CigiAnswers, AnAttachedEntityIsInItsParentsAxesAndRingsAreNotValid) {
  const EntityControl ship{
      .entity = 3, .state = 1, .yaw = 90.0f, .latitude = 8.0, .longitude = 1.0, .altitude = 12.0};
  const EntityControl mast{.entity = 4,
                           .state = 1,
                           .attached = true,
                           .parent = 3,
                           .yaw = 90.0f,
                           .latitude = 5.0,
                           .longitude = 0.0,
                           .altitude = -20.0};
  // 5 m east and 20 m up; its own forward is the ship's starboard: south.
  give(1, {ship, mast, onEntity(1, 4, 3.0, 0.0, 0.0)});
  EXPECT_NEAR(water.lastPoint.east, 5.0, 1e-9);
  EXPECT_NEAR(water.lastPoint.north, -3.0, 1e-9);
  EXPECT_NEAR(only().height, 12.0 + 20.0 - surface(-3.0), 1e-9);

  EntityControl ring = ship;
  ring.attached = true;
  ring.parent = 4;
  give(2, {ring, onEntity(1, 4, 0.0, 0.0, 0.0)});
  EXPECT_FALSE(only().valid);
}

TEST_F(CigiAnswers, AClampedEntityStandsOnTheWaterAndLiesAlongItIfAskedTo) {
  EntityControl ship{
      .entity = 3, .state = 1, .clamp = 1, .latitude = 8.0, .longitude = 1.0, .altitude = 1.5};
  give(1, {ship, onEntity(1, 3, 0.0, 0.0, 0.0)});
  EXPECT_NEAR(only().height, 1.5, 1e-12);
  ship.clamp = 2;
  ship.altitude = 0.0;
  // Its bow to the north lies along a surface that rises by a half: it stays on the plane.
  give(2, {ship, onEntity(1, 3, 10.0, 0.0, 0.0)});
  EXPECT_NEAR(only().height, 0.0, 1e-9);
}

TEST_F(CigiAnswers, TheUserPacketGivesTheWatersVelocityBelowTheSurfaceAlone) {
  const double still = 10.0;
  const WaterVelocityRequest deep{
      .request = 1, .latitude = 8.0, .longitude = 1.0, .altitude = still - 3.0};
  WaterVelocityRequest high = deep;
  high.request = 2;
  high.altitude = 100.0;
  give(0x2C, {deep, high});
  const auto all = answers<WaterVelocityResponse>();
  ASSERT_EQ(all.size(), 2u);
  EXPECT_TRUE(all[0].valid);
  EXPECT_EQ(all[0].hostFrame, 0xC);
  EXPECT_EQ(all[0].east, 2.0f);
  EXPECT_EQ(all[0].north, -3.0f);  // the height above still water, as KnownWater has it
  EXPECT_EQ(all[0].up, 0.25f);
  EXPECT_EQ(all[0].heightOf, surface());
  EXPECT_FALSE(all[1].valid);
}

TEST_F(CigiAnswers, TheHostSetsStillWaterAndAsksForIt) {
  const EnvironmentRequest ask{.type = 1, .request = 9, .latitude = 8.0, .longitude = 1.0};
  const auto answer = [&] {
    const auto all = answers<MaritimeSurfaceResponse>();
    EXPECT_EQ(all.size(), 1u);
    return all.empty() ? MaritimeSurfaceResponse{} : all[0];
  };
  give(1, {ask});
  EXPECT_EQ(answer().request, 9);
  EXPECT_EQ(answer().height, 10.0f);
  give(2, {MaritimeSurfaceControl{
               .enabled = true, .height = 4.0f, .temperature = 7.0f, .clarity = 60.0f},
           ask, at(1, HeightKind::ofTerrain)});
  EXPECT_EQ(answer().height, 4.0f);
  EXPECT_EQ(answer().temperature, 7.0f);
  EXPECT_EQ(answer().clarity, 60.0f);
  EXPECT_EQ(only().height, surface() - 6.0);
  give(3, {MaritimeSurfaceControl{.enabled = false}, ask});
  EXPECT_EQ(answer().height, 10.0f);
}

TEST_F(CigiAnswers, ConditionsWithoutWaterOrOfOtherKindsAreNotAnsweredButCounted) {
  give(1, {EnvironmentRequest{.type = 1, .latitude = 8.0, .longitude = -1.0},
           EnvironmentRequest{.type = 4, .latitude = 8.0, .longitude = 1.0}});
  EXPECT_TRUE(answers<MaritimeSurfaceResponse>().empty());
  EXPECT_EQ(counts[Count::noConditions], 1u);
  EXPECT_EQ(counts[Count::unsupported], 1u);
}

TEST_F(CigiAnswers, WavesAreAskedForTogetherAndOnlyWhenTheyChange) {
  const WaveControl swell{.wave = 2,
                          .enabled = true,
                          .height = 2.0f,
                          .period = 12.0f,
                          .direction = 90.0f,
                          .phase = 45.0f};
  const WaveControl chop{.wave = 1, .enabled = true, .height = 0.5f, .wavelength = 20.0f};
  give(1, {swell, chop});
  EXPECT_EQ(water.waveChanges, 1);
  ASSERT_EQ(water.waves.size(), 2u);
  EXPECT_EQ(water.waves[0].wavelength, 20.0);
  EXPECT_EQ(water.waves[1].period, 12.0);
  EXPECT_EQ(water.waves[1].toward_deg, 90.0);
  give(2, {swell, chop});
  EXPECT_EQ(water.waveChanges, 1);
  WaveControl off = swell;
  off.enabled = false;
  give(3, {off});
  EXPECT_EQ(water.waveChanges, 2);
  EXPECT_EQ(water.waves.size(), 1u);
}

TEST_F(CigiAnswers, WavesThatCannotBeAndScopesThatAreNotServedAreCounted) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  give(1, {WaveControl{.enabled = true, .height = -1.0f, .period = 5.0f},
           WaveControl{.enabled = true, .height = 1.0f},
           WaveControl{.enabled = true, .height = nan, .period = 5.0f},
           WaveControl{.enabled = true, .scope = 1, .height = 1.0f, .period = 5.0f},
           MaritimeSurfaceControl{.enabled = true, .scope = 2, .height = 3.0f},
           MaritimeSurfaceControl{.enabled = true, .height = nan}});
  EXPECT_EQ(water.waveChanges, 0);
  EXPECT_EQ(session->waterLevel(), 10.0);
  EXPECT_EQ(counts[Count::unsupported], 4u);
  EXPECT_EQ(counts[Count::otherScopes], 2u);
}

TEST_F(CigiAnswers, ActiveEntitiesAreToldToTheWaterInEachFrame) {
  const EntityControl a{.entity = 7,
                        .state = 1,
                        .type = 5,
                        .yaw = 30.0f,
                        .latitude = 8.0,
                        .longitude = 1.0,
                        .altitude = 3.0};
  EntityControl b = a;
  b.entity = 2;
  EntityControl child = a;
  child.entity = 9;
  child.attached = true;
  child.parent = 7;
  give(1, {a, b, child});
  ASSERT_EQ(water.entities.size(), 2u);
  EXPECT_EQ(water.entities[0].entity, 2);
  EXPECT_EQ(water.entities[1].entity, 7);
  EXPECT_EQ(water.entities[1].type, 5);
  EXPECT_EQ(water.entities[1].heading_deg, 30.0);
  b.state = 2;
  hostTime += 1.0;
  give(2, {b});
  EXPECT_EQ(water.entities.size(), 1u);
  EXPECT_EQ(water.entityTimes, (std::vector<double>{hostTime - 1.0, hostTime}));
  EntityControl last = a;
  last.state = 0;
  give(3, {last});
  EXPECT_TRUE(water.entities.empty());
  EXPECT_EQ(water.entityTimes.size(), 3u);
  give(4, {});
  EXPECT_EQ(water.entityTimes.size(), 3u);
}

TEST_F(CigiAnswers, ViewsAreHandedOn) {
  give(1, {ViewControl{.view = 4, .entity = 7}, ViewDefinition{.view = 4, .left = -30.0f}});
  ASSERT_EQ(water.views.size(), 1u);
  EXPECT_EQ(water.views[0].entity, 7);
  ASSERT_EQ(water.definitions.size(), 1u);
  EXPECT_EQ(water.definitions[0].left, -30.0f);
}

}  // namespace
}  // namespace seaway::bridge::cigi
