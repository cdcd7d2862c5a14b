#include "surface/disturbance/hull_footprint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "surface/dispersion.h"
#include "surface/disturbance/footprint_table.h"
#include "surface/input_error.h"

namespace seaway {
namespace {

double sincOf(double x) { return x == 0.0 ? 1.0 : std::sin(x) / x; }

TEST(HullFootprint, ABoxHasTheClosedForm) {
  const double length = 12.0, beam = 3.5, draft = 0.8;
  const HullFootprint box = HullFootprint::box(length, beam, draft);
  for (const glm::dvec2 k : {glm::dvec2(0.3, 0.0), glm::dvec2(0.0, 1.1), glm::dvec2(1.3, -2.2)}) {
    const double number = std::hypot(k.x, k.y);
    const double expected = length * beam * sincOf(k.x * length / 2) * sincOf(k.y * beam / 2) *
                            (1.0 - std::exp(-number * draft)) / number;
    const auto actual = box.spectrum(k, deepWater);
    // Double rounding of sums of a few terms of the size of the area over kL.
    EXPECT_NEAR(actual.real(), expected, 1e-9 * length * beam * draft);
    EXPECT_NEAR(actual.imag(), 0.0, 1e-9 * length * beam * draft);
  }
}

TEST(HullFootprint, FiniteDepthWeighsLayersByTheirPressure) {
  const double draft = 2.0, depth = 3.0, k = 0.7;
  const HullFootprint box = HullFootprint::box(1.0, 1.0, draft);
  // ∫ cosh k(z + d)/cosh kd dz over the draft.
  const double layers =
      (std::sinh(k * depth) - std::sinh(k * (depth - draft))) / (k * std::cosh(k * depth));
  EXPECT_NEAR(box.spectrum({k, 0.0}, depth).real(), sincOf(k / 2) * layers, 1e-12);
  // A bed far below is no bed.
  EXPECT_NEAR(std::abs(box.spectrum({k, 0.0}, 1e4) - box.spectrum({k, 0.0}, deepWater)), 0.0,
              1e-12);
}

TEST(HullFootprint, TheVolumeIsTheSpectrumAtZero) {
  EXPECT_NEAR(HullFootprint::box(12, 3.5, 0.8).volume(), 12 * 3.5 * 0.8, 1e-9);
  // 4/9 LBT for the parabolas; polygons of 41 stations and lines of 9 waterlines miss 1/1600 +
  // 1/128.
  EXPECT_NEAR(HullFootprint::wigley(12, 3.5, 0.8, 9).volume(), 12 * 3.5 * 0.8 * 4.0 / 9.0,
              0.01 * 12 * 3.5 * 0.8);
  // The series near zero meets the sum over edges.
  const HullFootprint wigley = HullFootprint::wigley(12, 3.5, 0.8);
  EXPECT_NEAR(wigley.spectrum({1e-6, 0.0}, deepWater).real(), wigley.volume(), 1e-4);
  EXPECT_NEAR(wigley.spectrum({2e-6, 0.0}, deepWater).real(), wigley.volume(), 1e-4);
}

TEST(HullFootprint, EitherSenseOfAnOutlineIsTheSameHull) {
  const std::vector<glm::dvec2> outline{{3, 0}, {0, 1}, {-2, -1}};
  const std::vector<glm::dvec2> reversed(outline.rbegin(), outline.rend());
  const HullFootprint one({{0.0, outline}, {-1.0, outline}});
  const HullFootprint other({{0.0, reversed}, {-1.0, reversed}});
  const glm::dvec2 k(0.8, -0.4);
  EXPECT_NEAR(std::abs(one.spectrum(k, 5.0) - other.spectrum(k, 5.0)), 0.0, 1e-12);
  // A real footprint: Ĥ(−k) = conj Ĥ(k).
  EXPECT_NEAR(std::abs(one.spectrum(-k, 5.0) - std::conj(one.spectrum(k, 5.0))), 0.0, 1e-12);
}

TEST(HullFootprint, CollapsedOntoTheCentreplaneOnlyDepthKnowsTheLateralWaveNumber) {
  const HullFootprint thin = HullFootprint::box(12, 3.5, 0.8).collapsedOntoCentreplane();
  const double k = std::hypot(0.4, 1.5);
  const double expected = 12 * 3.5 * sincOf(0.4 * 6) * (1 - std::exp(-k * 0.8)) / k;
  EXPECT_NEAR(thin.spectrum({0.4, 1.5}, deepWater).real(), expected, 1e-9);
}

TEST(HullFootprint, TheTableIsWithinAThousandthOfTheVolume) {
  const HullFootprint hull = HullFootprint::wigley(12, 3.5, 0.8);
  const FootprintTable table(hull, deepWater, 3.2);
  double worst = 0.0;
  const auto at = [&](std::int32_t x, std::int32_t y) {
    const float* entry = table.values() + 2 * ((y + table.alongY()) * (table.alongX() + 1) + x);
    return std::complex<double>(entry[0], entry[1]);
  };
  // Middles of cells are the worst places of a bilinear table.
  for (std::int32_t y = -table.alongY(); y < table.alongY(); y += 7) {
    for (std::int32_t x = 0; x < table.alongX(); x += 5) {
      const auto middle = 0.25 * (at(x, y) + at(x + 1, y) + at(x, y + 1) + at(x + 1, y + 1));
      const auto exact =
          hull.spectrum({(x + 0.5) * table.spacing(), (y + 0.5) * table.spacing()}, deepWater);
      worst = std::max(worst, std::abs(middle - exact));
    }
  }
  EXPECT_LE(worst, 1e-3 * hull.volume());
}

TEST(HullFootprintHard, RefusesHullsThatCannotBe) {
  using Waterlines = std::vector<Waterline>;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(HullFootprint(Waterlines{{0.0, {}}}), InputError);
  EXPECT_THROW(HullFootprint(Waterlines{{1.0, {}}, {0.0, {}}}), InputError);
  EXPECT_THROW(HullFootprint(Waterlines{{-1.0, {}}, {-1.0, {}}}), InputError);
  EXPECT_THROW(HullFootprint(Waterlines{{0.0, {{nan, 0.0}}}, {-1.0, {}}}), InputError);
  const std::vector<double> x{0.0, 1.0}, z{0.0, -1.0}, three{1.0, 1.0, 1.0}, negative{1, 1, -1, 1};
  EXPECT_THROW(HullFootprint::fromHalfBreadths(x, z, three), InputError);
  EXPECT_THROW(HullFootprint::fromHalfBreadths(x, z, negative), InputError);
}

TEST(HullFootprintHard, AnEmptyHullMakesNothing) {
  const HullFootprint nothing({{0.0, {}}, {-1.0, {}}});
  EXPECT_EQ(nothing.volume(), 0.0);
  EXPECT_EQ(std::abs(nothing.spectrum({1.0, 1.0}, deepWater)), 0.0);
}

}  // namespace
}  // namespace seaway
