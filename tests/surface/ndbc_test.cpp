#include "surface/spectra/ndbc.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "surface/input_error.h"
#include "surface/spectra/families.h"

namespace seaway {
namespace {

namespace fs = std::filesystem;

class NdbcTest : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path write(const std::string& text) {
    const fs::path path = folder_ / "test.data_spec";
    std::ofstream(path) << text;
    return path;
  }
  std::string messageOf(const std::string& text) {
    try {
      readNdbcSpectralDensity(write(text));
    } catch (const InputError& error) {
      return std::string(error.what()).substr(folder_.string().size() + 1);
    }
    return "no error";
  }

  const fs::path folder_ = fs::temp_directory_path() / ("seaway_ndbc_" + std::to_string(getpid()));
  const std::string header_ = "#YY  MM DD hh mm Sep_Freq  < spec_1 (freq_1) ... >\n";
};

/// One line in NDBC's format from a known spectrum, on the buoys' own 46 frequencies.
std::string recordLine(const std::string& date, const FrequencySpectrum& spectrum) {
  std::ostringstream line;
  line << date << " 9.999";
  line << std::fixed << std::setprecision(3);
  for (int i = 0; i < 46; ++i) {
    const double f = i < 13 ? 0.033 + 0.005 * i : i < 40 ? 0.100 + 0.010 * (i - 13) : 0.365 + 0.02 * (i - 39);
    line << ' ' << spectrum.at(f) << " (" << f << ')';
  }
  return line.str() + '\n';
}

TEST_F(NdbcTest, AKnownSpectrumComesBack) {
  const FrequencySpectrum truth = jonswap({2.0, 9.0, 2.0});
  const auto records = readNdbcSpectralDensity(
      write(header_ + recordLine("2020 06 08 03 50", truth) + recordLine("2020 06 08 02 50", truth)));
  ASSERT_EQ(records.size(), 2u);
  EXPECT_EQ(records[0].time, "2020-06-08T03:50Z");
  EXPECT_FALSE(records[0].separationFrequency);
  ASSERT_EQ(records[0].spectrum.frequency.size(), 46u);
  // Three decimals and the tail beyond 0.485 Hz are lost.
  EXPECT_NEAR(records[0].spectrum.significantWaveHeight(), 2.0, 0.02);
  EXPECT_NEAR(records[0].spectrum.peakPeriod(), 9.0, 0.2);
}

TEST_F(NdbcTest, MissingBinsAreCountedAndLeftOut) {
  const auto records = readNdbcSpectralDensity(
      write("2020 06 08 03 50 0.225 1.0 (0.10) 999.0 (0.11) 2.0 (0.12) 1.0 (0.13)\n"));
  EXPECT_EQ(records[0].missingBins, 1u);
  EXPECT_EQ(records[0].spectrum.frequency, (std::vector<double>{0.10, 0.12, 0.13}));
  EXPECT_DOUBLE_EQ(*records[0].separationFrequency, 0.225);
}

TEST_F(NdbcTest, RecordsAreFoundByTime) {
  const FrequencySpectrum truth = jonswap({2.0, 9.0, 2.0});
  const auto records = readNdbcSpectralDensity(
      write(recordLine("2020 06 08 03 50", truth) + recordLine("2020 06 08 02 50", truth)));
  EXPECT_EQ(recordAt(records, "2020-06-08T02:40").time, "2020-06-08T02:50Z");
  EXPECT_THROW(recordAt(records, "2020-06-09T02:40"), InputError);
  EXPECT_THROW(recordAt(records, "yesterday"), InputError);
}

class NdbcHard : public NdbcTest {};

TEST_F(NdbcHard, EveryFaultNamesFileAndLine) {
  EXPECT_EQ(messageOf(header_), "test.data_spec: holds no spectrum");
  EXPECT_EQ(messageOf("2020 13 08 03 50 0.2 1 (0.1) 1 (0.2)\n"), "test.data_spec:1: not a date and time");
  EXPECT_EQ(messageOf(header_ + "2020 06 08 03 50 0.2 x (0.1) 1 (0.2)\n"),
            "test.data_spec:2: 'x' is not a number");
  EXPECT_EQ(messageOf("2020 06 08 03 50 0.2 1 (0.1) 1 0.2\n"),
            "test.data_spec:1: '0.2' is not a frequency in parentheses");
  EXPECT_EQ(messageOf("2020 06 08 03 50 0.2 1 (0.2) 1 (0.1)\n"),
            "test.data_spec:1: frequency 0.1 Hz does not rise above 0.2");
  EXPECT_NE(messageOf("2020 06 08 03 50 0.2 -1 (0.1) 1 (0.2)\n").find("density -1"), std::string::npos);
  EXPECT_NE(messageOf("2020 06 08 03 50 0.2 nan (0.1) 1 (0.2)\n").find("'nan' is not a number"), std::string::npos);
  EXPECT_THROW(readNdbcSpectralDensity(folder_ / "absent"), InputError);
  EXPECT_THROW(readNdbcSpectralDensity(folder_), InputError);
}

TEST_F(NdbcHard, AFileCutAtAnyByteIsReadOrRefusedButNeverCrashes) {
  const std::string whole = header_ + recordLine("2020 06 08 03 50", jonswap({2.0, 9.0, 2.0}));
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const fs::path path = write(whole.substr(0, length));
    try {
      for (const auto& record : readNdbcSpectralDensity(path)) EXPECT_FALSE(record.spectrum.validate());
    } catch (const InputError&) {
    }
  }
}

/// WVHT by hour (YYYY-MM-DDThh) from the station's own summary.
std::map<std::string, double> summaryHeights(const fs::path& path) {
  std::map<std::string, double> heights;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream words(line);
    std::string year, month, day, hour, minute;
    double height;
    if (words >> year >> month >> day >> hour >> minute >> height) heights[year + '-' + month + '-' + day + 'T' + hour] = height;
  }
  return heights;
}

TEST_F(NdbcTest, BuoyWaveHeightsAgreeWithTheStationsOwnSummary) {
  const fs::path data = fs::path(SEAWAY_SHARED_DIR) / "data/ndbc";
  if (!fs::exists(data)) GTEST_SKIP() << "no buoy data at " << data;
  const auto summary = summaryHeights(data / "41010.spec");
  const auto records = readNdbcSpectralDensity(data / "41010.data_spec");
  EXPECT_EQ(records.size(), 149u);
  std::size_t compared = 0;
  for (const SpectrumRecord& record : records) {
    const auto found = summary.find(record.time.substr(0, 13));
    if (found == summary.end()) continue;
    ++compared;
    // The summary rounds to 0.1 m; the rest is its other integration rule.
    EXPECT_NEAR(record.spectrum.significantWaveHeight(), found->second, 0.12) << record.time;
  }
  EXPECT_GE(compared, 140u);
}

}  // namespace
}  // namespace seaway
