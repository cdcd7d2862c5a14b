#include <geo_normalize.h>
#include <geotiff.h>
#include <geovalues.h>
#include <proj.h>
#include <xtiffio.h>

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <memory>
#include <string>

#include "sim_bridge/scene/height_picture.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

namespace fs = std::filesystem;

thread_local std::string lastTiffError;

/// libtiff tells errors to one handler of the process.
void noteTiffErrors() {
  static const bool once = [] {
    TIFFSetErrorHandler([](const char*, const char* format, std::va_list arguments) {
      char text[512];
      std::vsnprintf(text, sizeof text, format, arguments);
      lastTiffError = text;
    });
    TIFFSetWarningHandler(nullptr);
    return true;
  }();
  static_cast<void>(once);
  lastTiffError.clear();
}

struct TiffCloser {
  void operator()(TIFF* tiff) const { XTIFFClose(tiff); }
};
struct GeoCloser {
  void operator()(GTIF* keys) const { GTIFFree(keys); }
};
struct DefinitionCloser {
  void operator()(GTIFDefn* definition) const { GTIFFreeDefn(definition); }
};
struct TextCloser {
  void operator()(char* text) const { GTIFFreeMemory(text); }
};
struct ContextCloser {
  void operator()(PJ_CONTEXT* context) const { proj_context_destroy(context); }
};
struct ProjectionCloser {
  void operator()(PJ* projection) const { proj_destroy(projection); }
};

/// The file's own coordinates from WGS84; degrees, or the file's units, eastwards first.
class Projection {
 public:
  Projection(const std::string& crs, const std::string& file) : context_(proj_context_create()) {
    proj_log_level(context_.get(), PJ_LOG_NONE);
    const std::unique_ptr<PJ, ProjectionCloser> raw(
        proj_create_crs_to_crs(context_.get(), "EPSG:4326", crs.c_str(), nullptr));
    if (raw) forwards_.reset(proj_normalize_for_visualization(context_.get(), raw.get()));
    if (!forwards_) {
      throw InputError(file, 0, "PROJ cannot take its projection (" + crs + ") to WGS84");
    }
  }
  glm::dvec2 fileFromGeodetic(double latitude_deg, double longitude_deg) const {
    const PJ_COORD from = proj_coord(longitude_deg, latitude_deg, 0.0, HUGE_VAL);
    const PJ_COORD to = proj_trans(forwards_.get(), PJ_FWD, from);
    return {to.xy.x, to.xy.y};
  }
  GeodeticPosition geodeticFromFile(glm::dvec2 place) const {
    const PJ_COORD to =
        proj_trans(forwards_.get(), PJ_INV, proj_coord(place.x, place.y, 0.0, HUGE_VAL));
    return {to.xy.y, to.xy.x, 0.0};
  }

 private:
  std::unique_ptr<PJ_CONTEXT, ContextCloser> context_;
  std::unique_ptr<PJ, ProjectionCloser> forwards_;
};

/// One number of a row or tile as the file stores it.
float valueAt(const std::uint8_t* data, std::size_t i, int format, int bits) {
  const auto as = [&]<class T>(T) {
    T value;
    std::memcpy(&value, data + i * sizeof(T), sizeof(T));
    return static_cast<float>(value);
  };
  if (format == SAMPLEFORMAT_IEEEFP) return bits == 64 ? as(double{}) : as(float{});
  if (format == SAMPLEFORMAT_INT) {
    return bits == 8 ? as(std::int8_t{}) : bits == 16 ? as(std::int16_t{}) : as(std::int32_t{});
  }
  return bits == 8 ? as(std::uint8_t{}) : bits == 16 ? as(std::uint16_t{}) : as(std::uint32_t{});
}

class GeoTiffReader {
 public:
  explicit GeoTiffReader(const fs::path& path) : path_(path) {
    noteTiffErrors();
    tiff_.reset(XTIFFOpen(path.c_str(), "r"));
    if (!tiff_) fail("is neither a PNG nor a readable GeoTIFF: " + lastTiffError);
    std::uint32_t width = 0, height = 0;
    TIFFGetField(tiff_.get(), TIFFTAG_IMAGEWIDTH, &width);
    TIFFGetField(tiff_.get(), TIFFTAG_IMAGELENGTH, &height);
    requirePixels(path, width, height);
    size_ = {width, height};
    requireFormat();
  }

  HeightPicture read() {
    HeightPicture picture;
    picture.size = size_;
    picture.heights.resize(static_cast<std::size_t>(size_.x) * size_.y);
    if (TIFFIsTiled(tiff_.get())) {
      readTiles(picture.heights);
    } else {
      readRows(picture.heights);
    }
    dropNoData(picture.heights);
    place(picture);
    return picture;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(path_.string(), 0, what);
  }

  void requireFormat() {
    std::uint16_t bands = 1, format = SAMPLEFORMAT_UINT, bits = 1;
    TIFFGetFieldDefaulted(tiff_.get(), TIFFTAG_SAMPLESPERPIXEL, &bands);
    TIFFGetFieldDefaulted(tiff_.get(), TIFFTAG_SAMPLEFORMAT, &format);
    TIFFGetFieldDefaulted(tiff_.get(), TIFFTAG_BITSPERSAMPLE, &bits);
    if (bands != 1) fail("has " + std::to_string(bands) + " bands; must have one, of heights");
    const bool isFloat = format == SAMPLEFORMAT_IEEEFP && (bits == 32 || bits == 64);
    const bool isWhole = (format == SAMPLEFORMAT_INT || format == SAMPLEFORMAT_UINT) &&
                         (bits == 8 || bits == 16 || bits == 32);
    if (!isFloat && !isWhole) {
      fail("has samples of " + std::to_string(bits) +
           " bits of a kind that is not allowed; must be whole numbers of 8, 16 or 32 bits, or "
           "floats of 32 or 64");
    }
    format_ = format;
    bits_ = bits;
  }

  void readRows(std::vector<float>& heights) {
    std::vector<std::uint8_t> row(TIFFScanlineSize(tiff_.get()));
    for (int y = 0; y < size_.y; ++y) {
      if (TIFFReadScanline(tiff_.get(), row.data(), static_cast<std::uint32_t>(y)) != 1) {
        fail("cannot be read: " + lastTiffError);
      }
      for (int x = 0; x < size_.x; ++x) {
        heights[static_cast<std::size_t>(y) * size_.x + x] = valueAt(row.data(), x, format_, bits_);
      }
    }
  }

  void readTiles(std::vector<float>& heights) {
    std::uint32_t width = 0, height = 0;
    TIFFGetField(tiff_.get(), TIFFTAG_TILEWIDTH, &width);
    TIFFGetField(tiff_.get(), TIFFTAG_TILELENGTH, &height);
    std::vector<std::uint8_t> tile(TIFFTileSize(tiff_.get()));
    const int across = static_cast<int>(width), along = static_cast<int>(height);
    for (int top = 0; top < size_.y; top += along) {
      for (int left = 0; left < size_.x; left += across) {
        if (TIFFReadTile(tiff_.get(), tile.data(), static_cast<std::uint32_t>(left),
                         static_cast<std::uint32_t>(top), 0, 0) < 0) {
          fail("cannot be read: " + lastTiffError);
        }
        for (int y = top; y < std::min(top + along, size_.y); ++y) {
          for (int x = left; x < std::min(left + across, size_.x); ++x) {
            heights[static_cast<std::size_t>(y) * size_.x + x] =
                valueAt(tile.data(), static_cast<std::size_t>(y - top) * width + (x - left),
                        format_, bits_);
          }
        }
      }
    }
  }

  /// GDAL writes the value as text into a tag of its own, which libtiff does not know.
  void dropNoData(std::vector<float>& heights) {
    const char* text = nullptr;
    std::uint32_t length = 0;
    const TIFFField* field = TIFFFindField(tiff_.get(), TIFFTAG_GDAL_NODATA, TIFF_ANY);
    const bool given =
        field &&
        (TIFFFieldPassCount(field) ? TIFFGetField(tiff_.get(), TIFFTAG_GDAL_NODATA, &length, &text)
                                   : TIFFGetField(tiff_.get(), TIFFTAG_GDAL_NODATA, &text)) == 1;
    if (!given || !text) return;
    const auto none = static_cast<float>(std::strtod(text, nullptr));
    for (float& height : heights) {
      if (height == none) height = std::numeric_limits<float>::quiet_NaN();
    }
  }

  /// What PROJ calls the file's coordinates.
  std::string projectionName(GTIF& keys) const {
    const std::unique_ptr<GTIFDefn, DefinitionCloser> definition(GTIFAllocDefn());
    if (!GTIFGetDefn(&keys, definition.get())) {
      fail("does not say in which projection it is: it is no GeoTIFF");
    }
    const int code = definition->Model == ModelTypeGeographic ? definition->GCS : definition->PCS;
    if (code > 0 && code != KvUserDefined) return "EPSG:" + std::to_string(code);
    const std::unique_ptr<char, TextCloser> text(GTIFGetProj4Defn(definition.get()));
    if (!text || text.get()[0] == '\0') fail("does not say in which projection it is");
    return std::string(text.get()) + " +type=crs";
  }

  void place(HeightPicture& picture) {
    const std::unique_ptr<GTIF, GeoCloser> keys(GTIFNew(tiff_.get()));
    if (!keys) fail("has no geographic keys: it is no GeoTIFF");
    std::uint16_t raster = RasterPixelIsArea;
    GTIFKeyGetSHORT(keys.get(), GTRasterTypeGeoKey, &raster, 0, 1);
    const auto corner = [&](double x, double y) {
      glm::dvec2 at(x, y);
      if (!GTIFImageToPCS(keys.get(), &at.x, &at.y)) fail("does not say where its pixels lie");
      return at;
    };
    const double middle = raster == RasterPixelIsPoint ? 0.0 : 0.5;
    const glm::dvec2 first = corner(middle, middle);
    const glm::dmat2 filePerPixel(corner(middle + 1.0, middle) - first,
                                  corner(middle, middle + 1.0) - first);
    if (!(std::abs(glm::determinant(filePerPixel)) > 0.0)) fail("has pixels without area");
    const glm::dmat2 pixelPerFile = glm::inverse(filePerPixel);
    const auto projection =
        std::make_shared<const Projection>(projectionName(*keys), path_.string());
    picture.pixelFromGeodetic = [=](double latitude_deg, double longitude_deg) {
      return pixelPerFile * (projection->fileFromGeodetic(latitude_deg, longitude_deg) - first);
    };
    picture.geodeticFromPixel = [=](glm::dvec2 pixel) {
      return projection->geodeticFromFile(first + filePerPixel * pixel);
    };
    picture.least = glm::dvec2(-middle);
    picture.most = glm::dvec2(size_ - 1) + middle;
  }

  fs::path path_;
  std::unique_ptr<TIFF, TiffCloser> tiff_;
  glm::ivec2 size_{0};
  int format_ = SAMPLEFORMAT_UINT, bits_ = 8;
};

}  // namespace

HeightPicture readGeoTiffHeights(const fs::path& file) { return GeoTiffReader(file).read(); }

}  // namespace seaway::bridge
