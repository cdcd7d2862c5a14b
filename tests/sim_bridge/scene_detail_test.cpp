#include "sim_bridge/scene_detail.h"

#include <gtest/gtest.h>

#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene/sea.h"
#include "sim_bridge/scene/vessel_course.h"
#include "sim_bridge/simulation.h"
#include "surface/angles.h"
#include "surface/disturbance/layers/layer_file.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

using Replacements = std::vector<std::pair<std::string, std::string>>;

struct Prepared {
  explicit Prepared(const Replacements& replacements = {})
      : scene(loadScene(test::writeScene(folder, replacements))), sea(buildSea(scene)) {}
  test::TempFolder folder;
  Scene scene;
  Sea sea;
};

const std::pair<std::string, std::string> atRest{"speed_m_s: 6", "speed_m_s: 0"};
const std::string anchor = "{latitude_deg: 28.878, longitude_deg: -78.467}";

std::pair<std::string, std::string> with(const std::string& keys) {
  return {"run: {", keys + "\nrun: {"};
}

std::shared_ptr<const SurfaceDetail> detailAt(const Prepared& prepared, double t) {
  SceneDetail detail(prepared.scene, prepared.sea);
  detail.advance(t);
  return detail.detail();
}

TEST(SceneDetail, NothingCalledForHoldsNothing) {
  const Prepared calm({atRest});
  EXPECT_EQ(detailAt(calm, 5.0), nullptr);
  EXPECT_EQ(calm.sea.surface.extras().events, nullptr);
  const Simulation simulation(calm.scene, calm.sea);
  EXPECT_EQ(&simulation.surface(), &calm.sea.surface);
}

TEST(SceneDetail, AVesselLeavesFoamAndSmoothWaterBehindItAndNoneAhead) {
  const Prepared prepared;
  const auto detail = detailAt(prepared, 10.0);
  ASSERT_TRUE(detail);
  const CoursePoint now = courseOf(prepared.scene.vessels[0], prepared.sea.geodesy).at(10.0);
  const glm::dvec2 ahead = unitVector(now.direction);
  double foam = 0.0;
  for (double back = 6.0; back < 30.0; back += 0.5) {
    foam += detail->cover.foam->coverAt(now.position - back * ahead, 10.0) / 48.0;
  }
  EXPECT_GT(foam, 0.3);
  EXPECT_GT(detail->cover.smooth->coverAt(now.position - 20.0 * ahead, 10.0), 0.3f);
  for (double front = 7.0; front < 30.0; front += 0.5) {
    EXPECT_EQ(detail->cover.foam->coverAt(now.position + front * ahead, 10.0), 0.0f);
    EXPECT_EQ(detail->cover.smooth->coverAt(now.position + front * ahead, 10.0), 0.0f);
  }
  EXPECT_EQ(detail->cover.oil, nullptr);
}

TEST(SceneDetail, WhoeverBeginsWhenSeesTheSame) {
  const Prepared prepared;
  SceneDetail stepped(prepared.scene, prepared.sea);
  for (double t = 0.0; t < 20.0; t += 0.37) stepped.advance(t);
  stepped.advance(20.0);
  const auto fresh = detailAt(prepared, 20.0);
  std::size_t covered = 0;
  for (double x = -80.0; x < 120.0; x += 1.3) {
    for (double y = -80.0; y < 140.0; y += 1.7) {
      const float mine = stepped.detail()->cover.foam->coverAt({x, y}, 20.0);
      EXPECT_EQ(mine, fresh->cover.foam->coverAt({x, y}, 20.0));
      covered += mine > 0.05f;
    }
  }
  EXPECT_GT(covered, 100u);
}

TEST(SceneDetail, ACopyMovesOnAlone) {
  const Prepared prepared;
  SceneDetail detail(prepared.scene, prepared.sea);
  detail.advance(5.0);
  const auto before = detail.detail();
  SceneDetail copy = detail;
  copy.advance(9.0);
  EXPECT_EQ(detail.detail(), before);
  EXPECT_GT(copy.detail()->cover.foam->cellCount(), before->cover.foam->cellCount());
}

TEST(SceneDetail, OilFromAFileLiesWhereTheFileSaysAndDampsShortWaves) {
  const test::TempFolder other;
  SurfaceLayer slick({.cellSize = 0.5});
  slick.paint({100.0, 50.0}, {160.0, 110.0}, 0.0, [](glm::dvec2) { return 0.9f; });
  const std::string file = (other / "slick.vdb").string();
  writeLayers(file, {{"oil", &slick}}, 0.0);
  const Prepared prepared(
      {atRest, with("layers: [{kind: oil, file: " + file + ", grid: oil, time_s: 2}]")});
  EXPECT_EQ(detailAt(prepared, 1.0), nullptr);
  const auto detail = detailAt(prepared, 3.0);
  ASSERT_TRUE(detail && detail->cover.oil);
  EXPECT_NEAR(detail->cover.oil->coverAt({130.0, 80.0}, 3.0), 0.9, 1e-4);
  WaterSurface water = prepared.sea.surface;
  const glm::dvec2 inside(130.3, 80.2), outside(90.0, 20.0);
  const SurfaceSample plain = water.sample(inside, 3.0);
  const SurfaceSample longer =
      water.sample(inside, 3.0, {.shortestWavelength = SurfaceDetail::dampedWavelength});
  const SurfaceSample untouched = water.sample(outside, 3.0);
  water.setDetail(detail);
  const SurfaceSample oiled = water.sample(inside, 3.0);
  // Short octaves are left to a tenth.
  EXPECT_NEAR(oiled.height, plain.height + 0.9 * (longer.height - plain.height), 1e-5);
  EXPECT_NEAR(oiled.slope.x, plain.slope.x + 0.9 * (longer.slope.x - plain.slope.x), 1e-5);
  EXPECT_NE(plain.slope.x, longer.slope.x);
  EXPECT_EQ(water.sample(outside, 3.0).height, untouched.height);
}

TEST(SceneDetail, SplashesRainAndRipplesAreFeltAndSeenInTheirTime) {
  const Prepared prepared(
      {atRest, with("splashes: [{place: " + anchor + ", time_s: 2}]\nripples: [{place: " + anchor +
                    ", time_s: 8, duration_s: 2}]\nrain: {rate_mm_h: 10}")});
  const SurfaceEvents& events = *prepared.sea.surface.extras().events;
  EXPECT_TRUE(events.rain().falls(0.0));
  const glm::dvec2 place = events.splashes()[0].centre(2.5);
  SurfaceSample sample;
  events.addTo(std::span(&place, 1), 2.5, std::span(&sample, 1), {.shortestWavelength = 1.0});
  EXPECT_NE(sample.height, 0.0);
  EXPECT_GT(detailAt(prepared, 2.5)->cover.foam->coverAt(place, 2.5), 0.3f);
  EXPECT_TRUE(detailAt(prepared, 1.5) == nullptr);
  const auto rippled = detailAt(prepared, 9.0);
  ASSERT_TRUE(rippled);
  EXPECT_EQ(rippled->ripples.size(), 1u);
}

TEST(SceneDetail, EffectsThatAreOffHoldNothing) {
  const Prepared prepared(
      {with("splashes: [{place: " + anchor + "}]\nripples: [{place: " + anchor +
            "}]\nrain: {rate_mm_h: 10}\nlayers: [{kind: oil, place: " + anchor +
            "}]\neffects: {trail: off, splash: off, rain: off, ripples: off, oil: off}")});
  EXPECT_EQ(prepared.sea.surface.extras().events, nullptr);
  EXPECT_EQ(detailAt(prepared, 1.0), nullptr);
}

TEST(SceneDetail, TheLedgerTellsWhatIsThereAndWhatItHolds) {
  const Prepared prepared({with("layers: [{kind: oil, place: " + anchor + "}]")});
  SceneDetail detail(prepared.scene, prepared.sea);
  EffectLedger ledger;
  detail.advance(1.0, &ledger);
  detail.advance(2.0, &ledger);
  const auto report = ledger.report();
  const auto of = [&](Effect effect) { return report[static_cast<std::size_t>(effect)]; };
  EXPECT_EQ(of(Effect::trail).state, EffectState::on);
  EXPECT_GT(of(Effect::trail).memoryBytes, 10'000u);
  EXPECT_GT(of(Effect::trail).costMicroseconds, 0.0);
  EXPECT_EQ(of(Effect::oil).state, EffectState::on);
  EXPECT_GT(of(Effect::oil).memoryBytes, 1000u);
  EXPECT_EQ(of(Effect::splash).state, EffectState::idle);
  EXPECT_EQ(of(Effect::rain).state, EffectState::idle);
  EXPECT_EQ(of(Effect::ripples).state, EffectState::idle);
  EXPECT_EQ(of(Effect::ripples).memoryBytes, 0u);
}

TEST(SceneDetailHard, FaultsInTheSceneNameFileLineAndKey) {
  const test::TempFolder folder;
  const auto message = [&](const std::string& keys) {
    return test::inputErrorOf([&] {
      const Scene scene = loadScene(test::writeScene(folder, {with(keys)}));
      const Sea sea = buildSea(scene);
      SceneDetail detail(scene, sea);
    });
  };
  EXPECT_NE(message("rain: {rate_mm_h: -1}").find("rate_mm_h"), std::string::npos);
  EXPECT_NE(message("layers: [{kind: oil}]").find("exactly one of place and file"),
            std::string::npos);
  EXPECT_NE(message("layers: [{kind: oil, file: none.vdb}]").find("no such file"),
            std::string::npos);
  EXPECT_NE(message("splashes: [{place: {latitude_deg: 0, longitude_deg: 0}}]").find("farther"),
            std::string::npos);
  EXPECT_NE(message("ripples: [{place: " + anchor + ", period_s: 0.2}]").find("speed"),
            std::string::npos);
  folder.write("broken.vdb", "not a grid");
  const std::string broken = message("layers: [{kind: oil, file: broken.vdb}]");
  EXPECT_NE(broken.find("broken.vdb"), std::string::npos) << broken;
}

}  // namespace
}  // namespace seaway::bridge
