#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene/sea.h"
#include "sim_bridge/scene/sea_state_file.h"
#include "surface/spectra/families.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

using test::seaway;
using test::TempFolder;

// Two records in NDBC's format, from Pierson–Moskowitz spectra known here.
std::string ndbcFile() {
  std::string text = "#YY  MM DD hh mm Sep_Freq  < spec_1 (freq_1) spec_2 (freq_2) ... >\n";
  const std::pair<const char*, FrequencySpectrum> records[] = {
      {"2020 06 08 03 50 9.999", piersonMoskowitz(2.0, 8.0)},
      {"2020 06 08 02 50 0.100", piersonMoskowitz(3.0, 10.0)}};
  for (const auto& [time, spectrum] : records) {
    text += time;
    for (int i = 0; i < 46; ++i) {
      char cell[32];
      const double frequency = 0.03 + 0.01 * i;
      std::snprintf(cell, sizeof cell, " %.3f (%.3f)", spectrum.at(frequency), frequency);
      text += cell;
    }
    text += '\n';
  }
  return text;
}

/// One record in Spotter's format: Pierson–Moskowitz, from 255 degrees, spread by 25 degrees.
std::string spotterFile() {
  const FrequencySpectrum energy = piersonMoskowitz(2.0, 8.0);
  nlohmann::json record{{"timestamp", "2020-06-08T02:50:00.000Z"}};
  for (int i = 0; i < 40; ++i) {
    const double frequency = 0.04 + 0.01 * i;
    record["frequency"].push_back(frequency);
    record["varianceDensity"].push_back(energy.at(frequency));
    record["direction"].push_back(255.0);
    record["directionalSpread"].push_back(25.0);
  }
  return nlohmann::json{{"frequencyData", {record}}}.dump();
}

nlohmann::json fitted(const TempFolder& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "fit");
  arguments.insert(arguments.end(), {"--out", (folder / "sea.yaml").string(), "--json"});
  const auto outcome = seaway(arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return nlohmann::json::parse(outcome.out);
}

TEST(FitCommand, TellsTargetAndFitOfAFamily) {
  const TempFolder folder;
  const auto fit = fitted(folder, {"pm:2.5,8", "--from-deg", "270"});
  EXPECT_TRUE(fit["usable"]);
  EXPECT_NEAR(fit["hm0_target_m"].get<double>(), 2.5, 1e-9);
  EXPECT_NEAR(fit["hm0_fit_m"].get<double>(), 2.5, 1e-9);
  EXPECT_NEAR(fit["tp_target_s"].get<double>(), 8.0, 0.05);
  EXPECT_LE(fit["residual_l2"].get<double>(), 0.15);  // eight octaves reach 0.13
  for (const char* key : {"tm02_target_s", "tm02_fit_s", "tp_fit_s"}) {
    EXPECT_GT(fit[key].get<double>(), 0.0) << key;
  }
  ASSERT_EQ(fit["octaves"].size(), 8u);
  EXPECT_NEAR(fit["octaves"][0]["toward_deg"].get<double>(), 90.0, 1e-9);
}

TEST(FitCommand, SaysWhereASeaIsSteeperThanSeasGet) {
  const TempFolder folder;
  const auto calm = fitted(folder, {"jonswap:2,8,3.3", "--from-deg", "0"});
  EXPECT_FALSE(calm["steeper_than_limit"]);
  EXPECT_LT(calm["average_steepness"], calm["limiting_steepness"]);
  const auto steep = fitted(folder, {"jonswap:9,8,3.3", "--from-deg", "0"});
  EXPECT_TRUE(steep["steeper_than_limit"]);
  EXPECT_GT(steep["average_steepness"], steep["limiting_steepness"]);
  const auto told = seaway({"fit", "jonswap:9,8,3.3", "--out", (folder / "sea.yaml").string()});
  EXPECT_NE(told.out.find("steeper than seas get"), std::string::npos) << told.out;
}

TEST(FitCommand, ChoosesARecordByNumberOrTime) {
  const TempFolder folder;
  const std::string file = folder.write("buoy.data_spec", ndbcFile()).string();
  // The file rounds densities to 1e-3 m²/Hz.
  EXPECT_NEAR(fitted(folder, {file})["hm0_target_m"].get<double>(), 2.0, 0.02);
  EXPECT_NEAR(fitted(folder, {file, "--record", "1"})["hm0_target_m"].get<double>(), 3.0, 0.03);
  const auto byTime = fitted(folder, {file, "--time", "2020-06-08T02:50"});
  EXPECT_NEAR(byTime["hm0_target_m"].get<double>(), 3.0, 0.03);
  EXPECT_EQ(byTime["record_time"], "2020-06-08T02:50Z");
  EXPECT_EQ(seaway({"fit", file, "--record", "2", "--out", (folder / "s.yaml").string()}).status,
            2);
}

TEST(FitCommand, WhatItWritesIsASeaStateForAScene) {
  const TempFolder folder;
  fitted(folder, {"pm:2.5,8", "--from-deg", "270"});
  folder.write("launch.yaml", test::vesselText());
  const auto scene = folder.write(
      "scene.yaml", test::sceneText({{"    jonswap:\n      hm0_m: 1.12\n      tp_s: 5.6\n      "
                                      "from_deg: 196\n",
                                      "    file: sea.yaml\n"}}));
  const Sea sea = buildSea(loadScene(scene));
  EXPECT_NEAR(sea.hm0Asked, 2.5, 1e-9);
  EXPECT_NEAR(realisedSignificantWaveHeight(sea.surface), 2.5, 0.02 * 2.5);
}

TEST(FitCommand, SaysThatAFrequencySpectrumHasNoDirection) {
  const TempFolder folder;
  const auto outcome = seaway({"fit", "pm:1,6", "--out", (folder / "sea.yaml").string()});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.err.find("--from-deg"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.out.find("S(k)"), std::string::npos);
}

TEST(FitCommand, ReportsAndVerifiesAGroupFit) {
  const TempFolder folder;
  const std::string report = (folder / "report").string();
  const auto outcome =
      seaway({"fit", "jonswap:2,8,3.3", "--model", "group", "--budget", "8", "--from-deg", "270",
              "--parameters", "--verify", "--hours", "1", "--report", report, "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto fit = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(fit["octaves"].size(), 8u);
  EXPECT_LT(fit["wave_number_deviation"].get<double>(), 0.1);
  EXPECT_NEAR(fit["parameters"]["systems"][0]["tp_s"].get<double>(), 8.0, 0.2);
  const auto& height = fit["verification"]["quantities"][0];
  EXPECT_NEAR(height["read"].get<double>(), 2.0, 4.0 * height["standard_error"].get<double>());
  const std::string page = test::readFile(folder / "report/report.html");
  EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
  EXPECT_TRUE(page.ends_with("</html>\n"));
  std::size_t figures = 0;
  for (std::size_t at = 0; (at = page.find("<svg", at)) != std::string::npos; ++at) ++figures;
  EXPECT_EQ(figures, 5u);  // spectrum twice, residual, octaves, polar map
  for (const char* elsewhere : {"<script src", "<link", "src=\"http"}) {
    EXPECT_EQ(page.find(elsewhere), std::string::npos) << elsewhere;
  }
  EXPECT_NO_THROW(loadSeaState(folder / "report/sea.yaml"));
  EXPECT_EQ(folder.files().size(), 2u);
}

TEST(FitCommand, ABuoyReadsTheDirectionsOfAMeasuredSea) {
  const TempFolder folder;
  const std::string file = folder.write("spotter.json", spotterFile()).string();
  std::vector<std::string> words{
      "fit",     file, "--model",      "group",    "--verify",
      "--hours", "1",  "--parameters", "--report", (folder / "report").string()};
  const auto told = seaway(words);
  ASSERT_EQ(told.status, 0) << told.err;
  for (const char* word : {"a buoy in the fitted field, 1 h", "direction at the peak, from deg",
                           "parameters by the gamma likelihood", "AIC"}) {
    EXPECT_NE(told.out.find(word), std::string::npos) << word << told.out;
  }
  const std::string page = test::readFile(folder / "report/report.html");
  EXPECT_NE(page.find("Mean direction"), std::string::npos);
  words.push_back("--json");
  const auto fit = nlohmann::json::parse(seaway(words).out);
  const auto& quantities = fit["verification"]["quantities"];
  ASSERT_EQ(quantities.size(), 4u);  // height, period, direction, spread
  EXPECT_NEAR(quantities[2]["asked"].get<double>(), 255.0, 1e-6);
  EXPECT_NEAR(quantities[3]["asked"].get<double>(), 25.0, 1e-6);
  for (const auto& each : quantities) {
    // Four standard errors: one in 16 000 is farther off, and the seed is fixed.
    EXPECT_NEAR(each["read"].get<double>(), each["asked"].get<double>(),
                4.0 * each["standard_error"].get<double>())
        << each;
  }
  const auto& system = fit["parameters"]["systems"][0];
  EXPECT_NEAR(system["from_deg"].get<double>(), 255.0,
              system["from_deg_standard_deviation"].get<double>())
      << system;
}

TEST(FitCommand, NeedsSomewhereToWriteAndSoundOptions) {
  const TempFolder folder;
  const std::string out = (folder / "sea.yaml").string();
  const std::vector<std::vector<std::string>> wrong = {
      {"fit", "pm:2,8"},
      {"fit", "pm:2,8", "--out", out, "--starts", "0"},
      {"fit", "pm:2,8", "--out", out, "--degrees-of-freedom", "1"},
      {"fit", "pm:2,8", "--out", out, "--hours", "0"},
      {"fit", "pm:2,8", "--report", "/proc/nowhere"}};
  for (const auto& arguments : wrong) {
    const auto outcome = seaway(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments.back();
    EXPECT_FALSE(outcome.err.empty());
  }
  EXPECT_TRUE(folder.files().empty());
}

TEST(FitCommand, FitsTheMeasuredRecordOfTheDemonstration) {
  const std::string file = std::string(SEAWAY_SHARED_DIR) + "/data/ndbc/41010.data_spec";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not here";
  const TempFolder folder;
  const auto fit = fitted(folder, {file, "--record", "0", "--from-deg", "196"});
  EXPECT_EQ(fit["record_time"], "2020-06-08T03:50Z");
  EXPECT_NEAR(fit["hm0_target_m"].get<double>(), 1.12, 0.01);
  EXPECT_NEAR(fit["tp_target_s"].get<double>(), 5.6, 0.15);
}

}  // namespace
}  // namespace seaway::bridge
