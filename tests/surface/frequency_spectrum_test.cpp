#include "surface/spectra/frequency_spectrum.h"

#include <gtest/gtest.h>

#include <cmath>

namespace seaway {
namespace {

const FrequencySpectrum triangle{{0.1, 0.2, 0.3}, {0.0, 4.0, 0.0}};

TEST(FrequencySpectrum, MomentsOfATriangleAreExact) {
  EXPECT_DOUBLE_EQ(triangle.moment(0), 0.4);
  EXPECT_DOUBLE_EQ(triangle.significantWaveHeight(), 4.0 * std::sqrt(0.4));
  EXPECT_DOUBLE_EQ(triangle.meanPeriodM01(), 0.4 / (0.2 * 4.0 * 0.1));
  EXPECT_DOUBLE_EQ(triangle.peakPeriod(), 5.0);
}

TEST(FrequencySpectrum, IsLinearBetweenBinsAndZeroOutside) {
  EXPECT_DOUBLE_EQ(triangle.at(0.15), 2.0);
  EXPECT_DOUBLE_EQ(triangle.at(0.2), 4.0);
  EXPECT_DOUBLE_EQ(triangle.at(0.3), 0.0);
  EXPECT_DOUBLE_EQ(triangle.at(0.05), 0.0);
  EXPECT_DOUBLE_EQ(triangle.at(NAN), 0.0);
}

TEST(FrequencySpectrum, PeakAtTheEdgeOfTheBandIsTheEdge) {
  EXPECT_DOUBLE_EQ((FrequencySpectrum{{0.1, 0.2}, {3.0, 1.0}}).peakPeriod(), 10.0);
}

TEST(FrequencySpectrumHard, ASpectrumWithoutEnergyHasNoPeak) {
  EXPECT_EQ((FrequencySpectrum{{0.1, 0.2, 0.3}, {0.0, 0.0, 0.0}}).peakPeriod(), 0.0);
}

TEST(FrequencySpectrumHard, EveryFaultIsNamed) {
  const auto problem = [](FrequencySpectrum spectrum) {
    return spectrum.validate().value_or("none");
  };
  EXPECT_EQ(problem(triangle), "none");
  EXPECT_EQ(problem({{0.1}, {1.0}}), "at least 2 frequencies are needed");
  EXPECT_EQ(problem({{0.1, 0.2}, {1.0}}), "as many densities as frequencies are needed");
  EXPECT_EQ(problem({{0.2, 0.1}, {1.0, 1.0}}), "frequency 0.1 Hz does not rise above 0.2");
  EXPECT_EQ(problem({{0.1, 0.1}, {1.0, 1.0}}), "frequency 0.1 Hz does not rise above 0.1");
  EXPECT_EQ(problem({{0.0, 0.1}, {1.0, 1.0}}), "frequency 0 Hz is not allowed; must be > 0");
  EXPECT_NE(problem({{0.1, 0.2}, {1.0, -1.0}}).find("density -1"), std::string::npos);
  EXPECT_NE(problem({{0.1, 0.2}, {1.0, NAN}}).find("density nan"), std::string::npos);
}

}  // namespace
}  // namespace seaway
