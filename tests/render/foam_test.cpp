#include <gtest/gtest.h>

#include <cmath>

#include "render/compare_frames.h"
#include "render/shading/foam_pattern.h"
#include "tests/render/seas.h"

namespace seaway::render {
namespace {

struct Picture {
  Frame frame;
  std::vector<EffectReport> report;
  const EffectReport& operator[](Effect effect) const {
    return report[static_cast<std::size_t>(effect)];
  }
};

Picture picture(RenderTechnique& technique, const WaterSurface& water, const Camera& camera,
                double wind, const EffectSettings& settings = {}) {
  EffectLedger effects(settings);
  View view;
  view.water = &water;
  view.time = 4.0;
  view.camera = camera;
  view.light.windSpeed = wind;
  view.light.sunElevation = 0.6;
  view.light.sunDirection = 2.5;
  view.effects = &effects;
  Picture result;
  result.frame = technique.draw(view);
  result.report = effects.report();
  return result;
}

/// Water pixels that are nearly as bright in red as in blue: white, not blue.
double whitePart(const Frame& frame) {
  double white = 0.0, water = 0.0;
  for (std::size_t i = 0; i < frame.classes.size(); ++i) {
    if (frame.classes[i] != PixelClass::water) continue;
    const std::uint8_t* c = &frame.colour.rgb[3 * i];
    water += 1.0;
    white += c[0] > 150 && c[0] > 0.85 * c[2];
  }
  return white / water;
}

/// A camera that looks down on the water ahead, where a patch of cover lies.
Camera lookingDown() { return test::cameraAt({0.0, 0.0, 9.0}, -35.0, 0.0, 60.0, {320, 180}); }

std::shared_ptr<const SurfaceDetail> patch(LayerSettings settings, float cover, bool oil = false) {
  SurfaceLayer layer(settings);
  // Ahead of a camera that looks at 0.4 rad.
  layer.paint({5.0, 0.0}, {16.0, 11.0}, 0.0, [&](glm::dvec2 p) {
    const double far = std::hypot(p.x - 10.5, p.y - 5.0) / 5.0;
    return static_cast<float>(cover * std::clamp(2.0 - 2.0 * far, 0.0, 1.0));
  });
  SurfaceDetail detail;
  (oil ? detail.cover.oil : detail.cover.foam) = std::make_shared<const SurfaceLayer>(layer);
  return std::make_shared<const SurfaceDetail>(detail);
}

TEST(Foam, PatternHasEveryNumberEquallyOftenAndTiles) {
  constexpr int side = 128;
  const std::vector<float> pattern = foamPattern(side);
  double sum = 0.0, squares = 0.0, across = 0.0, inside = 0.0;
  for (const float value : pattern) sum += value, squares += value * value;
  EXPECT_NEAR(sum / pattern.size(), 1.0 / 2.0, 1e-4);
  EXPECT_NEAR(squares / pattern.size(), 1.0 / 3.0, 1e-4);
  // The seam is no rougher than other neighbours.
  for (int y = 0; y < side; ++y) {
    across += std::abs(pattern[y * side] - pattern[y * side + side - 1]);
    for (int x = 1; x < side; ++x) {
      inside += std::abs(pattern[y * side + x] - pattern[y * side + x - 1]) / (side - 1);
    }
  }
  EXPECT_NEAR(across / inside, 1.0, 0.25);
}

TEST(Foam, AStormIsWhiterThanABreezeAndFoamSwitchedOffLeavesNone) {
  const WaterSurface water = test::groupSea(6.0, 10.0);
  const Camera camera = test::cameraAt({0.0, 0.0, 12.0}, -12.0, 0.0, 60.0, {320, 180});
  const auto technique = makeSoftwareGrid();
  EffectSettings off{};
  off[static_cast<std::size_t>(Effect::foam)] = EffectSetting::off;
  const Picture breeze = picture(*technique, water, camera, 6.0);
  const Picture storm = picture(*technique, water, camera, 24.0);
  const Picture dark = picture(*technique, water, camera, 24.0, off);
  EXPECT_GT(whitePart(storm.frame), whitePart(breeze.frame) + 0.03);
  EXPECT_LT(whitePart(dark.frame), 0.3 * whitePart(storm.frame));
  EXPECT_EQ(storm[Effect::foam].state, EffectState::on);
  EXPECT_EQ(storm[Effect::foam].costInside, Effect::water);
  EXPECT_EQ(dark[Effect::foam].state, EffectState::off);
}

TEST(Foam, CalmWaterWithoutWindHasNoFoamAndNoRain) {
  const auto technique = makeSoftwareGrid();
  const Picture calm = picture(*technique, test::stillSea(), lookingDown(), 2.0);
  EXPECT_EQ(calm[Effect::foam].state, EffectState::idle);
  EXPECT_EQ(calm[Effect::rain].state, EffectState::idle);
}

TEST(Foam, APatchIsWhereItLiesInEveryTechniqueAndAsWhite) {
  WaterSurface water = test::groupSea(0.5, 4.0);
  const Camera camera = lookingDown();
  const auto reference = makeReference();
  const Picture without = picture(*reference, water, camera, 3.0);
  water.setDetail(patch({.cellSize = 0.25}, 0.9f));
  const Picture truth = picture(*reference, water, camera, 3.0);
  EXPECT_EQ(truth[Effect::foam].state, EffectState::on);
  EXPECT_GT(whitePart(truth.frame), whitePart(without.frame) + 0.03);
  const auto software = makeSoftwareGrid();
  std::vector<std::unique_ptr<RenderTechnique>> others;
  for (const GridVariant variant : {GridVariant::cpuVertices, GridVariant::gpu,
                                    GridVariant::cpuVerticesGpuNormals, GridVariant::marched}) {
    others.push_back(makeProjectedGrid(test::sharedContext(), {.variant = variant}));
  }
  others.push_back(makeSoftwareGrid());
  for (const auto& technique : others) {
    const Picture drawn = picture(*technique, water, camera, 3.0);
    double difference = 0.0;
    for (std::size_t i = 0; i < drawn.frame.colour.rgb.size(); ++i) {
      difference += std::abs(drawn.frame.colour.rgb[i] - truth.frame.colour.rgb[i]);
    }
    difference /= static_cast<double>(drawn.frame.colour.rgb.size());
    // Lace on waves that differ by a fraction of a pixel.
    EXPECT_LT(difference, 3.0) << drawn.frame.stats.variant;
    EXPECT_NEAR(whitePart(drawn.frame), whitePart(truth.frame), 0.01) << drawn.frame.stats.variant;
  }
}

TEST(Foam, OilIsDarkAndCalmInEveryTechnique) {
  WaterSurface water = test::groupSea(0.5, 4.0);
  const Camera camera = lookingDown();
  const auto reference = makeReference();
  const Picture without = picture(*reference, water, camera, 6.0);
  water.setDetail(patch({.cellSize = 0.25}, 1.0f, true));
  const Picture truth = picture(*reference, water, camera, 6.0);
  const auto gpu = makeProjectedGrid(test::sharedContext(), {.variant = GridVariant::gpu});
  const auto software = makeSoftwareGrid();
  const auto mean = [](const Frame& a, const Frame& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.colour.rgb.size(); ++i) {
      sum += std::abs(a.colour.rgb[i] - b.colour.rgb[i]);
    }
    return sum / static_cast<double>(a.colour.rgb.size());
  };
  const double change = mean(without.frame, truth.frame);
  EXPECT_GT(change, 0.5);
  for (const auto* technique : {gpu.get(), software.get()}) {
    const Picture drawn = picture(*const_cast<RenderTechnique*>(technique), water, camera, 6.0);
    EXPECT_LT(mean(drawn.frame, truth.frame), 0.5 * change + 0.5) << drawn.frame.stats.variant;
  }
}

TEST(Foam, RainRingsAreSeenNearAndAreTheSameInEveryTechnique) {
  WaterSurface water = test::stillSea();
  const Camera camera = test::cameraAt({3.0, 2.0, 1.6}, -35.0, 0.0, 60.0, {320, 180});
  const auto software = makeSoftwareGrid();
  const Picture dry = picture(*software, water, camera, 1.0);
  water.setEvents(std::make_shared<const SurfaceEvents>(
      std::vector<Splash>{}, Rain::ofRate(30.0, 4), SurfaceEvents::Water{}));
  const Picture wet = picture(*software, water, camera, 1.0);
  EXPECT_EQ(wet[Effect::rain].state, EffectState::on);
  EXPECT_NE(dry.frame.colour.rgb, wet.frame.colour.rgb);
  const auto gpu = makeProjectedGrid(test::sharedContext(), {.variant = GridVariant::gpu});
  const Picture drawn = picture(*gpu, water, camera, 1.0);
  double difference = 0.0, change = 0.0;
  for (std::size_t i = 0; i < drawn.frame.colour.rgb.size(); ++i) {
    difference += std::abs(drawn.frame.colour.rgb[i] - wet.frame.colour.rgb[i]);
    change += std::abs(dry.frame.colour.rgb[i] - wet.frame.colour.rgb[i]);
  }
  EXPECT_LT(difference, 0.2 * change);
}

TEST(Foam, ASplashStandsInThePictureAsInTheSamples) {
  WaterSurface water = test::stillSea();
  const Camera camera = lookingDown();
  water.setEvents(std::make_shared<const SurfaceEvents>(
      std::vector<Splash>{{.place = {10.0, 5.0}, .time = 3.0, .height = 0.5, .wavelength = 3.0}},
      Rain{}, SurfaceEvents::Water{}));
  const auto reference = makeReference();
  const Picture truth = picture(*reference, water, camera, 1.0);
  for (const GridVariant variant :
       {GridVariant::cpuVertices, GridVariant::gpu, GridVariant::marched}) {
    const auto technique = makeProjectedGrid(test::sharedContext(), {.variant = variant});
    const Picture drawn = picture(*technique, water, camera, 1.0);
    double worst = 0.0, highest = 0.0;
    for (std::size_t i = 0; i < drawn.frame.depth.metres.size(); ++i) {
      const double depth = drawn.frame.depth.metres[i], other = truth.frame.depth.metres[i];
      if (!std::isfinite(depth) || !std::isfinite(other)) continue;
      worst = std::max(worst, std::abs(depth - other));
      highest = std::max(highest, other);
    }
    // Chords of cells of some 10 cm over rings of 3 m; axial metres at a slant of 35°.
    EXPECT_LT(worst, 0.1) << drawn.frame.stats.variant;
  }
}

TEST(FoamHard, NothingCalledForMakesNoCoverAndNoTexture) {
  const WaterSurface water = test::stillSea();
  const auto gpu = makeProjectedGrid(test::sharedContext(), {.variant = GridVariant::gpu});
  const Picture first = picture(*gpu, water, lookingDown(), 1.0);
  EXPECT_EQ(first[Effect::foam].memoryBytes, 0u);
  EXPECT_EQ(first[Effect::splash].state, EffectState::idle);
  WaterSurface covered = test::stillSea();
  covered.setDetail(patch({.cellSize = 0.25}, 0.9f));
  const Picture second = picture(*gpu, covered, lookingDown(), 1.0);
  EXPECT_GT(second[Effect::water].memoryBytes, first[Effect::water].memoryBytes);
}

}  // namespace
}  // namespace seaway::render
