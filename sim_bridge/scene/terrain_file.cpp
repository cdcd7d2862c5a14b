#include "sim_bridge/scene/terrain_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <fstream>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

#include "sim_bridge/output/number_text.h"
#include "sim_bridge/scene/height_picture.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

namespace fs = std::filesystem;

constexpr double farthestFromAnchor = 100e3;  // m: beyond, places have been mixed up
constexpr double tallest = 12000.0;           // m
constexpr double underNoData = 20.0;          // m below the still water
constexpr int largestBlock = 256;             // cells
constexpr int nodesPerKnot = 8;
constexpr int partsPerEdge = 64;

[[noreturn]] void fail(const fs::path& file, const std::string& what) {
  throw InputError(file.string(), 0, what);
}

/// Heights above the still water, without gaps.
void settle(HeightPicture& picture, const SceneTerrain& terrain, const fs::path& file,
            double waterLevel) {
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < picture.heights.size(); ++i) {
    float& height = picture.heights[i];
    if (std::isnan(height)) continue;
    if (!(std::abs(height) <= tallest)) {
      fail(file, "the height in column " + std::to_string(i % picture.size.x) + " of row " +
                     std::to_string(i / picture.size.x) + " is " + numberText(height) +
                     " m; must be in [-12000, 12000] m");
    }
    height = static_cast<float>(height - waterLevel);
    lowest = std::min(lowest, static_cast<double>(height));
  }
  if (std::isinf(lowest)) fail(file, "has no heights: all of it is no data");
  const double none =
      terrain.noData ? *terrain.noData - waterLevel : std::min(-underNoData, lowest);
  for (float& height : picture.heights) {
    if (std::isnan(height)) height = static_cast<float>(none);
  }
}

struct Box {
  glm::dvec2 least, most;
};

/// The largest upright rectangle within the file's edges in the sea plane: an edge is where all of
/// that edge is within.
Box boxOf(const HeightPicture& picture, const Geodesy& geodesy, const fs::path& file) {
  const auto place = [&](double x, double y) {
    const GeodeticPosition at = picture.geodeticFromPixel({x, y});
    const SeaPlanePoint point = geodesy.seaPlaneFromGeodetic(at.latitude_deg, at.longitude_deg);
    if (!point.inRange) {
      fail(file, "a corner or edge of it is farther than " +
                     numberText(Geodesy::usableRange() / 1000.0) + " km from the scene's anchor");
    }
    return point.position;
  };
  constexpr double far = 1e9;
  Box box{glm::dvec2(-far), glm::dvec2(far)};
  for (int i = 0; i <= partsPerEdge; ++i) {
    const glm::dvec2 at = glm::mix(picture.least, picture.most, i / double(partsPerEdge));
    box.least.x = std::max(box.least.x, place(picture.least.x, at.y).x);
    box.most.x = std::min(box.most.x, place(picture.most.x, at.y).x);
    box.most.y = std::min(box.most.y, place(at.x, picture.least.y).y);
    box.least.y = std::max(box.least.y, place(at.x, picture.most.y).y);
  }
  if (!(box.least.x < box.most.x && box.least.y < box.most.y)) {
    fail(file,
         "covers no upright rectangle of the sea plane: its rows must run about eastwards "
         "and its columns southwards");
  }
  const glm::dvec2 nearest = glm::clamp(glm::dvec2(0.0), box.least, box.most);
  if (glm::length(nearest) > farthestFromAnchor) {
    fail(file, "does not cover the scene's anchor: it begins " +
                   numberText(std::round(glm::length(nearest) / 1000.0)) + " km from it, " +
                   numberText(farthestFromAnchor / 1000.0) +
                   " km are allowed (are its latitudes and longitudes right?)");
  }
  return box;
}

/// Linear between pixels' middles; those of the edge hold beyond them.
float heightAt(const HeightPicture& picture, glm::dvec2 pixel) {
  const glm::dvec2 held = glm::clamp(pixel, glm::dvec2(0.0), glm::dvec2(picture.size - 1));
  const glm::ivec2 from = glm::min(glm::ivec2(held), glm::max(picture.size - 2, 0));
  const glm::ivec2 to = glm::min(from + 1, picture.size - 1);
  const glm::dvec2 part = held - glm::dvec2(from);
  const auto at = [&](int x, int y) {
    return static_cast<double>(picture.heights[static_cast<std::size_t>(y) * picture.size.x + x]);
  };
  return static_cast<float>(glm::mix(glm::mix(at(from.x, from.y), at(to.x, from.y), part.x),
                                     glm::mix(at(from.x, to.y), at(to.x, to.y), part.x), part.y));
}

/// Cells of a grid along its sides: whole blocks of 2ⁿ, at most a sixteenth more or fewer than the
/// file has pixels.
glm::ivec2 cellsFor(glm::ivec2 pixels) {
  const auto least = static_cast<unsigned>(std::max(1, std::min(pixels.x, pixels.y) / 8));
  const int block = std::min(static_cast<int>(std::bit_floor(least)), largestBlock);
  const auto whole = [&](int count) { return std::max(1, (count + block / 2) / block) * block; };
  return {whole(pixels.x), whole(pixels.y)};
}

/// Pixels at knots of the grid, from which those of all its nodes follow: geodesics are slow.
class PixelsOfNodes {
 public:
  PixelsOfNodes(const TerrainMap::Grid& grid, const HeightPicture& picture, const Geodesy& geodesy)
      : count_((grid.count + nodesPerKnot - 2) / nodesPerKnot + 1) {
    for (int row = 0; row < count_.y; ++row) {
      for (int column = 0; column < count_.x; ++column) {
        const glm::dvec2 node = glm::dvec2(column, row) * double(nodesPerKnot);
        const GeodeticPosition at = geodesy.geodeticFromSeaPlane(grid.origin + node * grid.spacing);
        knots_.push_back(picture.pixelFromGeodetic(at.latitude_deg, at.longitude_deg));
      }
    }
  }
  glm::dvec2 at(int column, int row) const {
    const glm::ivec2 knot(std::min(column / nodesPerKnot, count_.x - 2),
                          std::min(row / nodesPerKnot, count_.y - 2));
    const glm::dvec2 part = glm::dvec2(column, row) / double(nodesPerKnot) - glm::dvec2(knot);
    const glm::dvec2* low = &knots_[static_cast<std::size_t>(knot.y) * count_.x + knot.x];
    const glm::dvec2* high = low + count_.x;
    return glm::mix(glm::mix(low[0], low[1], part.x), glm::mix(high[0], high[1], part.x), part.y);
  }

 private:
  glm::ivec2 count_;
  std::vector<glm::dvec2> knots_;
};

TerrainMap::Grid gridOf(const HeightPicture& picture, const Box& box, const Geodesy& geodesy) {
  TerrainMap::Grid grid;
  const glm::ivec2 cells = cellsFor(picture.size);
  grid.count = cells + 1;
  grid.origin = box.least;
  grid.spacing = (box.most - box.least) / glm::dvec2(cells);
  const PixelsOfNodes pixels(grid, picture, geodesy);
  grid.heights.reserve(static_cast<std::size_t>(grid.count.x) * grid.count.y);
  for (int row = 0; row < grid.count.y; ++row) {
    for (int column = 0; column < grid.count.x; ++column) {
      grid.heights.push_back(heightAt(picture, pixels.at(column, row)));
    }
  }
  return grid;
}

}  // namespace

bool isPngFile(const fs::path& file) {
  constexpr std::array<char, 8> wanted{'\x89', 'P', 'N', 'G', '\r', '\n', '\x1a', '\n'};
  std::array<char, 8> begin{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(begin.data(), begin.size());
  return stream && begin == wanted;
}

TerrainMap loadTerrain(const SceneTerrain& terrain, const fs::path& file, const Geodesy& geodesy,
                       double waterLevel) {
  HeightPicture picture =
      isPngFile(file) ? readPngHeights(file, terrain) : readGeoTiffHeights(file);
  settle(picture, terrain, file, waterLevel);
  const Box box = boxOf(picture, geodesy, file);
  TerrainLook look = terrain.look;
  look.shoreHardness = terrain.shoreHardness;
  return TerrainMap(gridOf(picture, box, geodesy), look);
}

}  // namespace seaway::bridge
