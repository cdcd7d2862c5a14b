#include "surface/spectra/readers/direction_grid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "surface/angles.h"
#include "surface/input_error.h"

namespace seaway {
namespace {

const TextFile noFile{"f", ""};

DirectionGrid gridOf(const std::vector<double>& toward_rad_deg) {
  std::vector<double> toward;
  for (const double degrees : toward_rad_deg) toward.push_back(radiansFromDegrees(degrees));
  return {toward, TextCursor(noFile)};
}

TEST(DirectionGrid, PutsDirectionsInRisingOrderWithTheirDensities) {
  const DirectionGrid grid = gridOf({-45.0, 315.0 - 90.0, 45.0, 135.0});
  DirectionalSpectrum spectrum;
  grid.addRow(0.1, {4.0, 3.0, 1.0, 2.0}, spectrum);
  ASSERT_EQ(spectrum.direction.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(spectrum.direction[i], radiansFromDegrees(45.0 + 90.0 * static_cast<double>(i)),
                1e-12);
    EXPECT_EQ(spectrum.density[i], static_cast<double>(i + 1));
  }
  EXPECT_FALSE(grid.wasSector());
}

TEST(DirectionGrid, SmoothsRoundedDirections) {
  std::vector<double> rounded;
  for (int i = 0; i < 36; ++i) rounded.push_back(5.0 + 10.0 * i + (i % 2 ? 0.2 : -0.2));
  const DirectionGrid grid = gridOf(rounded);
  EXPECT_NEAR(grid.directions()[0], radiansFromDegrees(5.0), 1e-12);
  EXPECT_NEAR(grid.directions()[35], radiansFromDegrees(355.0), 1e-12);
}

TEST(DirectionGrid, FillsTheRestOfASectorWithNoEnergy) {
  const DirectionGrid grid = gridOf({350.0, 0.0, 10.0, 20.0});
  EXPECT_TRUE(grid.wasSector());
  ASSERT_EQ(grid.directions().size(), 36u);
  DirectionalSpectrum spectrum;
  grid.addRow(0.1, {1.0, 2.0, 3.0, 4.0}, spectrum);
  double sum = 0.0;
  for (const double density : spectrum.density) sum += density;
  EXPECT_EQ(sum, 10.0);
  EXPECT_EQ(spectrum.density[0], 2.0);
  EXPECT_NEAR(spectrum.direction[35], radiansFromDegrees(350.0), 1e-9);
  EXPECT_EQ(spectrum.density[35], 1.0);
}

TEST(DirectionGridHard, UnevenFewOrRepeatedDirectionsAreRefused) {
  EXPECT_THROW(gridOf({0.0, 180.0}), InputError);
  EXPECT_THROW(gridOf({0.0, 0.0, 0.0}), InputError);
  EXPECT_THROW(gridOf({0.0, 90.0, 180.0, 180.0, 270.0}), InputError);
  EXPECT_THROW(gridOf({0.0, 80.0, 180.0, 270.0}), InputError);
  EXPECT_THROW(gridOf({0.0, 10.0, 20.0, 45.0}), InputError);
  EXPECT_THROW(gridOf({0.0, 1e-7, 2e-7}), InputError);
  EXPECT_THROW(gridOf(std::vector<double>(4000, 1.0)), InputError);
}

TEST(DirectionGridHard, FrequenciesMustRiseWithinReason) {
  const TextCursor cursor(noFile);
  EXPECT_NO_THROW(requireRisingFrequencies({0.1, 0.2}, cursor));
  EXPECT_THROW(requireRisingFrequencies({0.1, 0.1}, cursor), InputError);
  EXPECT_THROW(requireRisingFrequencies({0.2, 0.1}, cursor), InputError);
  EXPECT_THROW(requireRisingFrequencies({0.0, 0.1}, cursor), InputError);
  EXPECT_THROW(requireRisingFrequencies({0.1, 1000.0}, cursor), InputError);
}

}  // namespace
}  // namespace seaway
