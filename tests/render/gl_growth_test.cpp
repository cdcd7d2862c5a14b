#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <optional>

#include "surface/outline/water_outline.h"
#include "tests/render/gl_census.h"
#include "tests/render/seas.h"

// What drawing makes in OpenGL and in memory, and that it stops making it.
namespace seaway::render {
namespace {

constexpr GridVariant variants[] = {GridVariant::cpuVertices, GridVariant::gpu,
                                    GridVariant::cpuVerticesGpuNormals, GridVariant::marched};

double residentBytes() {
  std::ifstream statistics("/proc/self/statm");
  double total = 0.0, resident = 0.0;
  statistics >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

struct Drawing {
  WaterSurface water = test::mixedSea();
  Mesh mesh;
  SceneObject object;
  View view;
  EffectLedger effects;

  Drawing() {
    mesh.parts.push_back({{{0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 2.0f}}, {}});
    mesh.boundingRadius = 2.0;
    object = {&mesh, {18.0, 26.0, 0.0}, {1.0, 0.0, 0.0, 0.0}};
    view.water = &water;
    view.camera = test::cameraAt({10.0, 22.0, 3.0}, -8.0, 5.0, 60.0, {24, 16});
    view.objects = {&object, 1};
    view.effects = &effects;
  }
};

/// A scene that every pass has work in: a shore in view, and a boat that keeps the sea out.
struct FullDrawing : Drawing {
  FullDrawing() {
    water.setOutline(std::make_shared<const WaterOutline>(std::vector<OutlinePolygon>{
        {{{{-40.0, -40.0}, {60.0, -40.0}, {60.0, 60.0}, {-40.0, 60.0}}}}}));
    mesh.hollows.push_back({{{1, 0, 0, 1}, {-1, 0, 0, 1}, {0, 1, 0, 1}, {0, -1, 0, 1}}});
  }
};

class GrowthOf : public ::testing::TestWithParam<GridVariant> {};

TEST_P(GrowthOf, AThousandFramesLeaveNoObjectsAndNoMemoryBehind) {
  HeadlessContext& context = test::sharedContext();
  FullDrawing drawing;
  const ProjectedGridOptions options{.grid = {16, 16}, .variant = GetParam()};
  const auto technique = GetParam() == GridVariant::software ? makeSoftwareGrid(options)
                                                             : makeProjectedGrid(context, options);
  Frame frame;
  const auto draw = [&](int number) {
    drawing.view.time = 0.1 * number;
    drawing.view.light.sunDirection = 0.001 * (number / 100);  // the sky is drawn anew at times
    technique->drawInto(drawing.view, frame);
  };
  for (int number = 0; number < 150; ++number) draw(number);
  for (const Effect effect : {Effect::outline, Effect::hullMask, Effect::vesselMeshes}) {
    EXPECT_EQ(drawing.effects.report()[static_cast<std::size_t>(effect)].state, EffectState::on);
  }
  const double before = residentBytes();
  const test::GlCensus census;
  for (int number = 150; number < 1150; ++number) draw(number);
  EXPECT_EQ(test::GlCensus::made(), 0);
#if !defined(__SANITIZE_ADDRESS__)
  // The allocator takes and gives back steps of a megabyte; a leak of 1.5 kB a frame would show, an
  // image is 1 kB, the smallest map 4 kB.
  EXPECT_LT(residentBytes() - before, 1.5e6);
#endif
}

INSTANTIATE_TEST_SUITE_P(EveryVariant, GrowthOf,
                         ::testing::Values(GridVariant::software, GridVariant::cpuVertices,
                                           GridVariant::gpu, GridVariant::cpuVerticesGpuNormals,
                                           GridVariant::marched),
                         [](const auto& one) { return std::string(gridVariantName(one.param)); });

TEST(GlGrowth, ATechniqueTakesAllItMadeWithIt) {
  HeadlessContext& context = test::sharedContext();
  Drawing drawing;
  for (const GridVariant variant : variants) {
    const test::GlCensus census;
    {
      const auto technique = makeProjectedGrid(context, {.grid = {16, 16}, .variant = variant});
      technique->draw(drawing.view);
      drawing.view.camera.size = {32, 20};  // another size replaces the targets
      technique->draw(drawing.view);
      drawing.view.camera.size = {24, 16};
    }
    EXPECT_GT(test::GlCensus::made(), 10);
    for (const auto& [kind, count] : test::GlCensus::alive()) {
      EXPECT_EQ(count, 0) << gridVariantName(variant) << ": " << kind;
    }
  }
}

/// Objects made by a first frame.
std::map<std::string, long> madeFor(const View& view, GridVariant variant) {
  const auto technique =
      makeProjectedGrid(test::sharedContext(), {.grid = {16, 16}, .variant = variant});
  const test::GlCensus census;
  technique->draw(view);
  return test::GlCensus::alive();
}

TEST(GlGrowth, WhatASceneDoesNotCallForIsNotMade) {
  test::sharedContext();
  for (const GridVariant variant : variants) {
    Drawing drawing;
    std::map<std::string, long> whole = madeFor(drawing.view, variant);
    drawing.view.objects = {};
    std::map<std::string, long> noObjects = madeFor(drawing.view, variant);
    EXPECT_LT(noObjects["buffer"], whole["buffer"]) << gridVariantName(variant);
    // Nothing but sky: no sea is placed, and neither its tables nor its programs are made.
    drawing.view.camera = test::cameraAt({0.0, 0.0, 50.0}, 60.0, 0.0, 20.0, {24, 16});
    std::map<std::string, long> skyAlone = madeFor(drawing.view, variant);
    EXPECT_EQ(skyAlone["buffer"], 0) << gridVariantName(variant);
    EXPECT_LT(skyAlone["program"], noObjects["program"]) << gridVariantName(variant);
    EXPECT_LT(skyAlone["texture"], noObjects["texture"]) << gridVariantName(variant);
  }
}

}  // namespace
}  // namespace seaway::render
