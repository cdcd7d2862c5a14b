#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "surface/hull/analytic_hulls.h"
#include "surface/hull/hull_file.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge::test {
namespace {

using Json = nlohmann::json;

TEST(HullCommand, TellsTheHydrostaticsOfABoxFromItsFile) {
  const TempFolder folder;
  const auto file = folder.write("box.stl", hullFileBytes("box.stl", boxMesh(10.0, 3.0, 2.0, 1.0)));
  const Outcome outcome =
      seaway({"hull", file.string(), "--draft", "0.8", "--cg", "0", "0", "-0.1", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  // The file's floats.
  EXPECT_NEAR(json["displacement_m3"], 24.0, 1e-5);
  EXPECT_NEAR(json["centre_of_buoyancy_m"][2], -0.6, 1e-6);
  EXPECT_NEAR(json["waterplane_area_m2"], 30.0, 1e-5);
  EXPECT_NEAR(json["bm_t_m"], 9.0 / 9.6, 1e-6);
  EXPECT_NEAR(json["gm_t_m"], 9.0 / 9.6 + 0.4 - 0.9, 1e-6);
  EXPECT_NEAR(json["draft_m"], 0.8, 1e-6);
  EXPECT_NEAR(json["wetted_area_m2"], 30.0 + 0.8 * 26.0, 1e-5);
  EXPECT_EQ(json["watertight"], true);
  EXPECT_GT(json["triangles"], 12);
  EXPECT_EQ(json["righting_levers"].size(), 37u);
}

TEST(HullCommand, FindsTheAttitudeOfRestUnderAMass) {
  const Outcome outcome = seaway(
      {"hull", "wigley:10,1,0.625,0.4", "--mass", "2000", "--cg", "0.2", "0", "-0.3", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_NEAR(json["displacement_m3"], 2000.0 / 1026.0, 1e-9);
  EXPECT_LT(json["trim_deg"], -0.01);
  EXPECT_NEAR(json["heel_deg"], 0.0, 1e-6);
}

TEST(HullCommand, KnownDisplacementsAreMetExactly) {
  const Outcome outcome =
      seaway({"hull", "wigley:10,1,0.625,0.4", "--volume", "2.7777778", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NEAR(Json::parse(outcome.out)["displacement_m3"], 2.7777778, 1e-9);
}

TEST(HullCommand, KnownWaterplanesAreMetBesideTheDisplacement) {
  const Outcome outcome = seaway({"hull", "wigley:10,1,0.625,0.4", "--volume", "2.7777778",
                                  "--waterplane", "6.6666667", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  EXPECT_NEAR(json["displacement_m3"], 2.7777778, 1e-8);
  EXPECT_NEAR(json["waterplane_area_m2"], 6.6666667, 1e-6);
  EXPECT_EQ(seaway({"hull", "box:4,2,1", "--waterplane", "8"}).status, 2);
}

// Voxels of 4/150 m: half of one.
TEST(HullCommand, TellsDistancesFromTheHull) {
  const Outcome outcome = seaway({"hull", "box:4,2,1", "--distance", "0", "0", "-0.4", "--distance",
                                  "2.2", "0", "0", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json json = Json::parse(outcome.out);
  ASSERT_EQ(json["distances_m"].size(), 2u);
  EXPECT_NEAR(json["distances_m"][0], -0.1, 0.5 * 4.0 / 150.0);
  EXPECT_NEAR(json["distances_m"][1], 0.2, 0.5 * 4.0 / 150.0);
}

TEST(HullCommand, ReportsAreSelfContained) {
  const TempFolder folder;
  const Outcome outcome =
      seaway({"hull", "sphere:1", "--triangles", "200", "--report", folder.path().string()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(folder.files(), (std::vector<std::string>{"hull.json", "report.html"}));
  EXPECT_NE(readFile(folder / "report.html").find("<svg"), std::string::npos);
}

TEST(HullCommandHard, HolesAreToldRefusedAndRepaired) {
  const TempFolder folder;
  TriangleMesh mesh = sphereMesh(1.0);
  mesh.triangles.erase(mesh.triangles.begin() + 300);
  const auto file = folder.write("holed.stl", hullFileBytes("holed.stl", mesh));
  const Outcome refused = seaway({"hull", file.string(), "--json"});
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.err.find("hole"), std::string::npos);
  EXPECT_EQ(Json::parse(refused.out)["watertight"], false);
  EXPECT_EQ(Json::parse(refused.out)["open_edges"], 3);
  const auto whole = folder / "whole.stl";
  const Outcome repaired =
      seaway({"hull", file.string(), "--repair", whole.string(), "--voxel", "0.08", "--json"});
  ASSERT_EQ(repaired.status, 0) << repaired.err;
  const Outcome again = seaway({"hull", whole.string(), "--json"});
  ASSERT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(Json::parse(again.out)["watertight"], true);
  EXPECT_EQ(folder.files().size(), 2u);
}

TEST(HullCommandHard, MillimetresAreWarnedOf) {
  const TempFolder folder;
  const auto file = folder.write("mm.stl", hullFileBytes("mm.stl", boxMesh(10e3, 3e3, 2e3, 1e3)));
  const Outcome wrong = seaway({"hull", file.string()});
  EXPECT_EQ(wrong.status, 0);
  EXPECT_NE(wrong.err.find("millimetre"), std::string::npos);
  const Outcome right = seaway({"hull", file.string(), "--unit", "0.001", "--json"});
  EXPECT_EQ(right.err.find("millimetre"), std::string::npos);
  EXPECT_NEAR(Json::parse(right.out)["displacement_m3"], 30.0, 1e-4);
}

TEST(HullCommandHard, BadInputIsRefusedWithItsReason) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"hull", "missing.stl"}, "missing.stl"},
      {{"hull", "box:1,2"}, "box:LENGTH,BEAM,DEPTH"},
      {{"hull", "box:1,2,-3"}, "above 0"},
      {{"hull", "box:1,1,1", "--draft", "1.5"}, "--draft"},
      {{"hull", "box:1,1,1", "--mass", "0"}, "--mass"},
      {{"hull", "box:1,1,1", "--mass", "1e9"}, "below the hull's volume"},
      {{"hull", "box:1,1,1", "--mass", "500", "--draft", "0.5"}, "exclude"},
      {{"hull", "box:1,1,1", "--heel", "nan"}, "--heel"},
      {{"hull", "box:1,1,1", "--repair", "out.xyz"}, ".stl"},
      {{"hull", "box:1,1,1", "--triangles", "3"}, "--triangles"}};
  for (const auto& [arguments, reason] : cases) {
    const Outcome outcome = seaway(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments[1] << " " << outcome.out;
    EXPECT_NE(outcome.err.find(reason), std::string::npos) << outcome.err;
  }
}

}  // namespace
}  // namespace seaway::bridge::test
