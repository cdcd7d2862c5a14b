#include <png.h>

#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <memory>
#include <string>

#include "sim_bridge/scene/height_picture.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

namespace fs = std::filesystem;

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using OpenFile = std::unique_ptr<std::FILE, FileCloser>;

/// libpng's reading state. Its errors come back by longjmp: functions that call it own nothing.
class PngReader {
 public:
  explicit PngReader(const fs::path& path) : path_(path), file_(std::fopen(path.c_str(), "rb")) {
    if (!file_) fail("cannot be read");
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, &PngReader::noteError,
                                  [](png_structp, png_const_charp) {});
    info_ = png_ ? png_create_info_struct(png_) : nullptr;
    if (!info_) fail("cannot be read: no memory");
    png_init_io(png_, file_.get());
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  void readHeader() {
    if (!tryHeader()) fail("is not a readable PNG: " + message_);
    const int type = png_get_color_type(png_, info_);
    if (type != PNG_COLOR_TYPE_GRAY) {
      fail(
          "is not a plain grey PNG; a map of heights must be one, without colours or "
          "transparency");
    }
  }
  glm::ivec2 size() const {
    return {png_get_image_width(png_, info_), png_get_image_height(png_, info_)};
  }
  /// Grey values in [0, 1], from the upper left.
  std::vector<float> readValues() {
    const glm::ivec2 pixels = size();
    std::vector<std::uint16_t> values(static_cast<std::size_t>(pixels.x) * pixels.y);
    std::vector<png_bytep> rows(pixels.y);
    for (int y = 0; y < pixels.y; ++y) {
      rows[y] = reinterpret_cast<png_bytep>(&values[static_cast<std::size_t>(y) * pixels.x]);
    }
    if (!tryRows(rows.data())) fail("is not a readable PNG: " + message_);
    std::vector<float> result(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      result[i] = static_cast<float>(values[i]) / 65535.0f;
    }
    return result;
  }

 private:
  static void noteError(png_structp png, png_const_charp message) {
    static_cast<PngReader*>(png_get_error_ptr(png))->message_ = message;
    png_longjmp(png, 1);
  }
  bool tryHeader() {
    if (setjmp(png_jmpbuf(png_))) return false;
    png_read_info(png_, info_);
    return true;
  }
  bool tryRows(png_bytepp rows) {
    if (setjmp(png_jmpbuf(png_))) return false;
    png_set_expand_16(png_);  // 8 bits and fewer too: white is 65535
    png_set_swap(png_);       // to the machine's own order
    png_read_update_info(png_, info_);
    png_read_image(png_, rows);
    return true;
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(path_.string(), 0, what);
  }

  fs::path path_;
  OpenFile file_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::string message_;
};

/// Even in longitude and latitude; edges of the extent are outer edges of pixels.
void placeByExtent(const TerrainExtent& extent, HeightPicture& picture) {
  const double width = extent.east_deg - extent.west_deg;
  const glm::dvec2 perPixel((width > 0.0 ? width : width + 360.0) / picture.size.x,
                            (extent.north_deg - extent.south_deg) / picture.size.y);
  const double west = extent.west_deg, north = extent.north_deg;
  const double middle = west + 0.5 * perPixel.x * picture.size.x;
  picture.pixelFromGeodetic = [=](double latitude_deg, double longitude_deg) {
    const double east = middle + std::remainder(longitude_deg - middle, 360.0) - west;
    return glm::dvec2(east, north - latitude_deg) / perPixel - 0.5;
  };
  picture.geodeticFromPixel = [=](glm::dvec2 pixel) {
    const glm::dvec2 off = (pixel + 0.5) * perPixel;
    return GeodeticPosition{north - off.y, west + off.x, 0.0};
  };
}

/// Even in metres of the plane about its centre.
void placeByCentre(const Place& centre, glm::dvec2 size, HeightPicture& picture) {
  const Geodesy plane({centre.latitude_deg, centre.longitude_deg, 0.0});
  const glm::dvec2 perPixel = size / glm::dvec2(picture.size);
  const glm::dvec2 corner(-0.5 * size.x, 0.5 * size.y);
  picture.pixelFromGeodetic = [=](double latitude_deg, double longitude_deg) {
    const glm::dvec2 at = plane.seaPlaneFromGeodetic(latitude_deg, longitude_deg).position;
    return glm::dvec2(at.x - corner.x, corner.y - at.y) / perPixel - 0.5;
  };
  picture.geodeticFromPixel = [=](glm::dvec2 pixel) {
    const glm::dvec2 off = (pixel + 0.5) * perPixel;
    return plane.geodeticFromSeaPlane({corner.x + off.x, corner.y - off.y});
  };
}

}  // namespace

void requirePixels(const fs::path& file, std::size_t width, std::size_t height) {
  if (width > 0 && height > 0 && width <= HeightPicture::mostPixels / height) return;
  throw InputError(file.string(), 0,
                   "has " + std::to_string(width) + " x " + std::to_string(height) +
                       " pixels; 1 to " + std::to_string(HeightPicture::mostPixels) +
                       " in all are allowed (4096 x 4096)");
}

HeightPicture readPngHeights(const fs::path& file, const SceneTerrain& terrain) {
  PngReader reader(file);
  reader.readHeader();
  HeightPicture picture;
  picture.size = reader.size();
  requirePixels(file, picture.size.x, picture.size.y);
  picture.heights = reader.readValues();
  const glm::dvec2 heights = terrain.blackAndWhite;
  for (float& value : picture.heights) {
    value = static_cast<float>(heights.x + (heights.y - heights.x) * static_cast<double>(value));
  }
  picture.least = glm::dvec2(-0.5);
  picture.most = glm::dvec2(picture.size) - 0.5;
  if (terrain.extent) {
    placeByExtent(*terrain.extent, picture);
  } else {
    placeByCentre(*terrain.centre, terrain.size, picture);
  }
  return picture;
}

}  // namespace seaway::bridge
