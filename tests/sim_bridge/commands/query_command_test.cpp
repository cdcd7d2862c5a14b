#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "sim_bridge/commands/query.h"
#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene/sea.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

using test::TempFolder;
using test::writeWakelessScene;

std::string ask(QueryOptions options, const std::string& input = "") {
  const TempFolder folder;
  options.scene = writeWakelessScene(folder).string();
  std::istringstream in(input);
  std::ostringstream out;
  EXPECT_EQ(runQuery(options, in, out), 0);
  return out.str();
}

std::vector<std::vector<std::string>> cells(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::istringstream text(line);
    for (std::string cell; std::getline(text, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

double number(const std::string& text) {
  double value = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

TEST(QueryCommand, WritesTheInputColumnsThenTheResults) {
  QueryOptions options;
  options.time = 3.0;
  options.points = "-";
  const auto rows = cells(ask(options, "id,x_m,y_m,z_m\nfirst,10,20,-1\n"));
  EXPECT_EQ(rows[0],
            (std::vector<std::string>{"id", "x_m", "y_m", "z_m", "height_m", "slope_x", "slope_y",
                                      "velocity_z_m_s", "error_m", "bound_m", "status"}));
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[1][0], "first");
  EXPECT_EQ(rows[1].back(), "ok");
}

TEST(QueryCommand, NumbersReadBackToTheSurfacesOwnBits) {
  const TempFolder folder;
  const Scene scene = loadScene(writeWakelessScene(folder));
  const Sea sea = buildSea(scene);
  QueryOptions options;
  options.time = 3.25;
  options.points = "-";
  const auto rows = cells(ask(options, "x_m,y_m\n10.1,-20.7\n"));
  const SurfaceSample sample = sea.surface.sample({10.1, -20.7}, 3.25);
  EXPECT_EQ(number(rows[1][2]), sample.height);
  EXPECT_EQ(number(rows[1][3]), sample.slope.x);
  EXPECT_EQ(number(rows[1][5]), sample.verticalVelocity);
  EXPECT_EQ(number(rows[1][7]), sample.bound);
}

TEST(QueryCommand, EachPointMayHaveItsOwnTime) {
  QueryOptions options;
  options.points = "-";
  const auto mixed = cells(ask(options, "x_m,y_m,t_s\n1,2,5\n1,2,0\n1,2,5\n"));
  EXPECT_EQ(mixed[1][3], mixed[3][3]);
  EXPECT_NE(mixed[1][3], mixed[2][3]);
  options.time = 5.0;
  EXPECT_EQ(cells(ask(options, "x_m,y_m\n1,2\n"))[1][2], mixed[1][3]);
}

TEST(QueryCommand, GeodeticAndSeaPlanePointsAgree) {
  const TempFolder folder;
  const Sea sea = buildSea(loadScene(writeWakelessScene(folder)));
  const GeodeticPosition place = sea.geodesy.geodeticFromSeaPlane({300.0, -500.0});
  QueryOptions options;
  options.time = 1.0;
  options.points = "-";
  const double inPlane = number(cells(ask(options, "x_m,y_m\n300,-500\n"))[1][2]);
  std::ostringstream text;
  text.precision(17);
  text << "latitude_deg,longitude_deg\n"
       << place.latitude_deg << "," << place.longitude_deg << "\n";
  // 1e-6 m of round trip at slopes below one.
  EXPECT_NEAR(number(cells(ask(options, text.str()))[1][2]), inPlane, 1e-6);
}

TEST(QueryCommandHard, PointsOutOfRangeOrNotFiniteSaySoAndLeaveTheOthersAlone) {
  QueryOptions options;
  options.time = 1.0;
  options.points = "-";
  const auto rows =
      cells(ask(options, "latitude_deg,longitude_deg\n28.9,-78.4\n0,0\nnan,-78\n28.9,-78.4\n"));
  EXPECT_EQ(rows[1].back(), "ok");
  EXPECT_EQ(rows[2].back(), "out_of_range");
  EXPECT_EQ(rows[2][2], "nan");
  EXPECT_EQ(rows[3].back(), "not_finite");
  EXPECT_EQ(rows[1], rows[4]);
}

TEST(QueryCommand, ToleranceLeavesOctavesOutAndSaysSo) {
  QueryOptions options;
  options.time = 1.0;
  options.at = {"28.878,-78.467"};
  options.tolerance = 0.05;
  const auto row = cells(ask(options))[1];
  EXPECT_EQ(row.back(), "truncated");
  EXPECT_GT(number(row[6]), 0.0);
  EXPECT_LE(number(row[6]), 0.05);
}

TEST(QueryCommand, OrbitalVelocitiesFollowTheStatusAndAreTheSurfacesOwn) {
  const TempFolder folder;
  const Sea sea = buildSea(loadScene(writeWakelessScene(folder)));
  QueryOptions options;
  options.time = 3.25;
  options.points = "-";
  options.orbital = true;
  const auto rows = cells(ask(options, "x_m,y_m\n10.1,-20.7\nnan,0\n"));
  const std::vector<std::string> added(rows[0].end() - 4, rows[0].end());
  EXPECT_EQ(added, (std::vector<std::string>{"status", "orbital_u_m_s", "orbital_v_m_s",
                                             "orbital_w_m_s"}));
  const SurfaceSample sample = sea.surface.sample({10.1, -20.7}, 3.25, {.orbitalVelocity = true});
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(number(rows[1][rows[1].size() - 3 + static_cast<std::size_t>(i)]),
              sample.orbitalVelocity[i]);
  }
  EXPECT_EQ(number(rows[1].back()), sample.verticalVelocity);  // no current: w = ∂η/∂t
  EXPECT_EQ(rows[2].back(), "nan");
  options.json = true;
  const auto json = nlohmann::json::parse(ask(options, "x_m,y_m\n10.1,-20.7\n"));
  EXPECT_EQ(json["points"][0]["orbital_u_m_s"].get<double>(), sample.orbitalVelocity.x);
  EXPECT_EQ(json["points"][0]["orbital_w_m_s"].get<double>(), sample.orbitalVelocity.z);
}

TEST(QueryCommand, ModelOverridesTheScenesKindOfOctaves) {
  const TempFolder folder;
  Scene scene = loadScene(writeWakelessScene(folder));
  scene.sea.model = OctaveKind::perlin;
  const SurfaceSample perlin = buildSea(scene).surface.sample({10.1, -20.7}, 3.25);
  QueryOptions options;
  options.time = 3.25;
  options.points = "-";
  const std::string point = "x_m,y_m\n10.1,-20.7\n";
  const auto standard = cells(ask(options, point));
  options.model = "group";
  EXPECT_EQ(cells(ask(options, point)), standard);
  options.model = "perlin";
  options.orbital = true;
  const auto row = cells(ask(options, point))[1];
  EXPECT_EQ(number(row[2]), perlin.height);
  EXPECT_EQ(row[8], "no_kinematics");
  EXPECT_EQ(row.back(), "nan");
}

TEST(QueryCommand, CutoffLeavesOutTheShortWavesAndSaysSo) {
  const TempFolder folder;
  const Sea sea = buildSea(loadScene(writeWakelessScene(folder)));
  QueryOptions options;
  options.time = 1.0;
  options.points = "-";
  options.cutoff = 10.0;
  const auto row = cells(ask(options, "x_m,y_m\n10.1,-20.7\n"))[1];
  EXPECT_EQ(row[8], "truncated");
  double leftOut = 0.0;
  for (const Octave& octave : sea.surface.waves().octaves()) {
    if (dominantWavelength(octave) >= 10.0) continue;
    leftOut += octave.standardDeviation * octave.standardDeviation;
  }
  EXPECT_NEAR(number(row[6]), std::sqrt(leftOut), 1e-12);  // summed in another order
}

TEST(QueryCommandHard, BadCutoffsAndModelsAreRefused) {
  const TempFolder folder;
  const auto ask = [&](const std::string& scene, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"query", scene, "--time", "0", "--at", "28.9,-78.4"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto outcome = test::seaway(arguments);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    return outcome.err;
  };
  const std::string scene = writeWakelessScene(folder).string();
  EXPECT_NE(ask(scene, {"--cutoff", "-1"}).find("--cutoff"), std::string::npos);
  EXPECT_NE(ask(scene, {"--cutoff", "nan"}).find("--cutoff"), std::string::npos);
  EXPECT_NE(ask(scene, {"--model", "fourier"}).find("group, perlin"), std::string::npos);
  const std::string measured = std::string(SEAWAY_SOURCE_DIR) + "/configs/scenes/measured.yaml";
  EXPECT_NE(ask(measured, {"--model", "group"}).find("'sea.state'"), std::string::npos);
}

TEST(QueryCommand, JsonHoldsTheSamePoints) {
  QueryOptions options;
  options.time = 1.0;
  options.at = {"28.878,-78.467", "28.9,-78.4"};
  options.ellipsoidal = true;
  const auto csv = cells(ask(options));
  options.json = true;
  const auto json = nlohmann::json::parse(ask(options));
  ASSERT_EQ(json["points"].size(), 2u);
  EXPECT_EQ(json["points"][1]["height_m"].get<double>(), number(csv[2][2]));
  EXPECT_EQ(json["points"][1]["ellipsoidal_height_m"].get<double>(), number(csv[2].back()));
  EXPECT_EQ(json["points"][0]["status"], "ok");
}

TEST(QueryCommand, ReadsPointsFromAFileOrStandardInputOfTheBinary) {
  const TempFolder folder;
  const std::string scene = writeWakelessScene(folder).string();
  const std::string points = "latitude_deg,longitude_deg\n28.878,-78.467\n-0,0\n";
  const std::string file = folder.write("points.csv", points).string();
  const auto fromFile = test::seaway({"query", scene, "--time", "2", "--points", file});
  const auto fromInput = test::seaway({"query", scene, "--time", "2", "--points", "-"}, points);
  EXPECT_EQ(fromFile.status, 0) << fromFile.err;
  EXPECT_EQ(fromFile.out, fromInput.out);
  const auto southern = test::seaway({"query", scene, "--time", "2", "--at", "-28.878,-78.467"});
  EXPECT_EQ(southern.status, 0) << southern.err;
  EXPECT_NE(southern.out.find("out_of_range"), std::string::npos);
}

}  // namespace
}  // namespace seaway::bridge
