#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>

#include "surface/angles.h"
#include "surface/input_error.h"
#include "surface/spectra/readers/read_spectra.h"
#include "tests/surface/readers/spectrum_writers.h"

/// What SWAN and WAVEWATCH III files may hold beyond the plain case.
namespace seaway {
namespace {

std::string messageOf(const std::string& text) {
  try {
    parseSpectra({{"f", text}});
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

const std::string swanHead =
    "SWAN 1\nTIME\n1\nLOCATIONS\n2\n1000.0 2000.0\n3000.0 2000.0\nRFREQ\n2\n0.1\n0.2\n";
const std::string swanGrid = "CDIR\n4\n0.\n90.\n180.\n270.\n";
const std::string swanQuantity = "QUANT\n1\nVaDens\nm2/Hz/degr\n-99\n20200608.035000\n";
const std::string swanRecords =
    "FACTOR\n0.01\n1 2 3 4\n5 6 7 8\nZERO\n20200608.045000\nNODATA\nFACTOR\n1E-2\n0 0 0 1\n-99 0 0 "
    "0\n";
const std::string swan = swanHead + swanGrid + swanQuantity + swanRecords;

TEST(Swan, PlacesOfAPlaneZeroAndNodataAreRead) {
  const auto records = parseSpectra({{"f", swan}});
  ASSERT_EQ(records.size(), 4u);
  // Cartesian directions are toward: column 0 goes east.
  EXPECT_NEAR(records[0].spectrum.at(0, 0), 0.01 * 180.0 / pi, 1e-12);
  EXPECT_NEAR(records[0].spectrum.at(1, 3), 0.08 * 180.0 / pi, 1e-12);
  EXPECT_NEAR(records[0].spectrum.direction[1], 0.5 * pi, 1e-12);
  EXPECT_FALSE(records[0].position);
  EXPECT_EQ(records[0].location, "1");
  EXPECT_EQ(records[0].notes.size(), 2u);  // the plane, and relative frequencies
  EXPECT_EQ(records[1].spectrum.energy.moment(0), 0.0);
  EXPECT_EQ(records[1].time, "2020-06-08T03:50Z");
  EXPECT_FALSE(records[2].hasSpectrum());
  EXPECT_EQ(records[2].time, "2020-06-08T04:50Z");
  // One of two frequencies has a missing bin.
  EXPECT_FALSE(records[3].hasSpectrum());
  EXPECT_EQ(records[3].missingBins, 1u);
}

TEST(Swan, EnergyDensityIsDividedByTheWeightOfWater) {
  const std::string energy =
      replaced(replaced(swan, "VaDens", "EnDens"), "m2/Hz/degr", "J/m2/Hz/degr");
  const double ratio = parseSpectra({{"f", swan}})[0].spectrum.at(1, 3) /
                       parseSpectra({{"f", energy}})[0].spectrum.at(1, 3);
  EXPECT_NEAR(ratio, 1025.0 * 9.81, 1e-6);
}

TEST(SwanHard, EveryFaultNamesFileAndLine) {
  EXPECT_EQ(messageOf(replaced(swan, "TIME\n1", "TIME\n2")),
            "f:3: the time coding: '2' is not allowed; must be a whole number in [1, 1]");
  EXPECT_EQ(messageOf(replaced(swan, "m2/Hz/degr", "cm2/Hz")),
            "f:21: unit 'cm2/Hz' is not allowed; must be one of: m2/Hz/degr, J/m2/Hz/degr, m2/Hz, "
            "J/m2/Hz");
  EXPECT_EQ(messageOf(replaced(swan, "0.2\n", "0.1\n")),
            "f:11: frequency 0.100000 Hz does not rise above 0.100000");
  EXPECT_EQ(messageOf(replaced(swan, "1 2 3 4", "1 2 -3 4")),
            "f:26: a density below 0 is not allowed");
  EXPECT_EQ(messageOf(replaced(swan, "1 2 3 4", "1 2 nan 4")),
            "f:26: a density: 'nan' is not a number");
  EXPECT_EQ(messageOf(replaced(swan, "1 2 3 4", "1 2 3 4 5")),
            "f:26: '5' is not allowed after the densities of a frequency");
  EXPECT_EQ(messageOf(replaced(swan, "ZERO", "NONE")),
            "f:28: 'NONE' is not allowed; must be one of: FACTOR, ZERO, NODATA");
  EXPECT_EQ(messageOf(replaced(swan, "20200608.04", "20201308.04")),
            "f:29: time '20201308.045000' is not of the form 20161011.000000");
  EXPECT_EQ(messageOf(replaced(swan, "180.\n", "170.\n")),
            "f:17: directions must be even over a turn or a sector of it; after 90.00 deg comes "
            "170.00 deg");
}

TEST(Swan, TheModelsRecordHasOneWaveHeightByTwoIntegrations) {
  const auto path = std::filesystem::path(SEAWAY_SHARED_DIR) / "data/swan/swanfile.spec";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no SWAN file at " << path;
  const auto records = readSpectra(path);
  ASSERT_EQ(records.size(), 5u);
  EXPECT_EQ(records[0].time, "2016-10-11T00:00Z");
  EXPECT_NEAR(records[0].position->latitude_deg, -38.173599, 1e-9);
  EXPECT_NEAR(records[0].position->longitude_deg, 174.672501, 1e-9);
  for (const SpectrumRecord& record : records) {
    const DirectionalSpectrum& s = record.spectrum;
    ASSERT_EQ(s.energy.frequency.size(), 24u);
    ASSERT_EQ(s.direction.size(), 36u);
    // Over frequency first, then over direction: the other order than `integrateGrid`.
    double sum = 0.0;
    for (std::size_t d = 0; d < 36; ++d) {
      for (std::size_t f = 1; f < 24; ++f) {
        sum += 0.5 * (s.at(f, d) + s.at(f - 1, d)) *
               (s.energy.frequency[f] - s.energy.frequency[f - 1]);
      }
    }
    const double height = 4.0 * std::sqrt(sum * 2.0 * pi / 36.0);
    EXPECT_GT(height, 0.5);
    EXPECT_NEAR(s.energy.significantWaveHeight() / height, 1.0, 1e-12);
  }
}

TEST(Swan, TheModelsFirstRecordMatchesItsOwnNumbers) {
  const auto path = std::filesystem::path(SEAWAY_SHARED_DIR) / "data/swan/swanfile.spec";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no SWAN file at " << path;
  const auto records = readSpectra(path);
  // Sixth row (0.0737 Hz is the seventh), column 25 (245 deg): 9998 × factor per degree.
  const DirectionalSpectrum& s = records[0].spectrum;
  const double toward = towardFromCompassFrom(245.0);
  for (std::size_t d = 0; d < 36; ++d) {
    if (std::abs(std::remainder(s.direction[d] - toward, 2.0 * pi)) > 1e-9) continue;
    EXPECT_NEAR(s.at(5, d), 9998.0 * 1.68566278e-5 * 180.0 / pi, 1e-9);
    return;
  }
  FAIL() << "no column toward " << toward;
}

const std::string ww3 =
    "'WAVEWATCH III SPECTRA'     2     4     2 'two points'\n 0.100E+00 0.200E+00\n"
    " 0.157E+01 0.000E+00 0.471E+01 0.314E+01\n20200608 035000\n"
    "'P 1       '  34.00-117.00     873.0   6.20 190.0   0.10 350.0\n 1. 2. 3. 4. 5. 6. 7.\n "
    "0.123-100\n"
    "'P2'  -34.00 117.00      0.0   6.20 190.0   0.10 350.0\n 0 0 0 0 0 0 0 0\n";

TEST(Wavewatch, GluedColumnsNamesAndShortExponentsAreRead) {
  const auto records = parseSpectra({{"f", ww3}});
  ASSERT_EQ(records.size(), 2u);
  EXPECT_EQ(records[0].location, "P 1");
  EXPECT_EQ(records[0].position->latitude_deg, 34.0);
  EXPECT_EQ(records[0].position->longitude_deg, -117.0);
  EXPECT_EQ(records[0].depth, 873.0);
  EXPECT_EQ(records[1].position->latitude_deg, -34.0);
  EXPECT_FALSE(records[1].depth);
  // Toward, clockwise from north: 1.57 is east, then north, west, south. Frequencies run fastest.
  const DirectionalSpectrum& s = records[0].spectrum;
  EXPECT_NEAR(s.direction[0], 0.0, 2e-3);
  EXPECT_EQ(s.at(0, 0), 1.0);
  EXPECT_EQ(s.at(1, 0), 2.0);
  EXPECT_EQ(s.at(0, 1), 3.0);
  EXPECT_EQ(s.at(0, 2), 5.0);
  EXPECT_EQ(s.at(1, 3), 0.123e-100);
}

TEST(WavewatchHard, EveryFaultNamesFileAndLine) {
  EXPECT_EQ(messageOf(replaced(ww3, "     4     2", "   4.5     2")),
            "f:1: number of directions: '4.5' is not allowed; must be a whole number in [3, 3600]");
  EXPECT_EQ(messageOf(replaced(ww3, "20200608", "20200631")), "f:4: not a date and time");
  EXPECT_EQ(messageOf(replaced(ww3, "5. 6.", "-5. 6.")), "f:6: a density below 0 is not allowed");
  EXPECT_EQ(messageOf(replaced(ww3, "  34.00-117", "  94.00-117")),
            "f:5: latitude and longitude must be in [-90, 90] and [-360, 360] deg");
  EXPECT_EQ(messageOf(replaced(ww3, " 0 0 0 0 0 0 0 0", " 0 0 0 0 0 0 0")),
            "f:9: ends before a density");
}

}  // namespace
}  // namespace seaway
