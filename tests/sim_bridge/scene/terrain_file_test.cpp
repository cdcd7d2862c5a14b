#include "sim_bridge/scene/terrain_file.h"

#include <geo_normalize.h>
#include <geotiff.h>
#include <geovalues.h>
#include <gtest/gtest.h>
#include <png.h>
#include <xtiffio.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <type_traits>

#include "sim_bridge/scene/height_picture.h"
#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene/sea.h"
#include "sim_bridge/simulation.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

namespace fs = std::filesystem;

using test::inputErrorOf;
using test::TempFolder;

/// A grey PNG of 16 or 8 bits; `value` in [0, 1] from the upper left.
void writePng(const fs::path& file, glm::ivec2 size, const std::function<double(int, int)>& value,
              int bits = 16, int type = PNG_COLOR_TYPE_GRAY) {
  std::FILE* stream = std::fopen(file.c_str(), "wb");
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, stream);
  png_set_IHDR(png, info, size.x, size.y, bits, type, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  const int channels = type == PNG_COLOR_TYPE_RGB ? 3 : 1;
  std::vector<png_byte> row(static_cast<std::size_t>(size.x) * channels * bits / 8);
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x * channels; ++x) {
      const auto grey = static_cast<unsigned>(std::lround(value(x, y) * ((1 << bits) - 1)));
      if (bits == 16) {
        row[2 * x] = static_cast<png_byte>(grey >> 8);
        row[2 * x + 1] = static_cast<png_byte>(grey & 255);
      } else {
        row[x] = static_cast<png_byte>(grey);
      }
    }
    png_write_row(png, row.data());
  }
  png_write_end(png, nullptr);
  png_destroy_write_struct(&png, &info);
  std::fclose(stream);
}

struct TiffPlace {
  int code = 4326;  ///< EPSG
  glm::dvec2 corner{0.0}, perPixel{1.0};
  const char* noData = nullptr;
  int tile = 0;  ///< pixels a side; 0: strips of rows
  int bands = 1;
};

/// A GeoTIFF, its upper left corner at `corner`.
template <class Number = float>
void writeGeoTiff(const fs::path& file, glm::ivec2 size, const TiffPlace& place,
                  const std::function<std::type_identity_t<Number>(int, int)>& value) {
  TIFF* tiff = XTIFFOpen(file.c_str(), "w");
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, size.x);
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, size.y);
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, place.bands);
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, int{8 * sizeof(Number)});
  TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT,
               std::is_floating_point_v<Number> ? SAMPLEFORMAT_IEEEFP
               : std::is_signed_v<Number>       ? SAMPLEFORMAT_INT
                                                : SAMPLEFORMAT_UINT);
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  if (place.tile > 0) {
    TIFFSetField(tiff, TIFFTAG_TILEWIDTH, place.tile);
    TIFFSetField(tiff, TIFFTAG_TILELENGTH, place.tile);
  } else {
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 4);
  }
  if (place.noData) {
    static const TIFFFieldInfo info{
        TIFFTAG_GDAL_NODATA, -1, -1, TIFF_ASCII,
        FIELD_CUSTOM,        1,  0,  const_cast<char*>("GDALNoDataValue")};
    TIFFMergeFieldInfo(tiff, &info, 1);
    TIFFSetField(tiff, TIFFTAG_GDAL_NODATA, place.noData);
  }
  const double tie[6] = {0.0, 0.0, 0.0, place.corner.x, place.corner.y, 0.0};
  const double scale[3] = {place.perPixel.x, place.perPixel.y, 0.0};
  TIFFSetField(tiff, TIFFTAG_GEOTIEPOINTS, 6, tie);
  TIFFSetField(tiff, TIFFTAG_GEOPIXELSCALE, 3, scale);
  GTIF* keys = GTIFNew(tiff);
  const bool degrees = place.code == 4326;
  GTIFKeySet(keys, GTModelTypeGeoKey, TYPE_SHORT, 1,
             degrees ? ModelTypeGeographic : ModelTypeProjected);
  GTIFKeySet(keys, GTRasterTypeGeoKey, TYPE_SHORT, 1, RasterPixelIsArea);
  GTIFKeySet(keys, degrees ? GeographicTypeGeoKey : ProjectedCSTypeGeoKey, TYPE_SHORT, 1,
             place.code);
  GTIFWriteKeys(keys);
  GTIFFree(keys);
  if (place.tile > 0) {
    std::vector<Number> tile(static_cast<std::size_t>(place.tile) * place.tile);
    for (int top = 0; top < size.y; top += place.tile) {
      for (int left = 0; left < size.x; left += place.tile) {
        for (std::size_t i = 0; i < tile.size(); ++i) {
          tile[i] = value(left + static_cast<int>(i) % place.tile,
                          top + static_cast<int>(i) / place.tile);
        }
        TIFFWriteTile(tiff, tile.data(), left, top, 0, 0);
      }
    }
  } else {
    std::vector<Number> row(static_cast<std::size_t>(size.x) * place.bands);
    for (int y = 0; y < size.y; ++y) {
      for (int x = 0; x < size.x; ++x) row[x] = value(x, y);
      TIFFWriteScanline(tiff, row.data(), y, 0);
    }
  }
  XTIFFClose(tiff);
}

const Geodesy anchor({28.878, -78.467, 0.0});

SceneTerrain aroundAnchor(glm::dvec2 size, glm::dvec2 heights) {
  SceneTerrain terrain;
  terrain.centre = Place{28.878, -78.467};
  terrain.size = size;
  terrain.blackAndWhite = heights;
  return terrain;
}

TEST(TerrainFile, PngsOfEightAndSixteenBitsGiveTheHeightsAtBlackAndWhite) {
  const TempFolder folder;
  for (const int bits : {8, 16}) {
    // Rises eastwards and falls southwards.
    writePng(
        folder / "map.png", {64, 32}, [](int x, int y) { return (x + 31 - y) / 94.0; }, bits);
    const TerrainMap map =
        loadTerrain(aroundAnchor({6400.0, 3200.0}, {-10.0, 84.0}), folder / "map.png", anchor, 0.0);
    // Pixel x, y lies at (100 x − 3150, 1550 − 100 y).
    const double step = 94.0 / ((1 << bits) - 1);  // of a grey level, m
    for (const glm::dvec2 pixel : {glm::dvec2(0.0), {63.0, 31.0}, {20.0, 5.0}, {31.5, 15.5}}) {
      const glm::dvec2 place(100.0 * pixel.x - 3150.0, 1550.0 - 100.0 * pixel.y);
      // Resampled between pixels; at the edges heights are held for half a pixel.
      EXPECT_NEAR(map.heightAt(place), -10.0 + pixel.x + 31.0 - pixel.y, 0.6 * step + 0.5);
    }
    EXPECT_NEAR(map.heightAt({0.0, 0.0}), -10.0 + 31.5 + 15.5, 0.6 * step + 1e-3);
    EXPECT_TRUE(std::isinf(map.heightAt({3201.0, 0.0})));
    EXPECT_TRUE(std::isfinite(map.heightAt({3199.0, 0.0})));
  }
}

TEST(TerrainFile, ExtentsPlacePixelsByLongitudeAndLatitudeAcrossTheAntimeridianToo) {
  const TempFolder folder;
  writePng(folder / "map.png", {64, 64}, [](int x, int) { return x / 63.0; });
  SceneTerrain terrain;
  terrain.extent = TerrainExtent{179.9, -179.9, -17.1, -16.9};
  terrain.blackAndWhite = {0.0, 63.0};
  const Geodesy geodesy({-17.0, 180.0, 0.0});
  const TerrainMap map = loadTerrain(terrain, folder / "map.png", geodesy, 0.0);
  for (const double longitude : {179.93, -179.97, 180.0}) {
    const double east = std::remainder(longitude - 179.9, 360.0);
    const glm::dvec2 place = geodesy.seaPlaneFromGeodetic(-16.97, longitude).position;
    // A pixel in 0.02, as the header says.
    EXPECT_NEAR(map.heightAt(place), east / 0.2 * 64.0 - 0.5, 0.02);
  }
}

TEST(TerrainFile, GeoTiffsInDegreesAndInUtmGiveTheSameHeights) {
  const TempFolder folder;
  const auto slope = [](double latitude, double longitude) {
    return 400.0 * (latitude - 28.878) - 300.0 * (longitude + 78.467);
  };
  const double degree = 0.001;
  writeGeoTiff(
      folder / "degrees.tif", {80, 80}, {4326, {-78.507, 28.918}, glm::dvec2(degree), nullptr},
      [&](int x, int y) {
        return static_cast<float>(slope(28.918 - (y + 0.5) * degree, -78.507 + (x + 0.5) * degree));
      });
  const TerrainMap map = loadTerrain({}, folder / "degrees.tif", anchor, 3.0);
  for (const glm::dvec2 off : {glm::dvec2(0.0, 0.0), {0.02, -0.03}, {-0.03, 0.01}}) {
    const glm::dvec2 at = anchor.seaPlaneFromGeodetic(28.878 + off.x, -78.467 + off.y).position;
    // 3 m of water level; a hundredth of a pixel's 0.4 m.
    EXPECT_NEAR(map.heightAt(at), slope(28.878 + off.x, -78.467 + off.y) - 3.0, 0.01);
  }
  // UTM zone 17 N: the anchor lies at 747 012 m east and 3 197 050 m north of its origin, about;
  // heights there are told by eastings alone.
  writeGeoTiff(folder / "utm.tif", {100, 100}, {32617, {742000.0, 3202000.0}, glm::dvec2(100.0)},
               [](int x, int) { return static_cast<float>(x); });
  const TerrainMap utm = loadTerrain({}, folder / "utm.tif", anchor, 0.0);
  const double slopeAcross = (utm.heightAt({500.0, 0.0}) - utm.heightAt({-500.0, 0.0})) / 1000.0;
  EXPECT_NEAR(slopeAcross, 0.01, 1e-4);  // a metre a pixel of 100 m, scale and turn aside
  EXPECT_NEAR(utm.heightAt({0.0, 0.0}), 50.0, 2.0);
}

/// The same map stored as other numbers gives the same heights, to the bit.
template <class Number>
void expectSameHeights(const TempFolder& folder, const TerrainMap& map, const TiffPlace& place) {
  writeGeoTiff<Number>(folder / "other.tif", {80, 72}, place,
                       [](int x, int y) { return static_cast<Number>((7 * x + 3 * y) % 101); });
  const TerrainMap other = loadTerrain({}, folder / "other.tif", anchor, 0.0);
  for (int i = 0; i < 400; ++i) {
    const glm::dvec2 at(-3500.0 + 350.0 * (i % 20), -3200.0 + 320.0 * (i / 20));
    ASSERT_EQ(other.heightAt(at), map.heightAt(at)) << at.x << ' ' << at.y;
  }
}

TEST(TerrainFile, TilesAndEveryKindOfNumberGiveTheSameHeights) {
  const TempFolder folder;
  TiffPlace place{4326, {-78.507, 28.914}, glm::dvec2(0.001), nullptr};
  writeGeoTiff(folder / "rows.tif", {80, 72}, place,
               [](int x, int y) { return static_cast<float>((7 * x + 3 * y) % 101); });
  const TerrainMap map = loadTerrain({}, folder / "rows.tif", anchor, 0.0);
  EXPECT_GT(map.heightAt({0.0, 0.0}), 0.0);
  place.tile = 32;  // those at two borders are cut off
  expectSameHeights<float>(folder, map, place);
  expectSameHeights<double>(folder, map, place);
  expectSameHeights<std::int8_t>(folder, map, place);
  expectSameHeights<std::int16_t>(folder, map, place);
  expectSameHeights<std::int32_t>(folder, map, place);
  place.tile = 0;
  expectSameHeights<std::uint8_t>(folder, map, place);
  expectSameHeights<std::uint16_t>(folder, map, place);
  expectSameHeights<std::uint32_t>(folder, map, place);
}

TEST(TerrainFileHard, TwoBandsAndNumbersOfAnotherKindAreRefused) {
  const TempFolder folder;
  TiffPlace place{4326, {-78.507, 28.914}, glm::dvec2(0.001), nullptr};
  const auto fault = [&] {
    return inputErrorOf([&] { loadTerrain({}, folder / "map.tif", anchor, 0.0); });
  };
  writeGeoTiff<std::int64_t>(folder / "map.tif", {8, 8}, place, [](int, int) { return 1; });
  EXPECT_NE(fault().find("samples of 64 bits"), std::string::npos) << fault();
  place.bands = 2;
  writeGeoTiff(folder / "map.tif", {8, 8}, place, [](int, int) { return 1.0f; });
  EXPECT_NE(fault().find("has 2 bands; must have one"), std::string::npos) << fault();
}

TEST(TerrainFile, NoDataIsFilledBelowTheWaterOrAsTheSceneSays) {
  const TempFolder folder;
  writeGeoTiff(folder / "map.tif", {32, 32}, {4326, {-78.483, 28.894}, glm::dvec2(0.001), "-9999"},
               [](int x, int y) { return x < 16   ? -9999.0f
                                         : y < 16 ? NAN
                                                  : 7.0f; });
  const auto at = [](const TerrainMap& map, double north, double east) {
    return map.heightAt(anchor.seaPlaneFromGeodetic(28.878 + north, -78.467 + east).position);
  };
  const TerrainMap map = loadTerrain({}, folder / "map.tif", anchor, 0.0);
  EXPECT_NEAR(at(map, -0.008, 0.008), 7.0, 1e-5);
  EXPECT_NEAR(at(map, -0.008, -0.008), -20.0, 1e-5);
  EXPECT_NEAR(at(map, 0.008, 0.008), -20.0, 1e-5);
  SceneTerrain told;
  told.noData = -3.5;
  EXPECT_NEAR(at(loadTerrain(told, folder / "map.tif", anchor, 0.0), -0.008, -0.008), -3.5, 1e-5);
}

std::string faultOf(const TempFolder& folder, const std::string& keys) {
  const fs::path scene =
      test::writeScene(folder, {{"vessels:\n", "terrain: {" + keys + "}\nvessels:\n"}});
  const std::string message = inputErrorOf([&] { loadScene(scene); });
  const std::string prefix = folder.path().string() + "/";
  return message.rfind(prefix, 0) == 0 ? message.substr(prefix.size()) : message;
}

TEST(TerrainFile, FaultsNameFileLineKeyAndWhatIsAllowed) {
  const TempFolder folder;
  writePng(folder / "map.png", {8, 8}, [](int, int) { return 0.5; });
  writePng(
      folder / "colour.png", {8, 8}, [](int, int) { return 0.5; }, 8, PNG_COLOR_TYPE_RGB);
  folder.write("text.tif", "not a picture");
  writeGeoTiff(folder / "map.tif", {8, 8}, {4326, {-78.471, 28.882}, glm::dvec2(0.001)},
               [](int, int) { return 1.0f; });
  writeGeoTiff(folder / "far.tif", {8, 8}, {4326, {-77.0, 28.882}, glm::dvec2(0.001)},
               [](int, int) { return 1.0f; });
  writeGeoTiff(folder / "high.tif", {8, 8}, {4326, {-78.471, 28.882}, glm::dvec2(0.001)},
               [](int x, int y) { return x == 3 && y == 2 ? 1e6f : 1.0f; });
  writeGeoTiff(folder / "empty.tif", {8, 8}, {4326, {-78.471, 28.882}, glm::dvec2(0.001)},
               [](int, int) { return NAN; });
  const std::string centre = "centre: {latitude_deg: 28.878, longitude_deg: -78.467}, ";
  const auto expect = [&](const std::string& keys, const std::string& wanted) {
    const std::string fault = faultOf(folder, keys);
    EXPECT_NE(fault.find(wanted), std::string::npos) << keys << "\n" << fault;
  };
  EXPECT_EQ(faultOf(folder, "file: map.png, " + centre + "size_m: [900, 900], height_m: [-9, 9]"),
            "");
  expect("file: none.png", "scene.yaml:10: key 'terrain.file': no such file: ");
  expect("file: map.png", "scene.yaml:10: key 'terrain': a PNG needs exactly one of extent and");
  expect("file: map.png, " + centre + "height_m: [0, 1]", "a PNG about a centre needs its size");
  expect("file: map.png, " + centre + "size_m: [9, 9]", "a PNG needs height_m");
  expect("file: map.tif, height_m: [0, 1]", "key 'terrain.height_m': is for a PNG only");
  expect(
      "file: map.png, height_m: [0, 1], extent: {west_deg: -78, east_deg: -79, south_deg: 28, "
      "north_deg: 29}",
      "key 'terrain.extent': is inverted");
  expect(
      "file: map.png, height_m: [0, 1], extent: {west_deg: -79, east_deg: -78, south_deg: 29, "
      "north_deg: 28}",
      "key 'terrain.extent': is upside down");
  expect("file: colour.png, " + centre + "size_m: [900, 900], height_m: [0, 1]",
         "colour.png: is not a plain grey PNG");
  expect("file: text.tif", "text.tif: is neither a PNG nor a readable GeoTIFF");
  expect("file: far.tif", "far.tif: does not cover the scene's anchor: it begins 143 km from it");
  expect("file: high.tif", "high.tif: the height in column 3 of row 2 is 1e+06 m; must be in");
  expect("file: empty.tif", "empty.tif: has no heights: all of it is no data");
  expect("file: map.tif, colour: {sand: [2, 0, 0]}", "key 'terrain.colour.sand");
}

TEST(TerrainFileHard, OnePixelIsFlatGroundAndTooManyAreRefused) {
  const TempFolder folder;
  writePng(folder / "one.png", {1, 1}, [](int, int) { return 1.0; });
  const TerrainMap map =
      loadTerrain(aroundAnchor({200.0, 100.0}, {0.0, 4.0}), folder / "one.png", anchor, 1.0);
  for (const glm::dvec2 place : {glm::dvec2(0.0), {99.0, 49.0}, {-99.0, -49.0}}) {
    EXPECT_NEAR(map.heightAt(place), 3.0, 1e-6);
  }
  const std::string fault = inputErrorOf([&] { requirePixels("map.png", 8192, 8192); });
  EXPECT_NE(fault.find("has 8192 x 8192 pixels; 1 to 16777216 in all are allowed (4096 x 4096)"),
            std::string::npos)
      << fault;
}

TEST(TerrainFileHard, CutOffAndEmptyFilesAreRefused) {
  const TempFolder folder;
  writePng(folder / "map.png", {64, 64}, [](int x, int y) { return (x * y % 61) / 60.0; });
  const std::string whole = test::readFile(folder / "map.png");
  for (const std::size_t length : {std::size_t{8}, std::size_t{30}, whole.size() / 2}) {
    const fs::path part = folder.write("part.png", whole.substr(0, length));
    const std::string fault = inputErrorOf([&] {
      loadTerrain(aroundAnchor({9.0, 9.0}, {0.0, 1.0}), part, anchor, 0.0);
    });
    EXPECT_NE(fault.find("is not a readable PNG"), std::string::npos) << length << fault;
  }
  const fs::path empty = folder.write("empty.tif", "");
  EXPECT_NE(inputErrorOf([&] { loadTerrain({}, empty, anchor, 0.0); }), "");
}

/// The test scene about a beach that rises eastwards by 1 m in 10, its shore 40 m east of the
/// anchor.
Scene beachScene(const TempFolder& folder,
                 std::vector<std::pair<std::string, std::string>> replacements = {}) {
  writePng(folder / "map.png", {65, 65}, [](int x, int) { return x / 64.0; });
  replacements.emplace_back("vessels:\n",
                            "terrain: {file: map.png, centre: {latitude_deg: 28.878, "
                            "longitude_deg: -78.467}, size_m: [1300, 1300], "
                            "height_m: [-68, 60]}\nvessels:\n");
  replacements.emplace_back("hm0_m: 1.12", "hm0_m: 0.1");
  return loadScene(test::writeScene(folder, replacements));
}

TEST(TerrainInScenes, VesselsRunAgroundWithAMessage) {
  const TempFolder folder;
  const Scene scene = beachScene(
      folder, {{"heading_deg: 30", "heading_deg: 90"}, {"turn_deg_s: 1", "turn_deg_s: 0"}});
  const Sea sea = buildSea(scene);
  Simulation simulation(scene, sea, nullptr);
  const std::string fault = inputErrorOf([&] {
    while (simulation.time() < 60.0) simulation.step();
  });
  EXPECT_NE(fault.find("vessel 'launch' is aground at "), std::string::npos) << fault;
  EXPECT_NE(fault.find("the terrain under it stands "), std::string::npos) << fault;
  EXPECT_GT(simulation.time(), 1.0);  // the bow is 6 m ahead, the shore 40
  EXPECT_LT(simulation.time(), 40.0 / 6.0);
}

TEST(TerrainInScenesHard, AVesselThatStartsAgroundSaysSo) {
  const TempFolder folder;
  const Scene scene = beachScene(
      folder, {{"longitude_deg: -78.467, heading_deg", "longitude_deg: -78.4660, heading_deg"}});
  const Sea sea = buildSea(scene);
  const std::string fault = inputErrorOf([&] { Simulation simulation(scene, sea, nullptr); });
  EXPECT_NE(fault.find("vessel 'launch' is aground at 0"), std::string::npos) << fault;
}

TEST(TerrainInScenes, SwitchedOffThereIsNoGround) {
  const TempFolder folder;
  const Scene scene = beachScene(folder, {{"run: {", "effects: {terrain: off}\nrun: {"}});
  EXPECT_NE(scene.terrain.map, nullptr);
  EXPECT_EQ(buildSea(scene).surface.terrain(), nullptr);
}

}  // namespace
}  // namespace seaway::bridge
