#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "surface/angles.h"
#include "surface/input_error.h"
#include "surface/spectra/readers/read_spectra.h"

namespace seaway {
namespace {

namespace fs = std::filesystem;

const std::string header = "#YY  MM DD hh mm Sep_Freq  < spec_1 (freq_1) ... >\n";
const std::string densityLine = "2020 06 08 03 50 0.225 1.0 (0.10) 2.0 (0.11) 1.0 (0.12)\n";

std::string messageOf(const std::vector<TextFile>& files) {
  try {
    parseSpectra(files);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string messageOf(const std::string& text) {
  return messageOf(std::vector<TextFile>{{"test.data_spec", text}});
}

TextFile file(const std::string& extension, const std::string& line) {
  return {"test." + extension, line};
}

TEST(NdbcRealtime, MissingBinsAreCountedAndLeftOut) {
  const auto records = parseSpectra({file(
      "data_spec", "2020 06 08 03 50 0.225 1.0 (0.10) 999.0 (0.11) 2.0 (0.12) 1.0 (0.13)\n")});
  EXPECT_EQ(records[0].missingBins, 1u);
  EXPECT_EQ(records[0].spectrum.energy.frequency, (std::vector<double>{0.10, 0.12, 0.13}));
  EXPECT_DOUBLE_EQ(records[0].separationFrequency.value(), 0.225);
}

TEST(NdbcRealtime, MissingDirectionsAreUnknownNotZero) {
  const auto records =
      parseSpectra({file("data_spec", densityLine),
                    file("swdir", "2020 06 08 03 50 180.0 (0.10) 999.0 (0.11) 270.0 (0.12)\n"),
                    file("swr1", "2020 06 08 03 50 0.50 (0.10) 999.00 (0.11) 0.80 (0.12)\n")});
  const auto& moments = records[0].spectrum.moments;
  ASSERT_EQ(moments.size(), 3u);
  EXPECT_NEAR(moments[0].b1, 0.5, 1e-12);  // from the south: north
  EXPECT_FALSE(moments[1].hasFirst());
  EXPECT_NEAR(moments[2].a1, 0.8, 1e-12);
  EXPECT_FALSE(moments[0].hasSecond());
}

TEST(NdbcRealtime, AnySubsetIsMatchedByTheTimeOfTheRecord) {
  const std::string two = densityLine + "2020 06 08 02 50 9.999 1.0 (0.10) 2.0 (0.11) 1.0 (0.12)\n";
  const auto records =
      parseSpectra({file("swr1", "2020 06 08 02 50 0.50 (0.10) 0.60 (0.11) 0.80 (0.12)\n"),
                    file("swdir", "2020 06 08 02 50 180.0 (0.10) 180.0 (0.11) 270.0 (0.12)\n"),
                    file("data_spec", two)});
  ASSERT_EQ(records.size(), 2u);
  EXPECT_TRUE(records[0].spectrum.moments.empty());
  EXPECT_EQ(records[0].notes, (std::vector<std::string>{"alpha1 is not given at this time",
                                                        "r1 is not given at this time"}));
  EXPECT_EQ(records[1].spectrum.moments.size(), 3u);
  EXPECT_FALSE(records[1].separationFrequency);
}

TEST(NdbcRealtime, AMeanDirectionWithoutItsR1IsNotUsedAndSaysSo) {
  const auto records =
      parseSpectra({file("data_spec", densityLine),
                    file("swdir", "2020 06 08 03 50 180.0 (0.10) 180.0 (0.11) 270.0 (0.12)\n")});
  EXPECT_TRUE(records[0].spectrum.moments.empty());
  ASSERT_EQ(records[0].notes.size(), 1u);
  EXPECT_EQ(records[0].notes[0], "alpha1 without r1: not used, a direction needs both");
}

TEST(NdbcRealtimeHard, EveryFaultNamesFileAndLine) {
  const auto at = [](const std::string& rest) { return "test.data_spec:" + rest; };
  EXPECT_EQ(messageOf(header), "test.data_spec: holds no spectrum");
  EXPECT_EQ(messageOf("2020 13 08 03 50 0.2 1 (0.1) 1 (0.2)\n"), at("1: not a date and time"));
  EXPECT_EQ(messageOf(header + "2020 06 08 03 50 0.2 x (0.1) 1 (0.2)\n"),
            at("2: density at 0.1 Hz: 'x' is not a number"));
  EXPECT_EQ(messageOf(header + "2020 06 08 03 50 0.2 nan (0.1) 1 (0.2)\n"),
            at("2: density at 0.1 Hz: 'nan' is not a number"));
  EXPECT_EQ(messageOf(header + "2020 06 08 03 50 0.2 1 (0.1) 1 0.2\n"),
            at("2: '0.2' is not a frequency in parentheses"));
  EXPECT_EQ(messageOf("2020 06 08 03 50 0.2 1 (0.2) 1 (0.1)\n"),
            at("1: frequency 0.100000 Hz does not rise above 0.200000"));
  EXPECT_EQ(messageOf("2020 06 08 03 50 0.2 1 (0.1) 1 (0.1)\n"),
            at("1: frequency 0.100000 Hz does not rise above 0.100000"));
  EXPECT_EQ(
      messageOf("2020 06 08 03 50 0.2 -1 (0.1) 1 (0.2)\n"),
      at("1: density at 0.1 Hz: -1 is not allowed; must be >= 0 m2/Hz, or 999 where missing"));
  EXPECT_EQ(messageOf(densityLine + "2020 06 08 02 50 9.999 1.0 (0.10) 2.0 (0.11)\n"),
            at("2: has 2 frequencies where the first record has 3"));
  EXPECT_EQ(messageOf(densityLine.substr(0, densityLine.size() - 12)),
            at("1: its first record's line has no end: the file is cut short"));
}

TEST(NdbcRealtimeHard, FaultsOfDirectionalFilesNameThem) {
  const auto with = [](const TextFile& other) {
    return messageOf(std::vector<TextFile>{file("data_spec", densityLine), other});
  };
  EXPECT_EQ(
      with(file("swr1", "2020 06 08 03 50 0.5 (0.10) 1.2 (0.11) 0.8 (0.12)\n")),
      "test.swr1:1: r1 at 0.11 Hz: 1.2 is not allowed; must be in [0, 1], or 999 where missing");
  EXPECT_EQ(with(file("swdir", "2020 06 08 03 50 361 (0.10) 0 (0.11) 0 (0.12)\n")),
            "test.swdir:1: alpha1 at 0.1 Hz: 361 is not allowed; must be in [0, 360], or 999 where "
            "missing");
  EXPECT_EQ(
      with(file("swr1", "2020 06 08 03 50 0.5 (0.10) 0.2 (0.13) 0.8 (0.14)\n")),
      "test.swr1:1: its frequencies are not those of test.data_spec:1, the density of the same "
      "time");
  EXPECT_EQ(with(file("data_spec", densityLine)),
            "test.data_spec: holds density as test.data_spec does; one file of each is allowed");
  EXPECT_EQ(messageOf({file("swr1", "2020 06 08 03 50 0.5 (0.10) 0.2 (0.13) 0.8 (0.14)\n")}),
            "test.swr1: holds r1; the file of spectral density is needed with it");
}

TEST(NdbcRealtimeHard, ARecordWithEveryBinMissingHasNoSpectrum) {
  const auto records =
      parseSpectra({file("data_spec", "2020 06 08 03 50 9.999 999.0 (0.10) 999.0 (0.11)\n")});
  EXPECT_FALSE(records[0].hasSpectrum());
  EXPECT_EQ(records[0].missingBins, 2u);
}

const std::string yearly = "#YY  MM DD hh mm  .0200  .0325  .0375\n";

TEST(NdbcYearly, OldHeadersWithoutMinutesAndWithShortYearsAreRead) {
  const auto records =
      parseSpectra({{"41010w1996.txt",
                     "YY MM DD hh  .03  .04\n96 01 31 23  0.10  0.20\n96 02 01 00 0.1 999.00\n"}});
  ASSERT_EQ(records.size(), 2u);
  EXPECT_EQ(records[0].time, "1996-01-31T23:00Z");
  EXPECT_EQ(records[0].spectrum.energy.density, (std::vector<double>{0.10, 0.20}));
  EXPECT_FALSE(records[1].hasSpectrum());
  EXPECT_EQ(records[1].missingBins, 1u);
}

TEST(NdbcYearly, RIsInHundredthsUnlessTheFileHasNoneAbove1) {
  const TextFile density{"41010w2019.txt", yearly + "2019 01 31 23 40 0.1 0.2 0.3\n"};
  const TextFile alpha{"41010d2019.txt", yearly + "2019 01 31 23 40 270 270 999\n"};
  const auto read = [&](const std::string& values) {
    return parseSpectra(
        {density, alpha, {"41010j2019.txt", yearly + "2019 01 31 23 40 " + values}})[0];
  };
  EXPECT_NEAR(read("80.0 1.0 999.0\n").spectrum.moments[0].a1, 0.8, 1e-12);
  EXPECT_NEAR(read("80.0 1.0 999.0\n").spectrum.moments[1].a1, 0.01, 1e-12);
  const SpectrumRecord scaled = read("0.80 0.01 999.0\n");
  EXPECT_NEAR(scaled.spectrum.moments[0].a1, 0.8, 1e-12);
  ASSERT_EQ(scaled.notes.size(), 1u);
  EXPECT_NE(scaled.notes[0].find("not as hundredths"), std::string::npos);
}

TEST(NdbcYearlyHard, EveryFaultNamesFileAndLine) {
  const auto of = [](const std::string& text) {
    return messageOf(std::vector<TextFile>{{"41010w2019.txt", text}});
  };
  EXPECT_EQ(of(yearly), "41010w2019.txt: holds no spectrum");
  EXPECT_EQ(of(yearly + "2019 01 31 23 40 0.1 0.2\n"),
            "41010w2019.txt:2: has 7 columns where its header has 8");
  EXPECT_EQ(of("#YY MM DD hh mm .03 .02\n2019 01 31 23 40 0.1 0.2\n"),
            "41010w2019.txt:1: frequency 0.020000 Hz does not rise above 0.030000");
  EXPECT_EQ(of(yearly + "2019 01 31 23 40 0.1 0.2 -3\n"),
            "41010w2019.txt:2: density at 0.0375 Hz: -3 is not allowed; must be >= 0 m2/Hz, or 999 "
            "where missing");
  EXPECT_EQ(
      messageOf(std::vector<TextFile>{{"41010d2019.txt", yearly + "2019 01 31 23 40 1 2 3\n"}}),
      "41010d2019.txt: holds alpha1; the file of spectral density is needed with it");
}

/// WVHT, APD and MWD of the station's own summary, by hour (YYYY-MM-DDThh).
struct Summary {
  double height, period, from_deg;
};

std::map<std::string, Summary> summaries(const fs::path& path) {
  std::map<std::string, Summary> found;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream stream(line);
    std::vector<std::string> words(std::istream_iterator<std::string>(stream), {});
    if (words.size() < 15 || words[0].starts_with('#')) continue;
    const auto number = [&](std::size_t i) {
      return words[i] == "MM" ? std::nan("") : std::stod(words[i]);
    };
    found[words[0] + '-' + words[1] + '-' + words[2] + 'T' + words[3]] = {number(5), number(13),
                                                                          number(14)};
  }
  return found;
}

TEST(NdbcRealtime, BuoyRecordsAgreeWithTheStationsOwnSummary) {
  const fs::path data = fs::path(SEAWAY_SHARED_DIR) / "data/ndbc";
  if (!fs::exists(data)) GTEST_SKIP() << "no buoy data at " << data;
  const auto summary = summaries(data / "41010.spec");
  const auto records = readSpectra(withCompanions(data / "41010.data_spec"));
  EXPECT_EQ(records.size(), 149u);
  std::size_t compared = 0;
  double worst[3] = {};
  for (const SpectrumRecord& record : records) {
    const auto found = summary.find(record.time.substr(0, 13));
    if (found == summary.end()) continue;
    ++compared;
    const FrequencySpectrum& energy = record.spectrum.energy;
    const auto peak = static_cast<std::size_t>(
        std::max_element(energy.density.begin(), energy.density.end()) - energy.density.begin());
    const double from_deg = compassFromFromToward(record.spectrum.moments.at(peak).meanDirection());
    const double off[3] = {energy.significantWaveHeight() - found->second.height,
                           energy.zeroCrossingPeriod() - found->second.period,
                           std::remainder(from_deg - found->second.from_deg, 360.0)};
    for (int i = 0; i < 3; ++i) worst[i] = std::fmax(worst[i], std::abs(off[i]));
    // The summary rounds to 0.1 m, 0.1 s and 1 deg, and integrates by sums over its bands.
    EXPECT_LE(std::abs(off[0]), 0.12) << record.time;
    EXPECT_LE(std::abs(off[1]), 0.45) << record.time;
    EXPECT_LE(std::abs(off[2]), 3.0) << record.time;
  }
  EXPECT_GE(compared, 140u);
  RecordProperty("compared", static_cast<int>(compared));
  std::printf("compared %zu; worst H_m0 %.3f m, T_m02 %.3f s, direction %.2f deg\n", compared,
              worst[0], worst[1], worst[2]);
}

}  // namespace
}  // namespace seaway
