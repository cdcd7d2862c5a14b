#include "sim_bridge/scene/outline_file.h"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "sim_bridge/output/number_text.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

using nlohmann::json;

constexpr double longestPart_deg = 0.01;

/// Reads one file; keeps the key it is at, for messages.
class OutlineReader {
 public:
  OutlineReader(const std::filesystem::path& file, const Geodesy& geodesy)
      : file_(file.string()), geodesy_(geodesy) {}

  std::vector<OutlinePolygon> read(const json& document) {
    addFrom(document, "");
    if (polygons_.empty()) fail("", "has no Polygon or MultiPolygon");
    return std::move(polygons_);
  }

 private:
  [[noreturn]] void fail(const std::string& key, const std::string& what) const {
    throw InputError(file_, 0, (key.empty() ? "" : "key '" + key + "': ") + what);
  }

  const json& member(const json& value, const std::string& key, const char* name) const {
    if (!value.is_object()) fail(key, "must be an object");
    const auto found = value.find(name);
    if (found == value.end()) fail(key, "lacks '" + std::string(name) + "'");
    return *found;
  }

  const json& listAt(const json& value, const std::string& key, std::size_t least,
                     const char* of) const {
    if (!value.is_array() || value.size() < least) {
      fail(key, "must be a list of " + std::to_string(least) + " or more " + of);
    }
    return value;
  }

  void addFrom(const json& value, const std::string& key) {
    const auto under = [&](const char* name) { return key.empty() ? name : key + "." + name; };
    const json& type = member(value, key, "type");
    if (type == "FeatureCollection") {
      const json& features =
          listAt(member(value, key, "features"), under("features"), 1, "features");
      for (std::size_t i = 0; i < features.size(); ++i) {
        addFrom(features[i], under("features") + "[" + std::to_string(i) + "]");
      }
    } else if (type == "Feature") {
      addFrom(member(value, key, "geometry"), under("geometry"));
    } else if (type == "Polygon") {
      addPolygon(member(value, key, "coordinates"), under("coordinates"));
    } else if (type == "MultiPolygon") {
      const json& all =
          listAt(member(value, key, "coordinates"), under("coordinates"), 1, "polygons");
      for (std::size_t i = 0; i < all.size(); ++i) {
        addPolygon(all[i], under("coordinates") + "[" + std::to_string(i) + "]");
      }
    } else {
      fail(under("type"), type.dump() +
                              " is not allowed; must be one of: Polygon, MultiPolygon, "
                              "Feature, FeatureCollection");
    }
  }

  void addPolygon(const json& rings, const std::string& key) {
    OutlinePolygon polygon;
    listAt(rings, key, 1, "rings");
    for (std::size_t i = 0; i < rings.size(); ++i) {
      polygon.rings.push_back(ringOf(rings[i], key + "[" + std::to_string(i) + "]"));
    }
    // Faults are told where the file has them; the whole is put together later.
    try {
      WaterOutline(std::span(&polygon, 1));
    } catch (const InputError& fault) {
      fail(key, std::string(fault.what()).substr(std::string("polygon 0").size() + 2));
    }
    polygons_.push_back(std::move(polygon));
  }

  std::vector<glm::dvec2> ringOf(const json& positions, const std::string& key) const {
    listAt(positions, key, 4, "positions");
    if (positions.front() != positions.back()) {
      fail(key, "is not closed: its last position must be its first");
    }
    std::vector<glm::dvec2> ring;
    glm::dvec2 before = degrees(positions[0], key + "[0]");
    for (std::size_t i = 1; i < positions.size(); ++i) {
      const std::string here = key + "[" + std::to_string(i) + "]";
      glm::dvec2 next = degrees(positions[i], here);
      // The shorter way around, also across 180°.
      next.x = before.x + std::remainder(next.x - before.x, 360.0);
      const double longest = std::max(std::abs(next.x - before.x), std::abs(next.y - before.y));
      const int parts = std::max(1, static_cast<int>(std::ceil(longest / longestPart_deg)));
      for (int part = 0; part < parts; ++part) {
        ring.push_back(place(before + (next - before) * (static_cast<double>(part) / parts), here));
      }
      before = next;
    }
    return ring;
  }

  glm::dvec2 degrees(const json& position, const std::string& key) const {
    listAt(position, key, 2, "numbers: longitude, latitude");
    const auto component = [&](std::size_t i, double most) {
      const std::string at = key + "[" + std::to_string(i) + "]";
      if (!position[i].is_number()) fail(at, position[i].dump() + " is not a number");
      const double value = position[i].get<double>();
      if (!(std::abs(value) <= most)) {
        fail(at, numberText(value) + " is not allowed; must be in [-" + numberText(most) + ", " +
                     numberText(most) + "] ° (longitude, then latitude)");
      }
      return value;
    };
    return {component(0, 360.0), component(1, 90.0)};
  }

  glm::dvec2 place(glm::dvec2 at, const std::string& key) const {
    const SeaPlanePoint point = geodesy_.seaPlaneFromGeodetic(at.y, at.x);
    if (!point.inRange) {
      fail(key, "is farther than " + numberText(Geodesy::usableRange() / 1000.0) +
                    " km from the scene's anchor");
    }
    return point.position;
  }

  std::string file_;
  const Geodesy& geodesy_;
  std::vector<OutlinePolygon> polygons_;
};

json parse(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw InputError(file.string(), 0, "cannot be read");
  try {
    return json::parse(stream);
  } catch (const json::parse_error& fault) {
    throw InputError(file.string(), 0, std::string("is not JSON: ") + fault.what());
  }
}

}  // namespace

WaterOutline loadOutline(const std::filesystem::path& file, const Geodesy& geodesy) {
  const std::vector<OutlinePolygon> polygons = OutlineReader(file, geodesy).read(parse(file));
  return WaterOutline(polygons);
}

}  // namespace seaway::bridge
