#include "surface/hull/analytic_hulls.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <map>

#include "surface/constants.h"
#include "surface/input_error.h"

namespace seaway {
namespace {

/// Adds a sheet of `along` × `across` cells; place(u, v) for u and v in [0, 1], its outside where
/// ∂/∂u × ∂/∂v points. Cells are cut along the diagonal from (0, 0), or where `other` across it.
void addSheet(TriangleMesh& mesh, int along, int across,
              const std::function<glm::dvec3(double u, double v)>& place, bool other = false) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (int j = 0; j <= across; ++j) {
    for (int i = 0; i <= along; ++i) {
      mesh.vertices.push_back(
          place(static_cast<double>(i) / along, static_cast<double>(j) / across));
    }
  }
  const auto row = static_cast<std::uint32_t>(along + 1);
  for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(across); ++j) {
    for (std::uint32_t i = 0; i + 1 < row; ++i) {
      const std::uint32_t a = first + j * row + i, b = a + 1, c = b + row, d = a + row;
      if (other) {
        mesh.triangles.emplace_back(a, b, d);
        mesh.triangles.emplace_back(b, c, d);
      } else {
        mesh.triangles.emplace_back(a, b, c);
        mesh.triangles.emplace_back(a, c, d);
      }
    }
  }
}

TriangleMesh closed(const TriangleMesh& sheets) {
  const glm::dvec3 size = boundsOf(sheets).size();
  return welded(sheets, 1e-9 * std::max({size.x, size.y, size.z}));
}

}  // namespace

TriangleMesh boxMesh(double length, double beam, double depth, double draft,
                     std::size_t triangles) {
  const glm::dvec3 size(length, beam, depth), low(-0.5 * length, -0.5 * beam, -draft);
  const double area = 2.0 * (size.x * size.y + size.y * size.z + size.z * size.x);
  glm::ivec3 cells(1);
  // The finest near-square division that stays within the number asked for.
  const auto divided = [&](double cell) {
    return glm::max(glm::ivec3(1), glm::ivec3(glm::floor(size / cell + 1e-9)));
  };
  const auto count = [](glm::ivec3 n) {
    return static_cast<std::size_t>(4 * (n.x * n.y + n.y * n.z + n.z * n.x));
  };
  for (double cell = std::sqrt(2.0 * area / static_cast<double>(triangles)) * 0.7;
       cell < 2.0 * length + beam + depth; cell *= 1.01) {
    cells = divided(cell);
    if (count(cells) <= triangles) break;
  }
  TriangleMesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const double side : {0.0, 1.0}) {
      addSheet(mesh, cells[side > 0.0 ? u : v], cells[side > 0.0 ? v : u],
               [&](double first, double second) {
                 glm::dvec3 part(0.0);
                 part[axis] = side;
                 part[side > 0.0 ? u : v] = first;
                 part[side > 0.0 ? v : u] = second;
                 return low + part * size;
               });
    }
  }
  return closed(mesh);
}

TriangleMesh wigleyMesh(double length, double beam, double draft, double freeboard,
                        std::size_t triangles) {
  // Both sides 4nm, walls above the waterline 4n, deck 2n: for n stations, m waterlines. About
  // three stations a waterline make the errors of area and volume alike.
  int stations = 4, waterlines = 2;
  for (int m = 2; m < 2000; ++m) {
    const int n = static_cast<int>(triangles / (4 * static_cast<std::size_t>(m) + 6));
    if (n < 2 * m) break;
    stations = n;
    waterlines = m;
    if (n < 3.5 * m) break;
  }
  const auto halfBreadth = [&](double u, double z) {
    const double along = 2.0 * u - 1.0, down = std::min(z, 0.0) / draft;
    return 0.5 * beam * (1.0 - along * along) * (1.0 - down * down);
  };
  TriangleMesh mesh;
  for (const double side : {-1.0, 1.0}) {
    // Along x to starboard with z up faces outwards; the port side runs the other way.
    const auto place = [&](double u, double z) {
      const double at = side < 0.0 ? u : 1.0 - u;
      return glm::dvec3((at - 0.5) * length, side * halfBreadth(at, z), z);
    };
    // Diagonals that bulge: towards midships as they rise.
    const auto half = [&](double from, bool other) {
      addSheet(
          mesh, stations / 2, waterlines,
          [&](double u, double v) { return place(from + 0.5 * u, (v - 1.0) * draft); }, other);
      addSheet(mesh, stations / 2, 1,
               [&](double u, double v) { return place(from + 0.5 * u, v * freeboard); });
    };
    half(0.0, false);
    half(0.5, true);
  }
  addSheet(mesh, 2 * (stations / 2), 1, [&](double u, double v) {
    return glm::dvec3((u - 0.5) * length, (2.0 * v - 1.0) * halfBreadth(u, 0.0), freeboard);
  });
  return closed(mesh);
}

TriangleMesh openWigleyMesh(double length, double beam, double draft, double freeboard, double wall,
                            std::size_t triangles) {
  if (!(wall > 0.0) || !(wall < 0.5 * beam) || !(wall < draft)) {
    throw InputError("an open hull's wall of " + std::to_string(wall) +
                     " m must be above 0 and below its draft and half its beam");
  }
  struct Skin {
    double length, halfBeam, draft;
    glm::dvec3 at(double u, double z, double side) const {
      const double along = 2.0 * u - 1.0, down = std::clamp(z / draft, -1.0, 0.0);
      return {0.5 * along * length, side * halfBeam * (1.0 - along * along) * (1.0 - down * down),
              z};
    }
  };
  const Skin outer{length, 0.5 * beam, draft};
  const Skin inner{length - 2.0 * wall, 0.5 * beam - wall, draft - wall};
  // Of each side, outside and inside, n stations by m + 1 waterlines, and the rim.
  const int waterlines = 6;
  const int stations = std::max(16, static_cast<int>(triangles / (8 * waterlines + 12)));
  TriangleMesh mesh;
  for (const double side : {-1.0, 1.0}) {
    const auto skin = [&](const Skin& which, bool flip) {
      const auto place = [&](double u, double z) {
        return which.at((side < 0.0) != flip ? u : 1.0 - u, z, side);
      };
      addSheet(mesh, stations, waterlines,
               [&](double u, double v) { return place(u, (v - 1.0) * which.draft); });
      addSheet(mesh, stations, 1, [&](double u, double v) { return place(u, v * freeboard); });
    };
    skin(outer, false);
    skin(inner, true);
    addSheet(mesh, stations, 1, [&](double u, double v) {
      const double at = side < 0.0 ? u : 1.0 - u;
      return glm::mix(outer.at(at, freeboard, side), inner.at(at, freeboard, side), v);
    });
  }
  return closed(mesh);
}

TriangleMesh sphereMesh(double radius, std::size_t triangles) {
  // 2n(m − 1) triangles for n meridians and m bands, m even: a ring at the equator. Chords take
  // a_n²/6 + a_m²/4 of the volume, a_n²/6 of the equator's area, a_n²/3 XX
  const auto meridiansFor = [](int bands) { return static_cast<int>(std::lround(1.35 * bands)); };
  int bands = 4;
  while (2 * static_cast<std::size_t>(meridiansFor(bands + 2)) *
             static_cast<std::size_t>(bands + 1) <=
         triangles) {
    bands += 2;
  }
  TriangleMesh mesh;
  addSheet(mesh, meridiansFor(bands), bands, [&](double u, double v) {
    const double longitude = 2.0 * pi * u, latitude = pi * (v - 0.5);
    return glm::dvec3(std::cos(latitude) * std::cos(longitude),
                      std::cos(latitude) * std::sin(longitude), std::sin(latitude));
  });
  mesh = closed(mesh);
  const double scale = radius * std::cbrt(4.0 / 3.0 * pi / massProperties(mesh).volume);
  for (glm::dvec3& vertex : mesh.vertices) vertex *= scale;
  return mesh;
}

TriangleMesh sparMesh(double diameter, double draft, double freeboard, std::size_t triangles) {
  // n sides: 2nm of the wall in m bands, 2n of the ends.
  const double height = draft + freeboard;
  const double ideal = std::sqrt(static_cast<double>(triangles) * pi * diameter / (2.0 * height));
  int sides = std::clamp(static_cast<int>(ideal), 24, 200) / 4 * 4;
  while (sides > 8 && 4 * static_cast<std::size_t>(sides) > triangles) sides -= 4;
  const int bands = std::max(1, static_cast<int>(triangles) / (2 * sides) - 1);
  const double angle = 2.0 * pi / sides;
  const double radius = 0.5 * diameter * std::sqrt(angle / std::sin(angle));
  const auto onRing = [&](double u, double part, double z) {
    return glm::dvec3(part * radius * std::cos(2.0 * pi * u),
                      part * radius * std::sin(2.0 * pi * u), z);
  };
  TriangleMesh mesh;
  addSheet(mesh, sides, bands,
           [&](double u, double v) { return onRing(u, 1.0, v * height - draft); });
  addSheet(mesh, sides, 1, [&](double u, double v) { return onRing(u, v, -draft); });
  addSheet(mesh, sides, 1, [&](double u, double v) { return onRing(u, 1.0 - v, freeboard); });
  return closed(mesh);
}

}  // namespace seaway
