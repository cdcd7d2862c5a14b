#include "surface/spectra/readers/read_spectra.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "surface/angles.h"
#include "surface/input_error.h"
#include "tests/surface/readers/spectrum_writers.h"

namespace seaway {
namespace {

namespace fs = std::filesystem;
using test::KnownRecord;
using test::WrittenFiles;

constexpr std::size_t bins = 40;
constexpr std::size_t directions = 24;

double highest(const std::vector<double>& values) {
  double most = 0.0;
  for (const double value : values) most = std::fmax(most, value);
  return most;
}

/// Densities within `rounding` of the highest; at bins with energy, moments within
/// `momentRounding`.
void expectSame(const SpectrumRecord& read, const KnownRecord& known, double rounding,
                double momentRounding) {
  EXPECT_EQ(read.time, known.time);
  const FrequencySpectrum& energy = known.spectrum.energy;
  ASSERT_EQ(read.spectrum.energy.frequency.size(), energy.frequency.size());
  for (std::size_t i = 0; i < energy.frequency.size(); ++i) {
    EXPECT_NEAR(read.spectrum.energy.frequency[i], energy.frequency[i], 6e-6);
    EXPECT_NEAR(read.spectrum.energy.density[i], energy.density[i],
                rounding * highest(energy.density));
    if (energy.density[i] < 0.05 * highest(energy.density)) continue;
    const DirectionalMoments& m = read.spectrum.moments.at(i);
    EXPECT_NEAR(m.a1, known.spectrum.moments[i].a1, momentRounding);
    EXPECT_NEAR(m.b1, known.spectrum.moments[i].b1, momentRounding);
    if (!m.hasSecond()) continue;
    EXPECT_NEAR(m.a2, known.spectrum.moments[i].a2, momentRounding);
    EXPECT_NEAR(m.b2, known.spectrum.moments[i].b2, momentRounding);
  }
}

void expectPosition(const SpectrumRecord& read, const KnownRecord& known) {
  ASSERT_TRUE(read.position);
  EXPECT_NEAR(read.position->latitude_deg, known.latitude_deg, 0.006);
  EXPECT_NEAR(read.position->longitude_deg, known.longitude_deg, 0.006);
}

/// Reads what a writer wrote of the known records and compares.
void expectRoundTrip(const WrittenFiles& written, const std::vector<KnownRecord>& known,
                     double rounding, double momentRounding) {
  SCOPED_TRACE(written.format + " " + written.files[0].name);
  const auto records = parseSpectra(written.files);
  ASSERT_EQ(records.size(), known.size());
  for (std::size_t i = 0; i < records.size(); ++i) {
    EXPECT_EQ(records[i].format, written.format);
    EXPECT_EQ(records[i].file, written.files[0].name);
    EXPECT_EQ(records[i].missingBins, 0u);
    expectSame(records[i], known[i], rounding, momentRounding);
  }
}

TEST(ReadSpectra, NdbcRealtimeFilesComeBackWithBothMoments) {
  const auto known = test::knownRecords(bins, directions);
  const auto written = test::ndbcRealtimeFiles(known);
  // Five decimals of moments and densities of about 1.
  expectRoundTrip(written, known, 1e-5, 2e-5);
  EXPECT_TRUE(parseSpectra(written.files)[0].spectrum.moments[20].hasSecond());
}

TEST(ReadSpectra, NdbcYearlyFilesComeBackWithBothMoments) {
  const auto known = test::knownRecords(bins, directions);
  const auto written = test::ndbcYearlyFiles(known);
  expectRoundTrip(written, known, 1e-5, 2e-5);
  EXPECT_TRUE(parseSpectra(written.files)[0].spectrum.moments[20].hasSecond());
}

TEST(ReadSpectra, SwanGridsComeBackBinByBin) {
  const auto known = test::knownRecords(bins, directions);
  const auto written = test::swanFile(known);
  // Whole numbers up to 9999 at the highest bin of the grid: half of one, summed over directions.
  expectRoundTrip(written, known, 2e-4, 2e-3);
  const auto records = parseSpectra(written.files);
  expectPosition(records[0], known[0]);
  const DirectionalSpectrum& grid = records[0].spectrum;
  ASSERT_EQ(grid.direction.size(), directions);
  for (std::size_t i = 0; i < grid.density.size(); ++i) {
    EXPECT_NEAR(grid.density[i], known[0].spectrum.density[i],
                6e-5 * highest(known[0].spectrum.density));
  }
  EXPECT_NEAR(grid.direction[5], known[0].spectrum.direction[5], 1e-6);
}

TEST(ReadSpectra, SwanLinesComeBackWithTheFirstMoment) {
  const auto known = test::knownRecords(bins, directions);
  const auto written = test::swanLineFile(known);
  expectRoundTrip(written, known, 1e-5, 1e-5);
  EXPECT_FALSE(parseSpectra(written.files)[0].spectrum.hasGrid());
}

TEST(ReadSpectra, WavewatchGridsComeBackBinByBin) {
  const auto known = test::knownRecords(bins, directions);
  const auto written = test::wavewatchFile(known);
  // Four digits of the densities; the grid's directions are even again.
  expectRoundTrip(written, known, 5e-4, 1e-3);
  const auto records = parseSpectra(written.files);
  expectPosition(records[0], known[0]);
  EXPECT_EQ(records[0].location, "41010");
  EXPECT_EQ(records[0].depth, 873.0);
  EXPECT_TRUE(records[0].spectrum.hasGrid());
}

TEST(ReadSpectra, DatawellSpectraComeBackWithBothMoments) {
  auto known = test::knownRecords(bins, directions)[0];
  FrequencySpectrum waverider{test::datawellFrequencies(), {}};
  for (const double f : waverider.frequency)
    waverider.density.push_back(known.spectrum.energy.at(f));
  known.spectrum.energy = waverider;
  known.spectrum.moments.assign(64, known.spectrum.moments[20]);
  known.spectrum.direction.clear();
  known.spectrum.density.clear();
  const auto written = test::datawellFile(known);
  expectRoundTrip(written, {known}, 1e-6, 1e-4);
  EXPECT_TRUE(parseSpectra(written.files)[0].spectrum.moments[20].hasSecond());
}

TEST(ReadSpectra, TriaxysSpectraComeBack) {
  const auto known = test::knownRecords(bins, directions);
  expectRoundTrip(test::triaxysFile(known[0]), {known[0]}, 1e-6, 1e-6);
  const auto records = parseSpectra(test::triaxysLineFile(known[0]).files);
  ASSERT_EQ(records.size(), 1u);
  EXPECT_TRUE(records[0].spectrum.moments.empty());
  EXPECT_NEAR(records[0].spectrum.energy.significantWaveHeight(),
              known[0].spectrum.energy.significantWaveHeight(), 1e-5);
}

TEST(ReadSpectra, SpotterSpectraComeBackWithBothMoments) {
  const auto known = test::knownRecords(bins, directions);
  const auto written = test::spotterFile(known);
  expectRoundTrip(written, known, 1e-8, 1e-8);
  const auto records = parseSpectra(written.files);
  expectPosition(records[0], known[0]);
  EXPECT_EQ(records[0].location, "SPOT-0000");
}

TEST(ReadSpectra, SpotterBulkParametersBecomeASpectrumThatSaysSo) {
  const auto known = test::knownRecords(bins, directions);
  const auto records = parseSpectra(test::spotterBulkFile(known).files);
  ASSERT_EQ(records.size(), 2u);
  const DirectionalSpectrum& s = records[0].spectrum;
  EXPECT_NEAR(s.energy.significantWaveHeight(), known[0].spectrum.energy.significantWaveHeight(),
              6e-4);
  // 600 points over 7.7 f_p: the parabola is good to a quarter of a step.
  EXPECT_NEAR(s.energy.peakPeriod(), known[0].spectrum.energy.peakPeriod(), 0.03);
  EXPECT_NEAR(compassFromFromToward(s.moments[300].meanDirection()), 350.0, 0.01);
  EXPECT_FALSE(s.moments[300].hasSecond());
  ASSERT_EQ(records[0].notes.size(), 2u);
  EXPECT_NE(records[0].notes[0].find("bulk parameters only"), std::string::npos);
}

TEST(ReadSpectra, TheFormatGivenOverridesTheContent) {
  const auto written = test::triaxysLineFile(test::knownRecords(bins, directions)[0]);
  EXPECT_EQ(parseSpectra(written.files, "triaxys").size(), 1u);
  for (const SpectrumFormatName& other : spectrumFormats()) {
    if (other.name == "triaxys") continue;
    EXPECT_THROW(parseSpectra(written.files, other.name), InputError) << other.name;
  }
  try {
    parseSpectra(written.files, "grib");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "--format: 'grib' is not allowed; must be one of: swan, ww3, triaxys, spotter, "
                 "ndbc, ndbc-yearly, datawell");
  }
}

TEST(ReadSpectra, FilesOfOneRecordAreReadOneAfterTheOther) {
  const auto known = test::knownRecords(bins, directions);
  auto files = test::triaxysFile(known[1]).files;
  files.push_back(test::triaxysFile(known[0]).files[0]);
  const auto records = parseSpectra(files);
  ASSERT_EQ(records.size(), 2u);
  EXPECT_EQ(records[0].time, known[1].time);
  EXPECT_EQ(recordAt(records, known[0].time).time, known[0].time);
}

TEST(ReadSpectra, FilesOfTwoFormatsAreRefused) {
  const auto known = test::knownRecords(bins, directions);
  auto files = test::triaxysFile(known[0]).files;
  files.push_back(test::swanFile(known).files[0]);
  EXPECT_THROW(parseSpectra(files), InputError);
}

class SpectraOnDisk : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  void write(const std::vector<TextFile>& files) {
    for (const TextFile& file : files) std::ofstream(folder_ / file.name) << file.text;
  }
  const fs::path folder_ =
      fs::temp_directory_path() / ("seaway_spectra_" + std::to_string(getpid()));
};

TEST_F(SpectraOnDisk, NdbcFilesAreFoundByTheirNames) {
  const auto known = test::knownRecords(bins, directions);
  write(test::ndbcRealtimeFiles(known).files);
  write(test::ndbcYearlyFiles(known).files);
  for (const char* name : {"b.data_spec", "41010w2020.txt"}) {
    const auto paths = withCompanions(folder_ / name);
    EXPECT_EQ(paths.size(), 5u) << name;
    EXPECT_TRUE(readSpectra(paths)[0].spectrum.moments.at(20).hasSecond());
    EXPECT_TRUE(readSpectra(folder_ / name)[0].spectrum.moments.empty());
  }
  EXPECT_EQ(withCompanions(folder_ / "b.swdir").size(), 1u);
  EXPECT_EQ(withCompanions("41010w2019.txt").size(), 1u);
}

TEST_F(SpectraOnDisk, WhatIsNoReadableFileIsRefusedByName) {
  EXPECT_THROW(readSpectra(folder_ / "absent"), InputError);
  EXPECT_THROW(readSpectra(folder_), InputError);
  EXPECT_THROW(readSpectra("/dev/zero"), InputError);
  write({{"empty.txt", " \n"}, {"other.txt", "time,height\n0,1\n"}});
  const auto messageOf = [&](const char* name) {
    try {
      readSpectra(folder_ / name);
    } catch (const InputError& error) {
      return std::string(error.what()).substr(folder_.string().size() + 1);
    }
    return std::string("none");
  };
  EXPECT_EQ(messageOf("absent"), "absent: cannot be read");
  EXPECT_EQ(messageOf("empty.txt"), "empty.txt: holds no spectrum: it is empty");
  EXPECT_EQ(messageOf("other.txt"),
            "other.txt: is of no format known; give --format, one of: swan, ww3, triaxys, spotter, "
            "ndbc, ndbc-yearly, datawell");
}

}  // namespace
}  // namespace seaway
