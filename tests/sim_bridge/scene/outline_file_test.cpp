#include "sim_bridge/scene/outline_file.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene/sea.h"
#include "sim_bridge/simulation.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

using test::inputErrorOf;
using test::TempFolder;

std::string polygon(const std::string& rings) {
  return "{\"type\": \"Polygon\", \"coordinates\": " + rings + "}";
}

std::string faultOf(const std::string& text) {
  const TempFolder folder;
  const auto file = folder.write("lake.geojson", text);
  const std::string message = inputErrorOf([&] {
    loadOutline(file, Geodesy({42.0, -122.0, 0.0}));
  });
  const std::string prefix = folder.path().string() + "/";
  return message.rfind(prefix, 0) == 0 ? message.substr(prefix.size()) : message;
}

WaterOutline outlineOf(const std::string& text, const Geodesy& geodesy) {
  const TempFolder folder;
  return loadOutline(folder.write("lake.geojson", text), geodesy);
}

const std::string island =
    "[[[-122.1,41.9],[-121.9,41.9],[-121.9,42.1],[-122.1,42.1],[-122.1,41.9]],"
    "[[-122.01,41.99],[-121.99,41.99],[-121.99,42.01],[-122.01,42.01],[-122.01,41.99]]]";

TEST(OutlineFile, ReadsPolygonsWithHolesBareOrInFeatures) {
  const Geodesy geodesy({42.0, -122.0, 0.0});
  for (const std::string& text :
       {polygon(island),
        "{\"type\":\"Feature\",\"properties\":{},\"geometry\":" + polygon(island) + "}",
        "{\"type\":\"FeatureCollection\",\"features\":[{\"type\":\"Feature\",\"geometry\":" +
            polygon(island) + "}]}",
        "{\"type\":\"MultiPolygon\",\"coordinates\":[" + island + "]}"}) {
    const WaterOutline outline = outlineOf(text, geodesy);
    for (const auto& [latitude, longitude, wet] : {std::tuple{42.05, -122.05, true},
                                                   {42.0, -122.0, false},
                                                   {42.0999, -122.0999, true},
                                                   {42.1001, -122.0, false},
                                                   {42.0099, -122.0, false},
                                                   {42.0101, -122.0, true}}) {
      EXPECT_EQ(outline.contains(geodesy.seaPlaneFromGeodetic(latitude, longitude).position), wet)
          << latitude << ' ' << longitude;
    }
  }
}

TEST(OutlineFileHard, RingsMayCrossTheAntimeridianInEveryWayOfWritingIt) {
  const Geodesy geodesy({-17.0, 180.0, 0.0});
  const std::string unsplit =
      polygon("[[[179.9,-17.1],[-179.9,-17.1],[-179.9,-16.9],[179.9,-16.9],[179.9,-17.1]]]");
  const std::string beyond =
      polygon("[[[179.9,-17.1],[180.1,-17.1],[180.1,-16.9],[179.9,-16.9],[179.9,-17.1]]]");
  const std::string split =
      "{\"type\":\"MultiPolygon\",\"coordinates\":["
      "[[[179.9,-17.1],[180,-17.1],[180,-16.9],[179.9,-16.9],[179.9,-17.1]]],"
      "[[[-180,-17.1],[-179.9,-17.1],[-179.9,-16.9],[-180,-16.9],[-180,-17.1]]]]}";
  for (const std::string& text : {unsplit, beyond, split}) {
    const WaterOutline outline = outlineOf(text, geodesy);
    // 0.2° of latitude and of longitude at 17° S on WGS84: 22.13 km by 21.30 km.
    EXPECT_NEAR(outline.area(), 22131.0 * 21298.0, 0.001 * 22131.0 * 21298.0);
    for (const auto& [longitude, wet] : {std::pair{179.95, true},
                                         {-179.95, true},
                                         {179.999, true},
                                         {-179.89, false},
                                         {179.89, false},
                                         {0.0, false}}) {
      const SeaPlanePoint point = geodesy.seaPlaneFromGeodetic(-17.0, longitude);
      if (!point.inRange) continue;
      EXPECT_EQ(outline.contains(point.position), wet) << longitude;
    }
  }
}

TEST(OutlineFile, EdgesAreStraightInLongitudeAndLatitude) {
  // The parallel of 60° N curves in the sea plane: 14.9 km away from its own chord over 10°.
  const Geodesy geodesy({60.5, 0.0, 0.0});
  const WaterOutline outline =
      outlineOf(polygon("[[[-3,60],[3,60],[3,61],[-3,61],[-3,60]]]"), geodesy);
  for (const double longitude : {-2.9, -1.5, 0.0, 0.004, 1.5, 2.9}) {
    EXPECT_TRUE(outline.contains(geodesy.seaPlaneFromGeodetic(60.000003, longitude).position));
    EXPECT_FALSE(outline.contains(geodesy.seaPlaneFromGeodetic(59.999997, longitude).position));
  }
}

TEST(OutlineFile, FaultsNameFileKeyAndWhatIsAllowed) {
  EXPECT_EQ(faultOf("{").rfind("lake.geojson: is not JSON", 0), 0u);
  EXPECT_EQ(faultOf("{}"), "lake.geojson: lacks 'type'");
  EXPECT_EQ(faultOf("{\"type\":\"Point\"}"),
            "lake.geojson: key 'type': \"Point\" is not allowed; must be one of: Polygon, "
            "MultiPolygon, Feature, FeatureCollection");
  EXPECT_EQ(faultOf("{\"type\":\"Polygon\"}"), "lake.geojson: lacks 'coordinates'");
  EXPECT_EQ(faultOf(polygon("[[[0,0],[1,0],[0,0]]]")),
            "lake.geojson: key 'coordinates[0]': must be a list of 4 or more positions");
  EXPECT_EQ(faultOf(polygon("[[[-122,42],[-121.9,42],[-121.9,42.1],[-122,42.1]]]")),
            "lake.geojson: key 'coordinates[0]': is not closed: its last position must be its "
            "first");
  EXPECT_EQ(faultOf(polygon("[[[-122,42],[-121.9,92],[-121.9,42.1],[-122,42]]]")),
            "lake.geojson: key 'coordinates[0][1][1]': 92 is not allowed; must be in [-90, 90] ° "
            "(longitude, then latitude)");
  EXPECT_EQ(faultOf(polygon("[[[-122,42],[\"x\",42],[-121.9,42.1],[-122,42]]]")),
            "lake.geojson: key 'coordinates[0][1][0]': \"x\" is not a number");
  EXPECT_EQ(
      faultOf(polygon("[[[0,42],[0.1,42],[0.1,42.1],[0,42]]]")),
      "lake.geojson: key 'coordinates[0][1]': is farther than 500 km from the scene's anchor");
  EXPECT_EQ(faultOf(polygon("[[[-122,42],[-122,42],[-121.9,42],[-122,42]]]"))
                .rfind("lake.geojson: key 'coordinates': ring 0: has", 0),
            0u);
  EXPECT_EQ(faultOf(polygon("[[[-122,42],[-121.9,42.1],[-121.9,42],[-122,42.05],[-122,42]]]")),
            "lake.geojson: key 'coordinates': its edges cross each other");
}

/// A lake of 0.01° each way around the test scene's launch.
std::string testLake() {
  return polygon(
      "[[[-78.472,28.873],[-78.462,28.873],[-78.462,28.883],[-78.472,28.883],"
      "[-78.472,28.873]]]");
}

Scene lakeScene(const TempFolder& folder,
                std::vector<std::pair<std::string, std::string>> replacements = {}) {
  folder.write("lake.geojson", testLake());
  replacements.emplace_back("seed: 7", "seed: 7\n  outline: lake.geojson");
  return loadScene(test::writeScene(folder, replacements));
}

TEST(OutlineFile, ASceneWithAnOutlineHasWaterInsideAlone) {
  const TempFolder folder;
  const Sea sea = buildSea(lakeScene(folder));
  EXPECT_TRUE(std::isfinite(sea.surface.sample({0.0, 0.0}, 1.0).height));
  EXPECT_TRUE(has(sea.surface.sample({700.0, 0.0}, 1.0).status, SampleStatus::dry));
  EXPECT_NEAR(realisedSignificantWaveHeight(sea.surface), 1.12, 0.02 * 1.12);
}

TEST(OutlineFile, TheOutlineCanBeSwitchedOff) {
  const TempFolder folder;
  const Sea sea = buildSea(lakeScene(folder, {{"run:", "effects: {outline: off}\nrun:"}}));
  EXPECT_EQ(sea.surface.outline(), nullptr);
  EXPECT_TRUE(std::isfinite(sea.surface.sample({700.0, 0.0}, 1.0).height));
}

TEST(OutlineFile, AMissingFileIsNamed) {
  const TempFolder folder;
  const auto file = test::writeScene(folder, {{"seed: 7", "seed: 7\n  outline: none.geojson"}});
  EXPECT_NE(inputErrorOf([&] { loadScene(file); }).find("key 'sea.outline': no such file"),
            std::string::npos);
}

TEST(OutlineFile, AVesselThatRunsAshoreIsReported) {
  const TempFolder folder;
  const Scene scene = lakeScene(folder);
  const Sea sea = buildSea(scene);
  EXPECT_NO_THROW(Simulation::replayed(scene, sea, 2.0));
  // 550 m to the shore ahead, less half its length, at 6 m/s.
  const std::string message = inputErrorOf([&] { Simulation::replayed(scene, sea, 200.0); });
  EXPECT_NE(message.find("vessel 'launch' is aground at"), std::string::npos) << message;
  EXPECT_NE(message.find("outside the sea's outline"), std::string::npos) << message;
}

}  // namespace
}  // namespace seaway::bridge
