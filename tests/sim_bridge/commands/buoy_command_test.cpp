#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "sim_bridge/commands/buoy.h"
#include "sim_bridge/scene/scene_loader.h"
#include "surface/angles.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

using test::TempFolder;
using test::writeScene;

constexpr const char* canaveral = SEAWAY_SOURCE_DIR "/configs/scenes/canaveral.yaml";

nlohmann::json read(BuoyOptions options) {
  options.json = true;
  std::ostringstream out;
  EXPECT_EQ(runBuoy(options, out), 0);
  return nlohmann::json::parse(out.str());
}

BuoyOptions shortRecord(const std::string& scene) {
  BuoyOptions options;
  options.scene = scene;
  options.at = "28.878,-78.467";
  options.hours = 0.25;
  return options;
}

// A scene whose only wave is regular: 0.5 m of amplitude, 0.15625 Hz (40 bins of 256 s), from 300°.
std::string regularWaveScene(const TempFolder& folder, const std::string& latitude_deg = "28.878") {
  const std::pair<std::string, std::string> latitude{"latitude_deg: 28.878",
                                                     "latitude_deg: " + latitude_deg};
  return writeScene(folder,
                    {latitude,  // of the anchor, then of the vessel
                     latitude,
                     {"    jonswap:\n      hm0_m: 1.12\n      tp_s: 5.6\n      from_deg: 196",
                      "    octaves:\n      - {kind: regular, standard_deviation_m: "
                      "0.35355339059327373, frequency_hz: 0.15625, toward_deg: 120}"}})
      .string();
}

TEST(BuoyCommand, ReadsTheCanaveralSeaBackFromThreeHours) {
  BuoyOptions options;
  options.scene = canaveral;
  options.at = "28.878,-78.467";
  const auto sea = read(options);
  // Three standard errors of H_m0: 1.4 % each for 3 h at T_p 5.6 s.
  EXPECT_NEAR(sea["hm0_m"].get<double>(), 1.12, 3.0 * 0.014 * 1.12);
  EXPECT_NEAR(sea["hm0_standard_error_m"].get<double>(), 0.014 * 1.12, 0.002);
  EXPECT_NEAR(1.0 / sea["tp_s"].get<double>(), 1.0 / 5.6, 1.0 / 256.0);  // one bin
  // The octaves have the moments asked for at every frequency (octave_directions_test.cpp). What is
  // left is the record's own scatter: at the peak, one bin of some 90 degrees of freedom,
  // √((1 − r₂)/2)/(r₁ √90) = 2.7° (Kuik et al. 1988); twice that, and a third of it over all bins.
  const double r1 = 10.0 / 11.0;  // s/(s + 1)
  const double spread_deg = degreesFromRadians(std::sqrt(2.0 * (1.0 - r1)));
  EXPECT_NEAR(sea["mean_direction_from_deg"].get<double>(), 196.0, 2.0);
  EXPECT_NEAR(sea["peak_direction_from_deg"].get<double>(), 196.0, 5.0);
  EXPECT_NEAR(sea["spread_deg"].get<double>(), spread_deg, 4.0);
  EXPECT_NEAR(sea["peak_spread_deg"].get<double>(), spread_deg, 4.0);
  // Some 2500 independent heights: √(24/2500) = 0.1 for kurtosis, √(6/2500) = 0.05 for skewness.
  EXPECT_NEAR(sea["kurtosis"].get<double>(), 3.0, 0.15);
  EXPECT_NEAR(sea["skewness"].get<double>(), 0.0, 0.15);
  EXPECT_EQ(sea["samples"], 21600);
  EXPECT_EQ(sea["segment_s"], 256.0);
  EXPECT_EQ(sea["segments"], 83);
}

TEST(BuoyCommand, ReadsARegularWaveInCompassDegrees) {
  const TempFolder folder;
  const auto sea = read(shortRecord(regularWaveScene(folder)));
  EXPECT_NEAR(sea["hm0_m"].get<double>(), 4.0 * 0.5 / std::sqrt(2.0), 1e-5);  // float samples
  EXPECT_NEAR(sea["tp_s"].get<double>(), 6.4, 1e-4);
  EXPECT_NEAR(sea["mean_direction_from_deg"].get<double>(), 300.0, 0.01);
  EXPECT_NEAR(sea["peak_direction_from_deg"].get<double>(), 300.0, 0.01);
  EXPECT_NEAR(sea["peak_spread_deg"].get<double>(), 0.0, 0.1);  // √ of float rounding
}

TEST(BuoyCommand, DirectionsAreTrueWhereTheBuoyLies) {
  const TempFolder folder;
  BuoyOptions options = shortRecord(regularWaveScene(folder, "60"));
  options.at = "60,-75.78";  // 150 km east of the anchor
  const Sea sea = buildSea(loadScene(options.scene));
  const SeaPlanePoint place = sea.geodesy.seaPlaneFromGeodetic(60.0, -75.78);
  const double convergence_deg = degreesFromRadians(place.convergence);
  ASSERT_GT(std::abs(convergence_deg), 2.0);
  // A direction fixed in the plane reads `convergence` more on the compass: its north lies that
  // far counter-clockwise.
  EXPECT_NEAR(read(options)["mean_direction_from_deg"].get<double>(), 300.0 + convergence_deg,
              0.01);
}

TEST(BuoyCommand, TheSpectrumIsOneArrayAColumn) {
  const TempFolder folder;
  BuoyOptions options = shortRecord(writeScene(folder).string());
  options.segment = 64.0;
  const auto sea = read(options);
  const auto& spectrum = sea["spectrum"];
  for (const char* key :
       {"frequency_hz", "density_m2_hz", "direction_from_deg", "spread_deg", "wave_number_rad_m"}) {
    EXPECT_EQ(spectrum[key].size(), 64u) << key;
  }
  EXPECT_EQ(spectrum["frequency_hz"][0], 1.0 / 64.0);
  EXPECT_EQ(spectrum["frequency_hz"][63], 1.0);
  double m0 = 0.0;
  for (const double density : spectrum["density_m2_hz"]) m0 += density / 64.0;
  EXPECT_NEAR(4.0 * std::sqrt(m0), sea["hm0_m"].get<double>(), 1e-12);
}

TEST(BuoyCommand, WritesTheRecordThatItRead) {
  const TempFolder folder;
  BuoyOptions options = shortRecord(writeScene(folder).string());
  options.hours = 0.1;
  options.rate = 4.0;
  options.segment = 60.0;
  options.out = (folder / "record.csv").string();
  read(options);
  std::istringstream lines(test::readFile(options.out));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "time_s,height_m,slope_x,slope_y");
  const Sea sea = buildSea(loadScene(options.scene));
  int rows = 0;
  for (; std::getline(lines, line); ++rows) {
    std::istringstream cells(line);
    std::vector<double> values;
    for (std::string cell; std::getline(cells, cell, ',');) values.push_back(std::stod(cell));
    ASSERT_EQ(values.size(), 4u);
    const SurfaceSample sample =
        sea.surface.sample(sea.geodesy.seaPlaneFromGeodetic(28.878, -78.467).position, rows / 4.0);
    EXPECT_EQ(values,
              (std::vector<double>{rows / 4.0, sample.height, sample.slope.x, sample.slope.y}));
  }
  EXPECT_EQ(rows, 1440);
}

TEST(BuoyCommand, PrintsATableWithoutJson) {
  const TempFolder folder;
  const auto outcome = test::seaway(
      {"buoy", writeScene(folder).string(), "--at", "28.878,-78.467", "--hours", "0.2"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  for (const char* word : {"H_m0", "T_p", "T_m02", "overall", "at the peak", "kurtosis", "Welch"}) {
    EXPECT_NE(outcome.out.find(word), std::string::npos) << word;
  }
}

TEST(BuoyCommandHard, FlatWaterReadsNothingAndIsNoFault) {
  BuoyOptions options = shortRecord(SEAWAY_SOURCE_DIR "/configs/scenes/calm.yaml");
  const Scene scene = loadScene(options.scene);
  options.at = std::to_string(scene.sea.anchor.latitude_deg) + "," +
               std::to_string(scene.sea.anchor.longitude_deg);
  const auto sea = read(options);
  EXPECT_EQ(sea["hm0_m"], 0.0);
  EXPECT_TRUE(sea["tp_s"].is_null());
  EXPECT_TRUE(sea["mean_direction_from_deg"].is_null());
}

TEST(BuoyCommandHard, WarnsWhereTheSeaIsFasterThanTheSampling) {
  const TempFolder folder;
  const auto outcome = test::seaway({"buoy", writeScene(folder).string(), "--at", "28.878,-78.467",
                                     "--hours", "1", "--rate", "0.3"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("half the sampling rate"), std::string::npos) << outcome.err;
}

TEST(BuoyCommandHard, BadInputIsRefusedBeforeAnythingIsWritten) {
  const TempFolder folder;
  const std::string scene = writeScene(folder).string();
  const auto before = folder.files();
  struct Fault {
    std::vector<std::string> arguments;
    std::string message;
  };
  const std::string here = "28.878,-78.467";
  const std::vector<Fault> faults = {
      {{"--at", "0,0"}, "farther from the scene's anchor than 500 km"},
      {{"--at", "91,-78"}, "must be in [-90, 90]"},
      {{"--at", "28.878"}, "is not LATITUDE,LONGITUDE"},
      {{"--at", "nan,-78"}, "is not finite"},
      {{"--at", here, "--rate", "0"}, "--rate: 0 is not allowed"},
      {{"--at", here, "--rate", "nan"}, "--rate"},
      {{"--at", here, "--hours", "-1"}, "--hours: -1 is not allowed"},
      {{"--at", here, "--hours", "0"}, "--hours: 0 is not allowed"},
      {{"--at", here, "--hours", "0.0001"}, "8 samples"},
      {{"--at", here, "--hours", "100000", "--rate", "1000"}, "samples are not allowed"},
      {{"--at", here, "--hours", "0.05"}, "--segment: 256 is not allowed"},
      {{"--at", here, "--hours", "0.5", "--segment", "1801"}, "no longer than the record"},
      {{"--at", here, "--segment", "3"}, "8 samples or more"},
      {{"--at", here, "--segment", "-256"}, "--segment: -256"},
      {{}, "--at"}};
  for (const Fault& fault : faults) {
    std::vector<std::string> arguments = {"buoy", scene, "--out", (folder / "b.csv").string()};
    arguments.insert(arguments.end(), fault.arguments.begin(), fault.arguments.end());
    const auto outcome = test::seaway(arguments);
    EXPECT_EQ(outcome.status, 2) << fault.message << ": " << outcome.err;
    EXPECT_NE(outcome.err.find(fault.message), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
  const std::string underFile = scene + "/b.csv";
  EXPECT_EQ(test::seaway({"buoy", scene, "--at", here, "--out", underFile}).status, 2);
  EXPECT_EQ(folder.files(), before);
}

}  // namespace
}  // namespace seaway::bridge
