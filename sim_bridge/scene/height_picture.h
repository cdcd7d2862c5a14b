#pragma once

#include <filesystem>
#include <functional>
#include <glm/vec2.hpp>
#include <vector>

#include "sim_bridge/scene/scene_terrain.h"
#include "surface/geodesy.h"

namespace seaway::bridge {

/// A file's heights as they stand in it, and where its pixels lie. Pixel (0, 0) is the middle of
/// the one in the north-west, x counts eastwards, y southwards.
struct HeightPicture {
  /// Most pixels of a file.
  static constexpr std::size_t mostPixels = std::size_t{4096} * 4096;

  glm::ivec2 size{0};
  std::vector<float> heights;        ///< m above the file's datum; NaN where there is none
  glm::dvec2 least{0.0}, most{0.0};  ///< corners of what they cover, in pixels
  std::function<glm::dvec2(double latitude_deg, double longitude_deg)> pixelFromGeodetic;
  std::function<GeodeticPosition(glm::dvec2 pixel)> geodeticFromPixel;
};

/// Reads a grey PNG of 1 to 16 bits, whose place and heights `terrain` gives. Throws InputError,
/// naming the file.
HeightPicture readPngHeights(const std::filesystem::path& file, const SceneTerrain& terrain);

/// Reads a GeoTIFF of one band of whole numbers or floats, in any projection that PROJ takes to
/// WGS84. GDAL's no-data value and NaN are no data. Throws InputError, naming the file.
HeightPicture readGeoTiffHeights(const std::filesystem::path& file);

/// Throws InputError where a file has no pixels or too many.
void requirePixels(const std::filesystem::path& file, std::size_t width, std::size_t height);

}  // namespace seaway::bridge
