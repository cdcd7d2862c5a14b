#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "surface/angles.h"
#include "surface/input_error.h"
#include "surface/spectra/readers/read_spectra.h"
#include "tests/surface/readers/spectrum_writers.h"

/// What Datawell, TRIAXYS and Spotter files may hold beyond the plain case.
namespace seaway {
namespace {

std::string messageOf(const TextFile& file) {
  try {
    parseSpectra({file});
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TextFile replaced(TextFile file, const std::string& from, const std::string& to) {
  const std::size_t at = file.text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  file.text.replace(at, from.size(), to);
  return file;
}

TextFile datawell() { return test::everyFormat(4, 8)[5].files[0]; }
TextFile triaxys() { return test::triaxysFile(test::knownRecords(4, 8)[0]).files[0]; }

TEST(Datawell, TimeComesFromTheFilesName) {
  EXPECT_EQ(parseSpectra({datawell()})[0].time, "2020-06-08T03:50Z");
  TextFile nameless = datawell();
  nameless.name = "latest.spt";
  const auto records = parseSpectra({nameless});
  EXPECT_EQ(records[0].time, "");
  EXPECT_EQ(records[0].notes[0], "the file's name gives no time");
}

TEST(Datawell, NormalDistributionHasItsSecondMoment) {
  // Narrow and normal: skewness 0, kurtosis 3, so m₂ = exp(−2σ²) to the order of σ⁴.
  TextFile file{"a.spt", "1\n100\n5\n1\n0\n0\n0\n0\n0\n0\n0\n0\n"};
  for (const double f : test::datawellFrequencies()) {
    file.text += std::to_string(f) + ",0.5,180.0,10.0,0.0,3.0\n";
  }
  const double sigma = radiansFromDegrees(10.0);
  const DirectionalMoments m = parseSpectra({file})[0].spectrum.moments[5];
  EXPECT_NEAR(m.b1, 1.0 - 0.5 * sigma * sigma, 1e-12);
  EXPECT_NEAR(m.a2, -std::exp(-2.0 * sigma * sigma), 2.0 * std::pow(sigma, 4.0));
  EXPECT_NEAR(m.b2, 0.0, 1e-12);
}

TEST(Datawell, SecondMomentsThatNoDistributionHasAreLeftOutAndCounted) {
  TextFile file{"a.spt", "1\n100\n5\n1\n0\n0\n0\n0\n0\n0\n0\n0\n"};
  for (const double f : test::datawellFrequencies()) {
    file.text += std::to_string(f) + ",0.5,180.0,60.0,0.0,9.0\n";
  }
  const SpectrumRecord record = parseSpectra({file})[0];
  EXPECT_TRUE(record.spectrum.moments[5].hasFirst());
  EXPECT_FALSE(record.spectrum.moments[5].hasSecond());
  bool counted = false;
  for (const std::string& note : record.notes) counted |= note.rfind("64 frequencies:", 0) == 0;
  EXPECT_TRUE(counted);
}

TEST(DatawellHard, EveryFaultNamesFileAndLine) {
  const TextFile whole = datawell();
  const std::string at = whole.name + ":";
  EXPECT_EQ(messageOf(replaced(whole, "\n0.0300,", "\n0.0250,")),
            at + "76: frequency 0.025000 Hz does not rise above 0.025000");
  TextFile cut = whole;
  cut.text.resize(cut.text.rfind('\n', cut.text.size() - 2) + 1);
  EXPECT_EQ(messageOf(cut), at + "75: ends before 64 lines of frequencies");
  TextFile more = whole;
  more.text += "0.6,0,0,0,0,0\n";
  EXPECT_EQ(messageOf(more), at + "76: more than 64 frequencies are not allowed");
}

TEST(Triaxys, TheZeroFrequencyAndTheDoubledDirectionAreLeftOut) {
  const auto record = parseSpectra({triaxys()})[0];
  EXPECT_EQ(record.spectrum.energy.frequency.size(), 4u);
  EXPECT_EQ(record.spectrum.direction.size(), 8u);
}

TEST(Triaxys, OtherDatesOfTheSameMomentAreRead) {
  const TextFile plain = triaxys();
  for (const char* date :
       {"2020 Jun 8 03:50(UTC)", "2020-06-08 03:50:00(UTC)", "2020 jun 08 03:50"}) {
    const auto record = parseSpectra({replaced(plain, "2020 JUN 08 03:50(UTC)", date)})[0];
    EXPECT_EQ(record.time, "2020-06-08T03:50Z") << date;
  }
}

TEST(TriaxysHard, EveryFaultNamesFileAndLine) {
  const TextFile whole = triaxys();
  EXPECT_EQ(
      messageOf(replaced(whole, "= DIRECTIONAL", "= WAVE")),
      "known.dirspec:12: TYPE 'WAVE SPECTRUM' is not allowed; must be DIRECTIONAL SPECTRUM or "
      "NON-DIRECTIONAL SPECTRUM");
  EXPECT_EQ(messageOf(replaced(whole, "(UTC)", "(AEST)")),
            "known.dirspec:12: time zone '(AEST)' is not allowed; must be (UTC)");
  EXPECT_EQ(messageOf(replaced(whole, "DATE ", "DAY ")),
            "known.dirspec:12: its header lacks 'DATE'");
  EXPECT_EQ(messageOf(replaced(whole, "=       9", "=      10")),
            "known.dirspec:12: NUMBER OF DIRECTIONS and DIRECTION SPACING must make 0 to 360 deg");
  EXPECT_EQ(messageOf(replaced(whole, "=       5", "=       4")),
            "known.dirspec:16: more follows than NUMBER OF FREQUENCIES says");
}

TextFile spotter(const std::string& member) { return {"s.json", "{\"data\":{" + member + "}}\n"}; }

const std::string place =
    "\"timestamp\":\"2018-02-14T00:27:19.000Z\",\"latitude\":-61,\"longitude\":173";

TEST(Spotter, DirectionAndSpreadServeWhereMomentsAreNotGiven) {
  const auto record =
      parseSpectra({spotter("\"frequencyData\":[{\"frequency\":[0.1,0.2],\"varianceDensity\":[1,2],"
                            "\"direction\":[180,270],"
                            "\"directionalSpread\":[30,30]," +
                            place + "}]")})[0];
  EXPECT_EQ(record.time, "2018-02-14T00:27:19Z");
  EXPECT_NEAR(compassFromFromToward(record.spectrum.moments[0].meanDirection()), 180.0, 1e-9);
  EXPECT_NEAR(degreesFromRadians(record.spectrum.moments[1].spread()), 30.0, 1e-9);
}

TEST(SpotterHard, EveryFaultNamesFileAndKey) {
  EXPECT_EQ(messageOf(spotter("\"waves\":[{\"significantWaveHeight\":1," + place + "}]")),
            "s.json: key 'data.waves[0]': lacks 'peakPeriod'");
  EXPECT_EQ(
      messageOf(
          spotter("\"waves\":[{\"significantWaveHeight\":-1,\"peakPeriod\":8," + place + "}]")),
      "s.json: key 'data.waves[0].significantWaveHeight': -1 is not allowed; must be in [0, 100] "
      "m");
  EXPECT_EQ(messageOf(spotter("\"waves\":7")), "s.json: key 'data.waves': must be a list");
  EXPECT_EQ(messageOf(spotter("\"waves\":[]")),
            "s.json: key 'data': lacks records in 'frequencyData' or 'waves'");
  EXPECT_EQ(
      messageOf(spotter("\"frequencyData\":[{\"frequency\":[0.1,0.2],\"varianceDensity\":[1]," +
                        place + "}]")),
      "s.json: key 'data.frequencyData[0].varianceDensity': has 1 values for 2 frequencies");
  EXPECT_EQ(
      messageOf(spotter("\"frequencyData\":[{\"frequency\":[0.1,0.2],\"varianceDensity\":[1,2],"
                        "\"a1\":[1.2,0],\"b1\":[0,0]," +
                        place + "}]")),
      "s.json: key 'data.frequencyData[0]': directional moment above 1 at 0.1 Hz");
  EXPECT_EQ(messageOf({"s.json", "{\"data\":"}).rfind("s.json: is not JSON:", 0), 0u);
}

TEST(Spotter, TheBuoysSpectraHaveTheWaveHeightsThatItReports) {
  const auto path = std::filesystem::path(SEAWAY_SHARED_DIR) / "data/spotter/spotter_20180214.json";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no Spotter file at " << path;
  const auto records = readSpectra(path);
  ASSERT_EQ(records.size(), 8u);
  // significantWaveHeight and peakDirection of the same file's bulk parameters.
  constexpr double heights[] = {1.62, 1.67, 1.60, 2.43, 2.39, 2.20, 2.28, 2.32};
  constexpr double directions[] = {299.98, 22.83, 16.32, 309.21, 303.86, 314.49, 312.41, 310.69};
  for (std::size_t i = 0; i < records.size(); ++i) {
    const DirectionalSpectrum& s = records[i].spectrum;
    // Its last band is 0.28 Hz wide, which it counts whole: the trapezoid gives a little less.
    EXPECT_NEAR(s.energy.significantWaveHeight(), heights[i], 0.06) << i;
    std::size_t peak = 0;
    for (std::size_t b = 0; b < s.energy.density.size(); ++b) {
      if (s.energy.density[b] > s.energy.density[peak]) peak = b;
    }
    EXPECT_NEAR(compassFromFromToward(s.moments[peak].meanDirection()), directions[i], 0.01) << i;
  }
}

}  // namespace
}  // namespace seaway
