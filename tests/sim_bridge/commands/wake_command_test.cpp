#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "render/png.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

using test::seaway;
using test::TempFolder;

TEST(WakeCommand, SetsAWakeBesideTheoryAndDrawsIt) {
  const TempFolder folder;
  const std::string out = (folder / "wake").string();
  const auto outcome = seaway({"wake", "--speed", "5", "--length", "16", "--out", out, "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto wake = nlohmann::json::parse(outcome.out);
  const double wavelength = wake["transverse_wavelength_m"],
               theory = wake["transverse_wavelength_theory_m"];
  EXPECT_NEAR(theory, 16.01, 0.02);              // 2πU²/g
  EXPECT_NEAR(wavelength / theory, 1.0, 0.005);  // the solver's figure
  EXPECT_NEAR(wake["cusp_angle_extrapolated_deg"].get<double>(), 19.47, 0.5);
  EXPECT_LT(wake["cusp_angle_deg"].get<double>(), 19.47);  // the ridge lies inside the cusp line
  EXPECT_GT(wake["step_ms"].get<double>(), 0.0);
  EXPECT_EQ(render::readPng(folder / "wake" / "wake.png").size, glm::ivec2(1200, 800));
  EXPECT_TRUE(std::filesystem::exists(folder / "wake" / "wake.json"));
}

TEST(WakeCommand, BeyondTheCriticalSpeedThereAreNoTransverseWaves) {
  const TempFolder folder;
  std::vector<std::string> words{"wake",     "--speed", "6",
                                 "--length", "12",      "--depth",
                                 "2",        "--out",   (folder / "wake").string()};
  const auto told = seaway(words);
  EXPECT_NE(told.out.find("transverse wavelength  m       none      none"), std::string::npos)
      << told.out;
  words.push_back("--json");
  const auto outcome = seaway(words);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto wake = nlohmann::json::parse(outcome.out);
  EXPECT_TRUE(wake["transverse_wavelength_m"].is_null());
  EXPECT_TRUE(wake["transverse_wavelength_theory_m"].is_null());
  EXPECT_NEAR(wake["cusp_angle_theory_deg"].get<double>(), 47.6, 0.1);  // asin(sqrt(gd)/U)
  // 46.9: a third of the front's height lies inside its line, less and less so astern.
  EXPECT_NEAR(wake["cusp_angle_extrapolated_deg"].get<double>(), 47.6, 1.0);
}

TEST(WakeCommandHard, AtTheCriticalSpeedTheWedgeLeavesTheWindowAndIsNotMeasured) {
  const TempFolder folder;
  const auto outcome = seaway({"wake", "--speed", "4.43", "--length", "12", "--depth", "2", "--out",
                               (folder / "wake").string(), "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto wake = nlohmann::json::parse(outcome.out);
  EXPECT_GT(wake["cusp_angle_theory_deg"].get<double>(), 80.0);
  EXPECT_TRUE(wake["cusp_angle_deg"].is_null());
  EXPECT_TRUE(wake["cusp_angle_extrapolated_deg"].is_null());
}

TEST(WakeCommandHard, RefusesWhatMakesNoWake) {
  const TempFolder folder;
  const std::string out = (folder / "wake").string();
  for (const std::vector<std::string>& bad :
       std::vector<std::vector<std::string>>{{"--speed", "0", "--length", "12"},
                                             {"--speed", "nan", "--length", "12"},
                                             {"--speed", "1", "--length", "100"},
                                             {"--speed", "5", "--length", "-1"},
                                             {"--speed", "5", "--length", "12", "--depth", "0"}}) {
    std::vector<std::string> arguments{"wake"};
    arguments.insert(arguments.end(), bad.begin(), bad.end());
    arguments.insert(arguments.end(), {"--out", out});
    const auto outcome = seaway(arguments);
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_NE(outcome.err.find("must be"), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(out));
  }
}

}  // namespace
}  // namespace seaway::bridge
