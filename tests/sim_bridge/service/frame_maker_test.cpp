#include "sim_bridge/service/frame_maker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "render/technique_choice.h"
#include "surface/input_error.h"
#include "tests/sim_bridge/service/served_waters.h"

namespace seaway::bridge {
namespace {

using test::ServedWaters;

std::size_t pixelsOf(const render::Frame& frame, render::PixelClass kind) {
  return static_cast<std::size_t>(std::count(frame.classes.begin(), frame.classes.end(), kind));
}

// The scene's own vessels lie on the water as a replayed simulation's do on calm water.
void expectThePictureOfTheRenderCommand(const std::string& more) {
  ServedWaters served(test::pilotScene(more));
  FrameMaker frames(served.sea);
  served.bringWakes(4.0, {0.0, 0.0});  // however busy the machine
  const auto drawn = frames.draw({.camera = "mast", .t = 4.0});
  const Sea sea = buildSea(served.scene);
  const Simulation simulation = Simulation::replayed(served.scene, sea, 4.0);
  SceneView view(served.scene);
  EffectLedger ledger(served.scene.effects);
  const auto technique = render::makeTechnique({.grid = served.scene.accuracy.grid});
  const render::Frame expected =
      technique->draw(view.view(simulation, findCamera(served.scene, "mast"), {96, 64}, ledger));
  EXPECT_EQ(drawn->colour.size, glm::ivec2(96, 64));
  EXPECT_EQ(drawn->colour.rgb, expected.colour.rgb);
  EXPECT_EQ(drawn->depth.metres, expected.depth.metres);
  EXPECT_FALSE(frames.effects().empty());
}

TEST(FrameMaker, DrawsThePictureThatTheRenderCommandDraws) {
  expectThePictureOfTheRenderCommand("effects: {wake: off, trail: off}\n");
}

TEST(FrameMaker, ShowsTrailsOilAndRipplesAsTheRenderCommandDoes) {
  expectThePictureOfTheRenderCommand(test::oilAndRipples);
  // And they are seen.
  ServedWaters with(test::pilotScene(test::oilAndRipples));
  ServedWaters without(test::pilotScene("effects: {wake: off, trail: off}\n"));
  FrameMaker frames(with.sea), bare(without.sea);
  with.bringWakes(4.0, {0.0, 0.0});
  const FrameRequest mast{.camera = "mast", .t = 4.0};
  EXPECT_NE(frames.draw(mast)->colour.rgb, bare.draw(mast)->colour.rgb);
}

TEST(FrameMaker, ShowsAHostsHullWhereItWasPlacedAndAMountedCameraOnIt) {
  ServedWaters served(test::pilotScene("", "0"));
  FrameMaker frames(served.sea);
  const std::uint32_t hull = served.sea.addHull(0);
  served.sea.place(hull, 2.0, served.poseAt({0.0, 60.0}));
  const FrameRequest mast{.camera = "mast", .t = 2.0, .size = {240, 160}};
  const auto there = frames.draw(mast);
  served.sea.place(hull, 3.0, served.poseAt({0.0, -500.0}));  // behind the camera
  FrameRequest later = mast;
  later.t = 3.0;
  const auto gone = frames.draw(later);
  EXPECT_GT(pixelsOf(*there, render::PixelClass::object),
            pixelsOf(*gone, render::PixelClass::object) + 50);
  const auto bow = frames.draw({.camera = "bow", .t = 3.0});
  EXPECT_GT(pixelsOf(*bow, render::PixelClass::water), 1000u);
}

TEST(FrameMaker, ShowsTheWakesOfTheTimeItIsAskedFor) {
  ServedWaters served;
  FrameMaker frames(served.sea);
  const FrameRequest mast{.camera = "mast", .t = 12.0, .size = {240, 160}};
  frames.draw(mast);  // calls for them, and does not wait for ever
  EXPECT_TRUE(served.sea.awaitWakes(60.0));
  const auto drawn = frames.draw(mast);
  EXPECT_TRUE(served.sea.wakeSpan());
  ServedWaters still(test::pilotScene("effects: {wake: off}\n"));
  FrameMaker without(still.sea);
  EXPECT_NE(drawn->colour.rgb, without.draw(mast)->colour.rgb);
}

TEST(FrameMaker, CamerasThatHostsSetAreDrawnByTheirName) {
  ServedWaters served;
  FrameMaker frames(served.sea);
  SceneCamera down;
  down.place = CameraPlace{0.0, 0.0, 30.0};
  down.pitch_deg = -90.0;
  frames.setCamera("cigi:1:0", down);
  EXPECT_EQ(frames.cameras(), (std::vector<std::string>{"bow", "mast", "cigi:1:0"}));
  const auto drawn = frames.draw({.camera = "cigi:1:0", .t = 30.0});
  EXPECT_EQ(pixelsOf(*drawn, render::PixelClass::sky), 0u);
  frames.setCamera("cigi:1:0", std::nullopt);
  EXPECT_THROW(frames.draw({.camera = "cigi:1:0", .t = 30.0}), InputError);
}

TEST(FrameMakerHard, RefusesWhatCannotBeDrawnAndDrawsOn) {
  ServedWaters served;
  FrameMaker frames(served.sea);
  EXPECT_THROW(frames.draw({.camera = "stern"}), InputError);
  EXPECT_THROW(frames.draw({.t = std::nan("")}), InputError);
  EXPECT_THROW(frames.draw({.size = {100000, 10}}), InputError);
  EXPECT_THROW(frames.draw({.size = {0, 10}}), InputError);
  EXPECT_EQ(frames.draw({})->colour.size, glm::ivec2(96, 64));
}

TEST(FrameMakerHard, ManyAskAtOnceWhileTheSceneChanges) {
  ServedWaters served(test::pilotScene("effects: {wake: off}\n"));
  FrameMaker frames(served.sea);
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&, i] {
      for (int k = 0; k < 5; ++k) {
        EXPECT_TRUE(frames.draw({.t = 0.1 * (i + k), .size = {32, 24}}));
      }
    });
  }
  const Scene other = test::loadText(test::pilotScene("effects: {wake: off}\n", "2"));
  for (int i = 0; i < 5; ++i) served.sea.replaceScene(other, buildSea(other));
  for (std::thread& thread : threads) thread.join();
}

}  // namespace
}  // namespace seaway::bridge
