#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/sim_bridge/capi/support.h"

namespace seaway::bridge::test {
namespace {

std::string descriptionOf(const seaway_sea* sea) {
  std::size_t needed = 0;
  EXPECT_EQ(seaway_sea_describe(sea, nullptr, 0, &needed), SEAWAY_BUFFER_TOO_SMALL);
  std::string text(needed, '#');
  EXPECT_EQ(seaway_sea_describe(sea, text.data(), needed, &needed), SEAWAY_OK);
  EXPECT_EQ(text.back(), '\0');
  text.pop_back();
  return text;
}

TEST(CapiSea, HeaderAndLibraryAreOfOneVersion) {
  EXPECT_EQ(std::string(seaway_version()), std::to_string(SEAWAY_VERSION_MAJOR) + "." +
                                               std::to_string(SEAWAY_VERSION_MINOR) + "." +
                                               std::to_string(SEAWAY_VERSION_PATCH));
}

TEST(CapiSea, EveryStatusHasAName) {
  for (int i = SEAWAY_OK; i <= SEAWAY_FAILED; ++i) {
    EXPECT_STRNE(seaway_status_name(i), "unknown status");
  }
  EXPECT_STREQ(seaway_status_name(SEAWAY_FAILED + 1), "unknown status");
}

TEST(CapiSea, ComesFromAFileAsFromItsText) {
  seaway_sea* made = nullptr;
  ASSERT_EQ(
      seaway_sea_from_file(SEAWAY_SOURCE_DIR "/configs/scenes/crossing_wakes.yaml", nullptr, &made),
      SEAWAY_OK)
      << seaway_last_error();
  const SeaPointer sea(made);
  EXPECT_EQ(seaway_sea_time(sea.get()), 0.0);
  EXPECT_EQ(seaway_sea_vessel_count(sea.get()), 3u);
  EXPECT_EQ(seaway_sea_camera_count(sea.get()), 3u);
  EXPECT_STREQ(seaway_sea_vessel_name(sea.get(), 1), "workboat");
  EXPECT_EQ(seaway_sea_vessel_name(sea.get(), 3), nullptr);
  EXPECT_STREQ(seaway_sea_camera_name(sea.get(), 2), "mast");
}

TEST(CapiSea, StepsAsOftenAsFitsBeforeATime) {
  const SeaPointer sea = seaFrom(boats);
  EXPECT_EQ(seaway_sea_step_length(sea.get()), 0.02);
  ASSERT_EQ(seaway_sea_step(sea.get()), SEAWAY_OK);
  EXPECT_DOUBLE_EQ(seaway_sea_time(sea.get()), 0.02);
  ASSERT_EQ(seaway_sea_step_to(sea.get(), 0.25), SEAWAY_OK);
  EXPECT_DOUBLE_EQ(seaway_sea_time(sea.get()), 0.24);
  ASSERT_EQ(seaway_sea_step_to(sea.get(), 0.1), SEAWAY_OK);
  EXPECT_DOUBLE_EQ(seaway_sea_time(sea.get()), 0.24);
}

TEST(CapiSea, RestartsWithTheSameBits) {
  const std::string scene = boats;
  const SeaPointer sea = seaFrom(scene);
  const Line line(200, 0.5);
  ASSERT_EQ(seaway_sea_step_to(sea.get(), 2.0), SEAWAY_OK);
  const std::vector<double> first = heightsOf(sea.get(), 2.0, line.points());
  ASSERT_EQ(seaway_sea_restart(sea.get(), 0.0), SEAWAY_OK);
  EXPECT_EQ(seaway_sea_time(sea.get()), 0.0);
  ASSERT_EQ(seaway_sea_step_to(sea.get(), 2.0), SEAWAY_OK);
  EXPECT_EQ(heightsOf(sea.get(), 2.0, line.points()), first);
}

TEST(CapiSea, BeginsAtAStartTime) {
  seaway_sea_options options = seaway_sea_options_default();
  options.start_time = 1.0;
  seaway_sea* made = nullptr;
  ASSERT_EQ(
      seaway_sea_from_text(boats.c_str(), SEAWAY_SOURCE_DIR "/configs/scenes", &options, &made),
      SEAWAY_OK);
  const SeaPointer sea(made);
  EXPECT_DOUBLE_EQ(seaway_sea_time(sea.get()), 1.0);
}

TEST(CapiSea, SaysFileLineAndKeyOfWhatASceneMayNotBe) {
  seaway_sea* sea = nullptr;
  const std::string yaml = openSea + "accuracy: {motion_tolerance_m: -1}\n";
  EXPECT_EQ(seaway_sea_from_text(yaml.c_str(), "/nowhere", nullptr, &sea), SEAWAY_BAD_INPUT);
  EXPECT_EQ(sea, nullptr);
  const std::string message = seaway_last_error();
  for (const char* part : {"/nowhere/<text>:6", "motion_tolerance_m", "-1"}) {
    EXPECT_NE(message.find(part), std::string::npos) << message;
  }
}

TEST(CapiSea, DescribesItself) {
  const SeaPointer sea = seaFrom(boats);
  ASSERT_EQ(seaway_sea_step(sea.get()), SEAWAY_OK);
  const auto json = nlohmann::json::parse(descriptionOf(sea.get()));
  EXPECT_EQ(json["version"], seaway_version());
  EXPECT_EQ(json["time_s"], 0.02);
  EXPECT_EQ(json["anchor"]["latitude_deg"], 51.98);
  EXPECT_EQ(json["sea"]["hm0_asked_m"], 0.0);
  EXPECT_EQ(json["vessels"].size(), 2u);
  EXPECT_EQ(json["vessels"][1]["name"], "drifter");
  EXPECT_EQ(json["cameras"][0]["mount"], "pilot");
  bool anyOn = false;
  for (const auto& effect : json["effects"]) anyOn = anyOn || effect["state"] == "on";
  EXPECT_TRUE(anyOn);
}

TEST(CapiSea, DescribesTheSeaAskedAndRealised) {
  const SeaPointer sea = seaFrom(openSea);
  const auto json = nlohmann::json::parse(descriptionOf(sea.get()));
  EXPECT_EQ(json["sea"]["hm0_asked_m"], 1.12);
  EXPECT_NEAR(json["sea"]["hm0_realised_m"], 1.12, 0.02 * 1.12);  // sampling and the fit's scaling
  EXPECT_EQ(json["sea"]["octaves"].size(), 12u);
}

}  // namespace
}  // namespace seaway::bridge::test

extern "C" int seaway_test_header_compiles(void);

TEST(CapiHeader, IsC11) { EXPECT_EQ(seaway_test_header_compiles(), 1); }
