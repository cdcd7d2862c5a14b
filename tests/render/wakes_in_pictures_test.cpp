#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <optional>

#include "render/compare_frames.h"
#include "render/gl/projected_waves.h"
#include "render/sea_grid.h"
#include "render/wake_pyramid.h"
#include "surface/constants.h"
#include "surface/disturbance/wake_system.h"
#include "tests/render/gl_census.h"
#include "tests/render/seas.h"

// Wakes as physics feels them against wakes as pictures show them.
namespace seaway::render {
namespace {

constexpr double moment = 12.03;  // s: between the windows' steps

/// A launch that has sailed 72 m eastwards to the origin, on a current; windows of 256 and 512 m.
struct Sailed {
  Sailed() : system({.current = {0.3, -0.2}, .window = 512.0, .cascade = {}}) {
    const std::uint32_t vessel = system.addVessel(HullFootprint::wigley(12.0, 3.5, 0.8));
    for (int i = 0; i <= 121; ++i) {
      const double t = 0.1 * i;
      system.record(vessel, {t, {6.0 * (t - 12.0), 0.0}, 0.0, 1.0});
    }
    system.advance(moment, std::vector<WakeListener>{{{0.0, 0.0}, 100.0, 0}});
  }
  WakeSystem system;
};
const WakeSystem& sailed() {
  static const Sailed scene;
  return scene.system;
}

WaterSurface disturbed(WaterSurface water) {
  water.setDisturbances(sailed().feed());
  return water;
}
WaterSurface seaOnTheCurrent() {
  return WaterSurface(WaveField(test::groupOctaves(0.4, 4.0), {.current = {0.3, -0.2}}));
}

/// From the starboard quarter, looking over the wake.
Camera chaseCamera(glm::ivec2 size = {320, 180}) {
  return test::cameraAt({-55.0, -22.0, 9.0}, -12.0, 0.0, 60.0, size);
}

View viewOf(const WaterSurface& water, const Camera& camera, EffectLedger& effects) {
  View view;
  view.water = &water;
  view.time = moment;
  view.camera = camera;
  view.effects = &effects;
  return view;
}

double amplitudeOf(const DisturbanceState& state) {
  std::vector<glm::dvec2> points;
  for (int i = 0; i < 100 * 60; ++i) points.emplace_back(-80.0 + i % 100, 5.0 + 0.5 * (i / 100));
  std::vector<SurfaceSample> samples(points.size());
  state.addTo(points, moment, samples, {});
  double largest = 0.0;
  for (const SurfaceSample& sample : samples) largest = std::max(largest, std::abs(sample.height));
  return largest;
}

class WakesInTheWaveMap : public ::testing::Test {
 protected:
  /// Texels of the map for the water, grid of `size`.
  std::vector<glm::vec4> texels(const WaterSurface& water, glm::ivec2 size) {
    const View view = viewOf(water, chaseCamera(), effects_);
    const auto projector = Projector::aimedAt(view.camera, disturbed_.heightBound());
    waves_.fill(view, *projector, size);
    std::vector<glm::vec4> all(static_cast<std::size_t>(size.x) * size.y);
    glGetTextureImage(waves_.map().texture(), 0, GL_RGBA, GL_FLOAT,
                      static_cast<GLsizei>(all.size() * sizeof(glm::vec4)), all.data());
    checkGl("wakes in the wave map");
    return all;
  }
  glm::dvec2 pointAt(int row, int column) const {
    const TwinRow& line = waves_.rows()[static_cast<std::size_t>(row)];
    return glm::dvec2(chaseCamera().position) + glm::dvec2(line.point(column));
  }

  HeadlessContext& context_ = test::sharedContext();
  EffectLedger effects_;
  WaterSurface plain_ = seaOnTheCurrent(), disturbed_ = disturbed(plain_);
  ProjectedWaves waves_;
};

TEST_F(WakesInTheWaveMap, AreThoseOfQueriesWhereTheGridIsAsFineAsTheirCells) {
  const glm::ivec2 size(256, 1024);
  const std::vector<glm::vec4> without = texels(plain_, size), with = texels(disturbed_, size);
  const auto state = disturbed_.disturbances();
  const double amplitude = amplitudeOf(*state), allowed = 1e-3 + 5e-3 * amplitude;
  double worst = 0.0, worstSlope = 0.0, highest = 0.0;
  int compared = 0;
  for (int row = 0; row < size.y; ++row) {
    if (waves_.rows()[static_cast<std::size_t>(row)].keptWavelength > 4.0 * 0.5) continue;
    for (int column = 0; column < size.x; column += 3) {
      const glm::dvec2 point = pointAt(row, column);
      SurfaceSample sample;
      state->addTo(std::span(&point, 1), moment, std::span(&sample, 1), {});
      const std::size_t i = static_cast<std::size_t>(row) * size.x + column;
      const glm::vec4 added = with[i] - without[i];
      worst = std::max(worst, std::abs(added.x - sample.height));
      worstSlope = std::max(worstSlope, glm::length(glm::dvec2(added.y, added.z) - sample.slope));
      highest = std::max(highest, std::abs(sample.height));
      ++compared;
    }
  }
  std::printf("%d texels: %.2g m and %.2g of slope off, of %.2g m\n", compared, worst, worstSlope,
              highest);
  EXPECT_GT(compared, 10000);
  EXPECT_GT(highest, 0.5 * amplitude);
  EXPECT_LT(worst, allowed);
  // Float coordinates of 60 m off by 4e-6 m, times the wake's curvature; ten times that.
  EXPECT_LT(worstSlope, 1e-3);
}

TEST_F(WakesInTheWaveMap, AreThoseOfTheProcessorsGridAtAnySpacing) {
  const glm::ivec2 size(96, 160);
  const std::vector<glm::vec4> without = texels(plain_, size), with = texels(disturbed_, size);
  const View view = viewOf(disturbed_, chaseCamera(), effects_);
  const auto projector = Projector::aimedAt(view.camera, disturbed_.heightBound());
  const GridLayout layout = projectedLayout(*projector, plain_.waves(), size);
  SeaGrid grid, undisturbed;
  grid.fill(disturbed_.at(moment), view.camera, layout);
  undisturbed.fill(plain_.at(moment), view.camera, layout);
  ASSERT_FALSE(grid.missingWakes().empty());
  float largestMissing = 0.0f;
  for (std::size_t i = 0; i < with.size(); ++i) {
    // Coordinates in float, to 6e-5 m at a kilometre, times slopes of up to 1.
    ASSERT_NEAR(with[i].x - without[i].x, grid.height()[i] - undisturbed.height()[i], 2e-4)
        << "texel " << i << ", points " << layout.rows[i / size.x].plan.spacing << " m apart, sea "
        << without[i].x - undisturbed.height()[i];
    const float missing = grid.missingSlope()[i / size.x] + grid.missingWakes()[i];
    // The card filters with eight bits of fraction where it likes.
    ASSERT_NEAR(with[i].w, missing, 1e-4 + 0.02 * grid.missingWakes()[i]) << i;
    largestMissing = std::max(largestMissing, grid.missingWakes()[i]);
  }
  EXPECT_GT(largestMissing, 1e-3);  // what the grid cannot carry is not lost to shading
}

TEST(WakesInPictures, AllVariantsDrawTheReferencesSea) {
  HeadlessContext& context = test::sharedContext();
  const WaterSurface plain = seaOnTheCurrent(), water = disturbed(plain);
  EffectLedger effects;
  const glm::ivec2 grid(192, 384);
  View view = viewOf(water, chaseCamera({192, 108}), effects);
  view.wantsNormals = true;
  const Frame reference = makeReference({.grid = grid})->draw(view);
  const auto compare = [&](const char* name, RenderTechnique& technique) {
    const FrameComparison c = compareFrames(view.camera, technique.draw(view), reference);
    View without = view;
    without.water = &plain;
    const FrameComparison off = compareFrames(view.camera, technique.draw(without), reference);
    std::printf("%s: %.3g m, %.3g px; without wakes %.3g m, %.3g px\n", name, c.depthMedian,
                c.positionRms, off.depthMedian, off.positionRms);
    // The grid's chords: as without wakes (reference_test.cpp), 0.1 % of some 50 m.
    EXPECT_LT(c.depthMedian, 0.05) << name;
    EXPECT_LT(c.positionRms, 0.5) << name;
    EXPECT_GT(off.positionRms, 2.0 * c.positionRms) << name;
  };
  compare("software", *makeSoftwareGrid({.grid = grid}));
  for (const GridVariant variant :
       {GridVariant::cpuVertices, GridVariant::gpu, GridVariant::marched}) {
    const auto technique = makeProjectedGrid(context, {.grid = grid, .variant = variant});
    compare(std::string(gridVariantName(variant)).c_str(), *technique);
  }
}

TEST(WakesInPictures, MakeNothingInOpenGlWhereThereAreNone) {
  HeadlessContext& context = test::sharedContext();
  const WaterSurface plain = seaOnTheCurrent(), water = disturbed(plain);
  EffectLedger effects;
  View view = viewOf(plain, chaseCamera({48, 32}), effects);
  for (const GridVariant variant : {GridVariant::gpu, GridVariant::marched}) {
    const auto technique = makeProjectedGrid(context, {.grid = {32, 32}, .variant = variant});
    const test::GlCensus census;
    technique->draw(view);
    const auto before = test::GlCensus::alive();
    view.water = &water;
    technique->draw(view);
    auto with = test::GlCensus::alive();
    // The stamps' map, and coefficients and missing slopes of two windows.
    EXPECT_EQ(with["texture"] - before.at("texture"), 5) << gridVariantName(variant);
    EXPECT_EQ(with["program"] - before.at("program"), 1) << gridVariantName(variant);
    const long made = test::GlCensus::made();
    technique->draw(view);
    EXPECT_EQ(test::GlCensus::made(), made) << "kept from frame to frame";
    view.water = &plain;
    technique->draw(view);
    EXPECT_EQ(test::GlCensus::alive(), before) << gridVariantName(variant);
    EXPECT_EQ(test::GlCensus::made(), made) << gridVariantName(variant);
    // Out of view it is as if there were none.
    view.water = &water;
    view.camera = test::cameraAt({2000.0, 2000.0, 9.0}, -30.0, 0.0, 40.0, {48, 32});
    technique->draw(view);
    EXPECT_EQ(test::GlCensus::alive(), before) << gridVariantName(variant);
    view.water = &plain;
    view.camera = chaseCamera({48, 32});
  }
}

/// A window of 64 cells of 0.5 m with waves of `length` m along x, 1 m high.
WakeSheet waves(double length) {
  const auto grid = std::make_shared<WakeGrid>(64, false);
  const double k = 2.0 * pi / length, response = (2.0 + std::cos(0.5 * k)) / 3.0;
  for (int j = -1; j < 66; ++j) {
    for (int i = -1; i < 66; ++i) {
      const std::size_t at = (static_cast<std::size_t>(j + 1)) * grid->stride + (i + 1);
      grid->surface[2 * at] = static_cast<float>(std::cos(0.5 * k * i) / response);
    }
  }
  return {grid, grid, 0.0, 1.0, 0.5, {16.0, 16.0}};
}

/// Amplitude and missing mean-square slope that points `spacing` m apart see.
std::pair<double, double> seenAt(const WakeSheet& sheet, double spacing) {
  WakePyramid pyramid;
  pyramid.fill(sheet, 0.5);
  std::vector<double> x(64), y(64, 16.0);
  for (int i = 0; i < 64; ++i) x[i] = 0.01 + 0.4995 * i;
  std::vector<float> height(64), slopeX(64), slopeY(64), missing(64);
  pyramid.addTo(x, y, pyramid.levelFor(spacing), {height, slopeX, slopeY, missing});
  double square = 0.0, slope = 0.0;
  for (int i = 0; i < 64; ++i) square += height[i] * height[i] / 64.0, slope += missing[i] / 64.0;
  return {std::sqrt(2.0 * square), slope};
}

TEST(WakePyramid, KeepsWavesOfFourSpacingsAndTurnsShorterOnesIntoRoughness) {
  for (const double length : {4.0, 8.0}) {
    const WakeSheet sheet = waves(length);
    const double steepness = 2.0 * pi / length, whole = 0.5 * steepness * steepness;
    EXPECT_NEAR(seenAt(sheet, 0.5).first, 1.0, 1e-3) << length;
    EXPECT_EQ(seenAt(sheet, 0.3).second, 0.0) << length;
    const auto [eighth, slopeEighth] = seenAt(sheet, length / 8.0);
    EXPECT_NEAR(eighth, 1.0, 2e-3) << length;
    const auto [quarter, slopeQuarter] = seenAt(sheet, length / 4.0);
    // 97.5 % by the filter, of which a spline of four cells a wave gives 98.5 %.
    EXPECT_NEAR(quarter, 0.961, 3e-3) << length;
    const auto [half, slopeHalf] = seenAt(sheet, length / 2.0);
    EXPECT_LT(half, 0.75) << length;
    EXPECT_GT(slopeHalf, 0.3 * whole) << length;
    const auto [none, slopeNone] = seenAt(sheet, 4.0 * length);
    EXPECT_LT(none, 0.02) << length;
    EXPECT_NEAR(slopeNone, whole, 0.06 * whole) << length;  // blocks hold parts of waves
  }
}

TEST(WakePyramid, GivesAPointTheSameBitsWhateverComesWithItAndNothingBesideTheWindow) {
  WakePyramid pyramid;
  pyramid.fill(waves(4.0), 0.5);
  std::vector<double> x, y;
  for (int i = 0; i < 61; ++i) x.push_back(-7.0 + 0.77 * i), y.push_back(1.3 + 0.49 * i);
  x[20] = std::nan(""), y[30] = 1e12, x[40] = 32.0;  // the window's rim is outside
  static constexpr float before = 3.0f;
  struct Sums {
    explicit Sums(std::size_t n) : of(4, std::vector<float>(n, before)) {}
    WakePyramid::Arrays arrays() { return {of[0], of[1], of[2], of[3]}; }
    std::vector<std::vector<float>> of;
  };
  const float level = pyramid.levelFor(0.8);
  Sums together(x.size());
  pyramid.addTo(x, y, level, together.arrays());
  int inside = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    Sums alone(1);
    pyramid.addTo(std::span(&x[i], 1), std::span(&y[i], 1), level, alone.arrays());
    for (int k = 0; k < 4; ++k) EXPECT_EQ(together.of[k][i], alone.of[k][0]) << i << ' ' << k;
    const bool isInside = x[i] > 0.0 && x[i] < 32.0 && y[i] > 0.0 && y[i] < 32.0;
    inside += isInside;
    EXPECT_EQ(together.of[0][i] != before, isInside) << i;
  }
  EXPECT_GT(inside, 30);
}

}  // namespace
}  // namespace seaway::render
