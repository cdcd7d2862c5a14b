#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "sim_bridge/commands/query.h"
#include "surface/constants.h"
#include "surface/dispersion.h"
#include "tests/sim_bridge/test_support.h"

// `seaway query` below the surface, at any depth of water and in a current.
namespace seaway::bridge {
namespace {

using test::TempFolder;
using test::writeWakelessScene;
using Replacements = std::vector<std::pair<std::string, std::string>>;

constexpr double amplitude = 0.1, frequency = 0.2;  // m, Hz
constexpr const char* jonswapState =
    "    jonswap:\n      hm0_m: 1.12\n      tp_s: 5.6\n      from_deg: 196";

// One regular wave towards the east.
Replacements regularWave(const std::string& depth) {
  return {{jonswapState,
           "    octaves:\n      - {kind: regular, standard_deviation_m: 0.07071067811865475, "
           "frequency_hz: 0.2, toward_deg: 90}"},
          {"depth_m: inf", "depth_m: " + depth}};
}

nlohmann::json points(const Replacements& replacements, QueryOptions options,
                      const std::string& input) {
  const TempFolder folder;
  options.scene = writeWakelessScene(folder, replacements).string();
  options.points = "-";
  options.json = true;
  std::istringstream in(input);
  std::ostringstream out;
  EXPECT_EQ(runQuery(options, in, out), 0);
  return nlohmann::json::parse(out.str())["points"];
}

QueryOptions kinematics(double time = 0.0) {
  QueryOptions options;
  options.time = time;
  options.orbital = options.pressure = true;
  return options;
}

TEST(QueryKinematics, PressureIsGaugeHydrostaticPlusStretchedDynamic) {
  for (const double depth : {0.5, 3.0, 20.0, std::numeric_limits<double>::infinity()}) {
    SCOPED_TRACE(depth);
    const std::string text = std::isinf(depth) ? "inf" : std::to_string(depth);
    // A crest passes the anchor at time 0.
    for (const double z : {0.05, 0.0, -0.1, -0.4}) {
      const auto point = points(regularWave(text), kinematics(),
                                "x_m,y_m,z_m\n0,0," + std::to_string(z) + "\n")[0];
      const double k = waveNumber(2.0 * pi * frequency, depth);
      const double stretched =
          std::isinf(depth) ? z - amplitude : depth * (z - amplitude) / (depth + amplitude);
      const double decay = std::isinf(depth)
                               ? std::exp(k * stretched)
                               : std::cosh(k * (stretched + depth)) / std::cosh(k * depth);
      const double weight = seaWaterDensity * standardGravity;
      EXPECT_NEAR(point["pressure_pa"].get<double>(), weight * (amplitude * decay - z),
                  3e-5 * weight * amplitude);  // float kernels: 1e-5 ρgσ, and the surface's own
      EXPECT_EQ(point["status"], "ok");
      const double across = std::isinf(depth)
                                ? std::exp(k * stretched)
                                : std::cosh(k * (stretched + depth)) / std::sinh(k * depth);
      EXPECT_NEAR(point["orbital_u_m_s"].get<double>(), amplitude * 2.0 * pi * frequency * across,
                  3e-6);
      EXPECT_NEAR(point["orbital_w_m_s"].get<double>(), 0.0, 3e-6);
    }
  }
}

TEST(QueryKinematics, WithoutAHeightItIsTheSurfaceWhereThePressureIsZero) {
  const auto surface = points(regularWave("inf"), kinematics(1.0), "x_m,y_m\n3,4\n")[0];
  EXPECT_EQ(surface["pressure_pa"], 0.0);
  EXPECT_EQ(surface["status"], "ok");
  std::ostringstream text;
  text.precision(17);
  // A micrometre below what the float kernels call the surface.
  text << "x_m,y_m,z_m\n3,4," << surface["height_m"].get<double>() - 1e-6 << '\n';
  const auto below = points(regularWave("inf"), kinematics(1.0), text.str())[0];
  EXPECT_NEAR(below["pressure_pa"].get<double>(), 0.0, 0.05);  // 1e-6 m of water weigh 0.01 Pa
  for (const char* name : {"orbital_u_m_s", "orbital_v_m_s", "orbital_w_m_s"}) {
    EXPECT_NEAR(below[name].get<double>(), surface[name].get<double>(), 1e-5) << name;
  }
}

TEST(QueryKinematics, PointsInTheAirAndInTheBedSaySo) {
  const auto answers =
      points(regularWave("5"), kinematics(), "x_m,y_m,z_m\n0,0,0.2\n0,0,-5.1\n0,0,nan\n0,0,-4.9\n");
  const char* states[] = {"above_surface", "below_bed", "not_finite", "ok"};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(answers[i]["status"], states[i]);
    EXPECT_EQ(answers[i]["pressure_pa"].is_null(), i < 3);
    EXPECT_EQ(answers[i]["orbital_w_m_s"].is_null(), i < 3);
    EXPECT_TRUE(answers[i]["height_m"].is_number());
  }
}

TEST(QueryKinematics, PerlinOctavesHaveNoPressure) {
  QueryOptions options = kinematics();
  options.model = "perlin";
  const auto answers = points({}, options, "x_m,y_m,z_m\n0,0,-3\n");
  EXPECT_EQ(answers[0]["status"], "no_kinematics");
  EXPECT_TRUE(answers[0]["pressure_pa"].is_null());
}

TEST(QueryKinematics, TheCommandTakesOneHeightForAllPoints) {
  const TempFolder folder;
  const std::string scene = writeWakelessScene(folder, regularWave("inf")).string();
  const auto outcome = test::seaway(
      {"query", scene, "--time", "0", "--at", "28.878,-78.467", "--z", "-2", "--pressure"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find(",status,pressure_pa\n"), std::string::npos) << outcome.out;
  const auto refused = [&](const std::vector<std::string>& more, const std::string& input,
                           const std::string& wanted) {
    std::vector<std::string> arguments{"query", scene, "--time", "0"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto bad = test::seaway(arguments, input);
    EXPECT_EQ(bad.status, 2);
    EXPECT_NE(bad.err.find(wanted), std::string::npos) << bad.err;
  };
  refused({"--at", "28.878,-78.467", "--z", "-2"}, "", "--z has no effect");
  refused({"--points", "-", "--z", "-2", "--orbital"}, "x_m,y_m,z_m\n1,2,3\n", "both");
  refused({"--at", "28.878,-78.467", "--z", "nan", "--orbital"}, "", "--z");
  refused({"--points", "-", "--pressure"}, "x_m,y_m,pressure_pa\n1,2,3\n", "written twice");
}

TEST(QueryKinematics, TimesBeforeTheEpochAreAnsweredAlikeFromOptionAndColumn) {
  QueryOptions options;
  options.time = -1234.5;
  const auto byOption = points({}, options, "x_m,y_m\n10,20\n");
  options.time.reset();
  const auto byColumn = points({}, options, "x_m,y_m,t_s\n10,20,-1234.5\n");
  EXPECT_EQ(byOption[0]["height_m"], byColumn[0]["height_m"]);
  EXPECT_TRUE(byOption[0]["height_m"].is_number());
  const TempFolder folder;
  const auto picture = test::seaway({"render", writeWakelessScene(folder).string(), "--time", "-1",
                                     "--out", (folder / "f.png").string()});
  EXPECT_EQ(picture.status, 2);
  EXPECT_NE(picture.err.find("--time"), std::string::npos) << picture.err;
}

TEST(QueryKinematics, WavesAreAsLongAsTheDepthMakesThem) {
  for (const double depth : {0.5, 2.0, 8.0, 100.0}) {
    SCOPED_TRACE(depth);
    const double length = 2.0 * pi / waveNumber(2.0 * pi * frequency, depth);
    std::ostringstream text;
    text.precision(17);
    text << "x_m,y_m\n0,0\n" << length << ",0\n" << 0.5 * length << ",0\n";
    QueryOptions options;
    options.time = 0.0;
    const auto answers = points(regularWave(std::to_string(depth)), options, text.str());
    // Float kernels: 1e-6 of the amplitude; the geodesy plays no part in sea-plane points.
    EXPECT_NEAR(answers[0]["height_m"].get<double>(), amplitude, 1e-6);
    EXPECT_NEAR(answers[1]["height_m"].get<double>(), amplitude, 1e-6);
    EXPECT_NEAR(answers[2]["height_m"].get<double>(), -amplitude, 1e-6);
  }
}

TEST(QueryKinematicsHard, SeasFromHalfAMetreToEndlessDepthAreAnswered) {
  std::string input = "x_m,y_m,z_m\n";
  for (int i = 0; i < 200; ++i)
    input += std::to_string(37 * i) + "," + std::to_string(-11 * i) + ",-0.3\n";
  for (const char* depth : {"0.5", "1", "3", "10", "50", "700", "1e5", "inf"}) {
    SCOPED_TRACE(depth);
    double squares = 0.0;
    for (const auto& point :
         points({{"1.12", "0.2"}, {"depth_m: inf", "depth_m: " + std::string(depth)}}, kinematics(),
                input)) {
      EXPECT_EQ(point["status"], "ok");
      EXPECT_TRUE(point["pressure_pa"].is_number());
      squares += std::pow(point["height_m"].get<double>(), 2);
    }
    // 200 nearly independent places: σ to 1/√400 = 5 %, four times that.
    EXPECT_NEAR(4.0 * std::sqrt(squares / 200.0), 0.2, 0.2 * 0.2);
  }
}

TEST(QueryKinematics, ACurrentThatStopsWavesIsReportedByQueryAndRun) {
  const TempFolder folder;
  // Deep water, 0.2 Hz: λ = 39.0 m, groups at 3.90 m/s.
  Replacements against = regularWave("inf");
  against.push_back({"seed: 7", "seed: 7\n  current: {speed_m_s: 4, toward_deg: 270}"});
  const std::string scene = writeWakelessScene(folder, against).string();
  const auto query =
      test::seaway({"query", scene, "--time", "0", "--at", "28.878,-78.467", "--json"});
  ASSERT_EQ(query.status, 0) << query.err;
  const auto run =
      test::seaway({"run", scene, "--fps", "0", "--out", (folder / "out").string(), "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  for (const auto* outcome : {&query, &run}) {
    EXPECT_NE(outcome->err.find("wavelength of 39"), std::string::npos) << outcome->err;
    EXPECT_NE(outcome->err.find("3.9 m/s"), std::string::npos) << outcome->err;
    const auto blocked = nlohmann::json::parse(outcome->out)["sea"]["blocked_octaves"];
    ASSERT_EQ(blocked.size(), 1u);
    EXPECT_NEAR(blocked[0]["wavelength_m"].get<double>(), 39.02, 0.01);
    EXPECT_NEAR(blocked[0]["group_speed_m_s"].get<double>(), 3.902, 0.001);
    EXPECT_NEAR(blocked[0]["current_against_m_s"].get<double>(), 4.0, 1e-9);
  }
  const auto along = test::seaway({"query", writeWakelessScene(folder, regularWave("inf")).string(),
                                   "--time", "0", "--at", "28.878,-78.467", "--json"});
  EXPECT_EQ(along.err, "");
  EXPECT_TRUE(nlohmann::json::parse(along.out)["sea"]["blocked_octaves"].empty());
}

}  // namespace
}  // namespace seaway::bridge
