#include "surface/disturbance/layers/surface_layer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <thread>

#include "surface/input_error.h"
#include "tests/support/allocation_counter.h"

namespace seaway {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
// Cover is kept in steps of 1/65535, age in steps of 1/8 s; the decay's tables are floats.
constexpr double coverStep = 2e-5;

float one(glm::dvec2) { return 1.0f; }

SurfaceLayer painted(const LayerSettings& settings, glm::dvec2 lower, glm::dvec2 upper, double t,
                     float cover = 1.0f) {
  SurfaceLayer layer(settings);
  EXPECT_EQ(layer.paint(lower, upper, t, [&](glm::dvec2) { return cover; }), Painted::done);
  return layer;
}

TEST(SurfaceLayer, WithoutPaintItHoldsNoNodeAndAllocatesNothing) {
  const auto before = test_support::allocationCount();
  const SurfaceLayer layer;
  EXPECT_EQ(layer.coverAt({3.0, 4.0}, 5.0), 0.0f);
  EXPECT_EQ(test_support::allocationCount(), before);
  EXPECT_EQ(layer.nodeCount(), 0u);
  EXPECT_EQ(layer.cellCount(), 0u);
  EXPECT_EQ(layer.memoryBytes(), 0u);
}

TEST(SurfaceLayer, CoverIsReadBackWhereItWasPaintedAndNowhereElse) {
  const SurfaceLayer layer = painted({.cellSize = 0.5}, {-3.0, -70.0}, {90.0, 2.0}, 1.0, 0.4f);
  // 186 × 144 cells have their centres in the box.
  EXPECT_EQ(layer.cellCount(), 186u * 144u);
  for (const glm::dvec2 inside :
       {glm::dvec2(-2.7, -69.7), {89.7, 1.7}, {0.0, 0.0}, {31.9, -63.9}}) {
    EXPECT_NEAR(layer.coverAt(inside, 1.0), 0.4, coverStep);
  }
  for (const glm::dvec2 outside : {glm::dvec2(-3.3, 0.0), {90.3, 0.0}, {0.0, 2.3}, {0.0, -70.3}}) {
    EXPECT_EQ(layer.coverAt(outside, 1.0), 0.0f);
  }
}

TEST(SurfaceLayer, CoverIsBilinearBetweenCellsAcrossLeavesAndTiles) {
  const auto slope = [](glm::dvec2 p) {
    return static_cast<float>(0.5 + 0.001 * p.x - 0.0007 * p.y);
  };
  SurfaceLayer layer({.cellSize = 1.0});
  ASSERT_EQ(layer.paint({-150.0, -280.0}, {150.0, 280.0}, 0.0, slope), Painted::done);
  for (double x = -140.0; x < 140.0; x += 7.37) {
    for (double y = -270.0; y < 270.0; y += 11.13) {
      EXPECT_NEAR(layer.coverAt({x, y}, 0.0), slope({x, y}), coverStep);
    }
  }
}

TEST(SurfaceLayer, CoverDecaysExponentiallyAsItIsRead) {
  const double decay = 40.0;
  const SurfaceLayer layer = painted({.decayTime = decay}, {0.0, 0.0}, {2.0, 2.0}, 100.0);
  for (const double age : {0.0, 0.06, 3.3, 17.21, 60.0, 120.0}) {
    EXPECT_NEAR(layer.coverAt({1.0, 1.0}, 100.0 + age), std::exp(-age / decay), coverStep);
  }
  EXPECT_EQ(layer.coverAt({1.0, 1.0}, 100.0 + 10.0 * decay), 0.0f);
}

TEST(SurfaceLayer, BeforeItWasLeftThereIsNoCover) {
  SurfaceLayer layer = painted({}, {0.0, 0.0}, {2.0, 2.0}, 10.0);
  layer.paint({10.0, 0.0}, {12.0, 2.0}, 20.0, one);
  EXPECT_EQ(layer.coverAt({1.0, 1.0}, 9.0), 0.0f);
  EXPECT_EQ(layer.coverAt({11.0, 1.0}, 15.0), 0.0f);
  EXPECT_GT(layer.coverAt({1.0, 1.0}, 15.0), 0.99f);
  EXPECT_EQ(layer.coverAt({1.0, 1.0}, -1e9), 0.0f);
}

TEST(SurfaceLayer, TheMoreCoversTheLess) {
  SurfaceLayer layer = painted({.decayTime = 10.0}, {0.0, 0.0}, {2.0, 2.0}, 0.0, 0.9f);
  layer.paint({0.0, 0.0}, {2.0, 2.0}, 1.0, [](glm::dvec2) { return 0.3f; });
  EXPECT_NEAR(layer.coverAt({1.0, 1.0}, 1.0), 0.9 * std::exp(-0.1), coverStep);
  layer.paint({0.0, 0.0}, {2.0, 2.0}, 20.0, [](glm::dvec2) { return 0.3f; });
  EXPECT_NEAR(layer.coverAt({1.0, 1.0}, 20.0), 0.3, coverStep);
}

TEST(SurfaceLayer, ItDriftsWithTheWater) {
  const SurfaceLayer layer = painted({.drift = {0.5, -1.0}}, {0.0, 0.0}, {4.0, 4.0}, 50.0);
  EXPECT_GT(layer.coverAt({2.0, 2.0}, 50.0), 0.99f);
  EXPECT_GT(layer.coverAt({2.0 + 10.0, 2.0 - 20.0}, 70.0), 0.99f);
  EXPECT_EQ(layer.coverAt({2.0, 2.0}, 70.0), 0.0f);
}

TEST(SurfaceLayer, ACopyIsASnapshotThatSharesWhatIsNotPaintedOn) {
  SurfaceLayer layer = painted({.cellSize = 0.25}, {0.0, 0.0}, {200.0, 200.0}, 0.0, 0.5f);
  const SurfaceLayer snapshot = layer;
  layer.paint({0.0, 0.0}, {5.0, 5.0}, 1.0, one);
  EXPECT_NEAR(snapshot.coverAt({2.0, 2.0}, 1.0), 0.5, coverStep);
  EXPECT_NEAR(layer.coverAt({2.0, 2.0}, 1.0), 1.0, coverStep);
  EXPECT_NEAR(layer.coverAt({150.0, 150.0}, 1.0), 0.5, coverStep);
  SurfaceLayer other = snapshot;
  other.paint({0.0, 0.0}, {5.0, 5.0}, 2.0, [](glm::dvec2) { return 0.7f; });
  EXPECT_NEAR(layer.coverAt({2.0, 2.0}, 2.0), 1.0, coverStep);
  EXPECT_NEAR(other.coverAt({2.0, 2.0}, 2.0), 0.7, coverStep);
}

TEST(SurfaceLayer, ReadersOfASnapshotAreNotDisturbedByStrokes) {
  SurfaceLayer layer = painted({}, {0.0, 0.0}, {50.0, 50.0}, 0.0, 0.5f);
  const SurfaceLayer snapshot = layer;
  std::size_t wrong = 0;
  std::thread reader([&] {
    for (int i = 0; i < 20000; ++i) {
      wrong += std::abs(snapshot.coverAt({0.01 * (i % 4900) + 0.3, 20.0}, 0.0) - 0.5f) > coverStep;
    }
  });
  for (int i = 0; i < 200; ++i) {
    layer.paint({0.2 * i, 0.0}, {0.2 * i + 3.0, 40.0}, 0.1 * i, one);
    if (i % 40 == 0) layer.prune(0.1 * i);
  }
  reader.join();
  EXPECT_EQ(wrong, 0u);
}

TEST(SurfaceLayer, PruningTakesWhatHasDecayedAndNothingElse) {
  SurfaceLayer layer = painted({.decayTime = 10.0}, {0.0, 0.0}, {40.0, 40.0}, 0.0);
  layer.paint({500.0, 0.0}, {540.0, 40.0}, 60.0, one);
  const std::size_t before = layer.memoryBytes();
  const float kept = layer.coverAt({520.0, 20.0}, 65.0);
  layer.prune(61.0);  // e^−6.1 is above 1/512
  EXPECT_EQ(layer.memoryBytes(), before);
  layer.prune(65.0);
  EXPECT_LT(layer.memoryBytes(), 0.6 * before);
  EXPECT_EQ(layer.coverAt({520.0, 20.0}, 65.0), kept);
  layer.prune(1e4);
  EXPECT_TRUE(layer.empty());
  EXPECT_EQ(layer.nodeCount(), 0u);
}

TEST(SurfaceLayer, VisitingMeetsEveryCellWithItsCoverAndAge) {
  SurfaceLayer layer({.cellSize = 2.0, .decayTime = 100.0});
  layer.paint({-70.0, -9.0}, {70.0, 9.0}, 8.0, one);
  std::size_t cells = 0;
  layer.visit(33.0, [&](const SurfaceLayer::Cell& cell) {
    ++cells;
    EXPECT_NEAR(cell.cover, std::exp(-0.25), coverStep);
    EXPECT_FLOAT_EQ(cell.age, 25.0f);
    const glm::dvec2 centre(2.0 * cell.i + 1.0, 2.0 * cell.j + 1.0);
    EXPECT_LE(std::abs(centre.x), 70.0);
    EXPECT_LE(std::abs(centre.y), 9.0);
  });
  EXPECT_EQ(cells, layer.cellCount());
  EXPECT_EQ(cells, 70u * 10u);  // centres at odd metres
}

TEST(SurfaceLayer, SamplingAllocatesNothing) {
  const SurfaceLayer layer = painted({}, {0.0, 0.0}, {50.0, 50.0}, 0.0);
  const std::vector<glm::dvec2> points{{1.0, 1.0}, {49.0, 3.0}, {700.0, 1.0}};
  std::vector<float> cover(points.size());
  const auto before = test_support::allocationCount();
  layer.sample(points, 1.0, cover);
  EXPECT_EQ(test_support::allocationCount(), before);
}

// A launch's trail of ten minutes at 6 m/s, 22 m wide, in cells of 1/8 m, on a slant.
TEST(SurfaceLayer, TenMinutesOfTrailOfFiveMillionCellsStayBelow30Megabytes) {
  SurfaceLayer layer({.cellSize = 0.125, .decayTime = 900.0});
  const glm::dvec2 along(std::cos(0.5), std::sin(0.5)), across(-along.y, along.x);
  for (int second = 0; second < 600; ++second) {
    const glm::dvec2 from = 6.0 * second * along, to = from + 6.0 * along;
    const glm::dvec2 low = glm::min(from, to) - 12.0, high = glm::max(from, to) + 12.0;
    layer.paint(low, high, second, [&](glm::dvec2 p) {
      const double ahead = glm::dot(p - from, along), aside = glm::dot(p - from, across);
      return ahead >= 0.0 && ahead < 6.0 && std::abs(aside) < 11.0 ? 0.8f : 0.0f;
    });
  }
  EXPECT_GT(layer.cellCount(), 5'000'000u);
  EXPECT_LE(layer.memoryBytes(), 30'000'000u);
  RecordProperty("cells", static_cast<int>(layer.cellCount()));
  RecordProperty("bytes", static_cast<int>(layer.memoryBytes()));
}

TEST(SurfaceLayerHard, PlacesAndTimesThatAreNotFiniteChangeNothing) {
  SurfaceLayer layer = painted({}, {0.0, 0.0}, {2.0, 2.0}, 0.0);
  const std::size_t cells = layer.cellCount();
  for (const double bad : {nan, infinity, -infinity, 1e9}) {
    EXPECT_EQ(layer.paint({bad, 0.0}, {1.0, 1.0}, 1.0, one), Painted::notFinite);
    EXPECT_EQ(layer.paint({0.0, 0.0}, {1.0, bad}, 1.0, one), Painted::notFinite);
    EXPECT_EQ(layer.coverAt({bad, 1.0}, 1.0), 0.0f);
    EXPECT_EQ(layer.coverAt({1.0, bad}, 1.0), 0.0f);
  }
  EXPECT_EQ(layer.paint({0.0, 0.0}, {1.0, 1.0}, nan, one), Painted::notFinite);
  EXPECT_EQ(layer.coverAt({1.0, 1.0}, nan), 0.0f);
  EXPECT_EQ(layer.paint({0.0, 0.0}, {1.0, 1.0}, 1.0, [](glm::dvec2) { return std::nanf(""); }),
            Painted::done);
  EXPECT_EQ(layer.cellCount(), cells);
}

TEST(SurfaceLayerHard, CoverAboveOneIsHeldAndInsideOutBoxesAreEmpty) {
  SurfaceLayer layer;
  layer.paint({0.0, 0.0}, {2.0, 2.0}, 0.0, [](glm::dvec2) { return 1e30f; });
  EXPECT_EQ(layer.coverAt({1.0, 1.0}, 0.0), 1.0f);
  EXPECT_EQ(layer.paint({9.0, 9.0}, {8.0, 10.0}, 0.0, one), Painted::done);
  EXPECT_EQ(layer.coverAt({8.5, 9.5}, 0.0), 0.0f);
}

TEST(SurfaceLayerHard, AHundredAndFiftyKilometresAwayACellIsWhereItBelongs) {
  const glm::dvec2 far(150e3, -149999.9);
  SurfaceLayer layer({.cellSize = 0.1});
  layer.paint(far, far + 1.0, 0.0, one);
  EXPECT_EQ(layer.cellCount(), 100u);
  EXPECT_GT(layer.coverAt(far + 0.5, 0.0), 0.99f);
  EXPECT_EQ(layer.coverAt(far - 0.2, 0.0), 0.0f);
}

TEST(SurfaceLayerHard, AStrokeThatIsTooLargeIsRefusedAndMemoryIsBounded) {
  SurfaceLayer layer({.cellSize = 0.1, .mostBytes = 1u << 20});
  EXPECT_EQ(layer.paint({0.0, 0.0}, {1e6, 1e6}, 0.0, one), Painted::tooLarge);
  EXPECT_TRUE(layer.empty());
  EXPECT_EQ(layer.paint({0.0, 0.0}, {200.0, 200.0}, 0.0, one), Painted::full);
  EXPECT_LT(layer.memoryBytes(), 1.1 * (1u << 20));
  EXPECT_EQ(layer.paint({0.0, 500.0}, {2.0, 502.0}, 1.0, one), Painted::full);
}

TEST(SurfaceLayerHard, AfterADayMemoryIsFlatAndEarlierStrokesAreRefused) {
  SurfaceLayer layer({.cellSize = 0.5, .decayTime = 60.0});
  std::size_t afterAnHour = 0, most = 0;
  for (int minute = 0; minute < 24 * 60; ++minute) {
    const double t = 60.0 * minute, x = 5.0 * t;
    layer.paint({x, 0.0}, {x + 30.0, 8.0}, t, one);
    layer.prune(t);
    if (minute == 60) afterAnHour = layer.memoryBytes();
    if (minute > 60) most = std::max(most, layer.memoryBytes());
    EXPECT_NEAR(layer.coverAt({x + 15.0, 4.0}, t + 30.0), std::exp(-0.5), coverStep);
  }
  EXPECT_LE(most, 1.1 * afterAnHour);
  EXPECT_EQ(layer.paint({0.0, 0.0}, {2.0, 2.0}, 0.0, one), Painted::tooEarly);
}

TEST(SurfaceLayerHard, WhatNeverDecaysOutlastsTheStampsThatTellItsAge) {
  SurfaceLayer layer = painted({}, {0.0, 0.0}, {4.0, 4.0}, 0.0, 0.6f);
  for (int hour = 1; hour < 50; ++hour) {
    layer.paint({100.0, 0.0}, {104.0, 4.0}, 3600.0 * hour, one);
    EXPECT_NEAR(layer.coverAt({2.0, 2.0}, 3600.0 * hour), 0.6, coverStep);
  }
  EXPECT_NEAR(layer.coverAt({2.0, 2.0}, 1e9), 0.6, coverStep);
}

TEST(SurfaceLayerHard, SettingsThatCannotBeAreRefused) {
  for (const double bad : {0.0, -1.0, nan, infinity, 1000.0}) {
    EXPECT_THROW(SurfaceLayer({.cellSize = bad}), InputError) << bad;
  }
  for (const double bad : {0.0, -1.0, nan, -infinity, 1e6}) {
    EXPECT_THROW(SurfaceLayer({.decayTime = bad}), InputError) << bad;
  }
  EXPECT_THROW(SurfaceLayer({.drift = {nan, 0.0}}), InputError);
}

}  // namespace
}  // namespace seaway
