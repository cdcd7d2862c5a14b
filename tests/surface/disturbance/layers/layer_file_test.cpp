#include "surface/disturbance/layers/layer_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "surface/input_error.h"

/// OpenVDB 10 loses a node of a tree whose file ends within it.
extern "C" const char* __lsan_default_suppressions() { return "leak:readTopology\n"; }

namespace seaway {
namespace {

namespace fs = std::filesystem;

class LayerFile : public ::testing::Test {
 protected:
  LayerFile() : folder_(fs::temp_directory_path() / ("seaway_layer_" + testName())) {
    fs::create_directories(folder_);
  }
  ~LayerFile() override { fs::remove_all(folder_); }
  static std::string testName() {
    return ::testing::UnitTest::GetInstance()->current_test_info()->name();
  }
  fs::path file(const std::string& name = "layer.vdb") const { return folder_ / name; }

  fs::path folder_;
};
class LayerFileHard : public LayerFile {};

SurfaceLayer ramp() {
  SurfaceLayer layer({.cellSize = 0.5, .decayTime = 100.0});
  layer.paint({-20.0, -30.0}, {25.0, 40.0}, 10.0,
              [](glm::dvec2 p) { return static_cast<float>(0.5 + 0.01 * p.x + 0.002 * p.y); });
  return layer;
}

std::string messageOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& fault) {
    return fault.what();
  }
  return "";
}

TEST_F(LayerFile, ComesBackAsItWasLeft) {
  const SurfaceLayer layer = ramp();
  writeLayers(file(), {{"foam", &layer}}, 35.0);
  SurfaceLayer back({.cellSize = 0.5, .decayTime = 100.0});
  readLayer(file(), "foam", 35.0, back);
  EXPECT_EQ(back.cellCount(), layer.cellCount());
  for (double x = -21.0; x < 26.0; x += 1.37) {
    for (double y = -31.0; y < 41.0; y += 2.11) {
      // A step of 1/65535 more.
      EXPECT_NEAR(back.coverAt({x, y}, 50.0), layer.coverAt({x, y}, 50.0), 4e-5);
    }
  }
}

TEST_F(LayerFile, IsAnOrdinaryFileOfUnfoldedGridsInMetres) {
  const SurfaceLayer layer = ramp();
  writeLayers(file(), {{"foam", &layer}}, 35.0, {{"scene", "harbour.yaml"}});
  const auto grids = describeGrids(file());
  ASSERT_EQ(grids.size(), 2u);
  EXPECT_EQ(grids[0].name, "foam");
  EXPECT_EQ(grids[1].name, "foam_age");
  EXPECT_EQ(grids[0].type, "float");
  EXPECT_EQ(grids[0].voxels, 90u * 140u);
  EXPECT_NEAR(grids[0].lower.x, -20.0, 1e-9);
  EXPECT_NEAR(grids[0].lower.y, -30.0, 1e-9);
  EXPECT_NEAR(grids[0].upper.x, 25.0, 1e-9);
  EXPECT_NEAR(grids[0].upper.y, 40.0, 1e-9);
  EXPECT_DOUBLE_EQ(grids[0].voxelSize, 0.5);
}

TEST_F(LayerFile, DriftIsInTheGridsPlaceAtTheTimeOfWriting) {
  SurfaceLayer layer({.cellSize = 0.5, .drift = {1.0, 0.0}});
  layer.paint({0.0, 0.0}, {10.0, 10.0}, 0.0, [](glm::dvec2) { return 1.0f; });
  writeLayers(file(), {{"oil", &layer}}, 60.0);
  EXPECT_NEAR(describeGrids(file())[0].lower.x, 60.0, 1e-9);
  SurfaceLayer still({.cellSize = 0.5});
  readLayer(file(), "oil", 0.0, still);
  EXPECT_GT(still.coverAt({65.0, 5.0}, 0.0), 0.99f);
}

TEST_F(LayerFile, IsReadIntoCellsOfAnotherSize) {
  const SurfaceLayer layer = ramp();
  writeLayers(file(), {{"foam", &layer}}, 10.0);
  for (const double size : {0.2, 1.3}) {
    SurfaceLayer back({.cellSize = size});
    readLayer(file(), "foam", 10.0, back);
    // Nearest voxel, then bilinear: up to a cell and a voxel apart, on a slope of 0.01.
    for (double x = -18.0; x < 23.0; x += 2.3) {
      EXPECT_NEAR(back.coverAt({x, 3.0}, 10.0), 0.5 + 0.01 * x + 0.006, 0.01 * (size + 0.5));
    }
  }
}

TEST_F(LayerFile, AnEmptyLayerGivesEmptyGrids) {
  const SurfaceLayer layer;
  writeLayers(file(), {{"foam", &layer}}, 0.0);
  EXPECT_EQ(describeGrids(file())[0].voxels, 0u);
  SurfaceLayer back;
  readLayer(file(), "foam", 0.0, back);
  EXPECT_TRUE(back.empty());
}

TEST_F(LayerFileHard, WhatIsNoFileOrNoVdbFileIsNamed) {
  SurfaceLayer layer;
  const auto read = [&](const fs::path& path) {
    return messageOf([&] { readLayer(path, "", 0.0, layer); });
  };
  EXPECT_NE(read(file("absent.vdb")).find("no such file"), std::string::npos);
  std::ofstream(file("text.vdb")) << "oil: everywhere\n";
  const std::string message = read(file("text.vdb"));
  EXPECT_NE(message.find("text.vdb"), std::string::npos) << message;
  EXPECT_NE(message.find("OpenVDB"), std::string::npos) << message;
  std::ofstream(file("empty.vdb")).flush();
  EXPECT_NE(read(file("empty.vdb")).find("OpenVDB"), std::string::npos);
  EXPECT_TRUE(layer.empty());
}

TEST_F(LayerFileHard, AFileCutShortAnywhereIsRefusedOrWhole) {
  const SurfaceLayer layer = ramp();
  writeLayers(file(), {{"foam", &layer}}, 10.0);
  std::ifstream stream(file(), std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(stream)), {});
  ASSERT_GT(bytes.size(), 2000u);
  for (const double part : {0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99}) {
    const auto size = static_cast<std::size_t>(part * static_cast<double>(bytes.size()));
    std::ofstream(file("cut.vdb"), std::ios::binary) << bytes.substr(0, size);
    SurfaceLayer back;
    EXPECT_NE(messageOf([&] { readLayer(file("cut.vdb"), "foam", 0.0, back); }), "") << part;
  }
}

TEST_F(LayerFileHard, UnknownGridsAreNamedBesideThoseThereAre) {
  const SurfaceLayer layer = ramp();
  writeLayers(file(), {{"foam", &layer}}, 10.0);
  SurfaceLayer back;
  const std::string message = messageOf([&] { readLayer(file(), "oil", 0.0, back); });
  EXPECT_NE(message.find("'oil'"), std::string::npos);
  EXPECT_NE(message.find("'foam'"), std::string::npos);
  EXPECT_NE(messageOf([&] { readLayer(file(), "", 0.0, back); }).find("several"),
            std::string::npos);
}

TEST_F(LayerFileHard, ValuesThatAreNoCoverAreRefused) {
  const SurfaceLayer layer = ramp();
  writeLayers(file(), {{"foam", &layer}}, 60.0);
  SurfaceLayer back;
  const std::string message = messageOf([&] { readLayer(file(), "foam_age", 0.0, back); });
  EXPECT_NE(message.find("50"), std::string::npos) << message;  // s of age
  EXPECT_NE(message.find("[0, 1]"), std::string::npos) << message;
}

TEST_F(LayerFileHard, MoreCellsThanALayerHoldsAreRefused) {
  const SurfaceLayer layer = ramp();
  writeLayers(file(), {{"foam", &layer}}, 10.0);
  SurfaceLayer fine({.cellSize = 0.01, .mostBytes = 1u << 20});
  EXPECT_NE(messageOf([&] { readLayer(file(), "foam", 0.0, fine); }).find("larger cells"),
            std::string::npos);
}

TEST_F(LayerFileHard, AFolderThatCannotBeWrittenToIsNamed) {
  const SurfaceLayer layer = ramp();
  EXPECT_NE(messageOf([&] {
              writeLayers(file("no/such.vdb"), {{"foam", &layer}}, 0.0);
            }).find("such.vdb"),
            std::string::npos);
}

}  // namespace
}  // namespace seaway
