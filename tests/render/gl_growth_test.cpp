#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <optional>

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

TEST(GlGrowth, AThousandFramesOfEveryVariantLeaveNoObjectsAndNoMemoryBehind) {
  HeadlessContext& context = test::sharedContext();
  Drawing drawing;
  for (const GridVariant variant : variants) {
    const auto technique = makeProjectedGrid(context, {.grid = {16, 16}, .variant = variant});
    const auto draw = [&](int frame) {
      drawing.view.time = 0.1 * frame;
      drawing.view.light.sunDirection = 0.001 * (frame / 40);  // the sky is drawn anew at times
      technique->draw(drawing.view);
    };
    for (int frame = 0; frame < 100; ++frame) draw(frame);
    const double before = residentBytes();
    const test::GlCensus census;
    for (int frame = 100; frame < 350; ++frame) draw(frame);
    EXPECT_EQ(test::GlCensus::made(), 0) << gridVariantName(variant);
#if !defined(__SANITIZE_ADDRESS__)
    // The allocator takes and gives back steps of a megabyte; a leak of 6 kB a frame would show, an
    // image is 1 kB, the smallest map 4 kB.
    EXPECT_LT(residentBytes() - before, 1.5e6) << gridVariantName(variant);
#endif
  }
}

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
