#include "sim_bridge/vessel/hull_source.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "surface/hull/analytic_hulls.h"
#include "surface/input_error.h"
#include "surface/spectra/readers/text_cursor.h"

namespace seaway::bridge {
namespace {

using Numbers = std::span<const double>;

struct Shape {
  const char* name;
  const char* form;
  std::size_t count;
  TriangleMesh (*make)(Numbers, std::size_t);
};

constexpr std::array<Shape, 5> shapes{{
    {"box", "box:LENGTH,BEAM,DEPTH", 3,
     [](Numbers n, std::size_t count) { return boxMesh(n[0], n[1], n[2], 0.5 * n[2], count); }},
    {"wigley", "wigley:LENGTH,BEAM,DRAFT,FREEBOARD", 4,
     [](Numbers n, std::size_t count) { return wigleyMesh(n[0], n[1], n[2], n[3], count); }},
    {"open_wigley", "open_wigley:LENGTH,BEAM,DRAFT,FREEBOARD,WALL", 5,
     [](Numbers n, std::size_t count) {
       return openWigleyMesh(n[0], n[1], n[2], n[3], n[4], count);
     }},
    {"sphere", "sphere:RADIUS", 1,
     [](Numbers n, std::size_t count) { return sphereMesh(n[0], count); }},
    {"spar", "spar:DIAMETER,DRAFT,FREEBOARD", 3,
     [](Numbers n, std::size_t count) { return sparMesh(n[0], n[1], n[2], count); }},
}};

std::vector<double> dimensionsOf(const std::string& name, const Shape& shape) {
  const auto fail = [&] {
    throw InputError("'" + name + "' is not a hull; must be " + shape.form +
                     " with numbers above 0, in m");
  };
  std::vector<double> numbers;
  std::string rest = name.substr(name.find(':') + 1) + ",";
  for (std::size_t comma; (comma = rest.find(',')) != std::string::npos; rest.erase(0, comma + 1)) {
    const std::optional<double> number = numberOf(rest.substr(0, comma));
    if (!number || !(*number > 0.0) || !(*number < 1e6)) fail();
    numbers.push_back(*number);
  }
  if (numbers.size() != shape.count) fail();
  return numbers;
}

}  // namespace

TriangleMesh hullByName(const std::string& name, const HullFileSettings& settings,
                        std::size_t triangles) {
  for (const Shape& shape : shapes) {
    if (name.rfind(std::string(shape.name) + ":", 0) != 0) continue;
    return shape.make(dimensionsOf(name, shape), triangles);
  }
  return readHullFile(name, settings);
}

}  // namespace seaway::bridge
