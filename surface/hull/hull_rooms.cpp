#include "surface/hull/hull_rooms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <limits>

#include "surface/constants.h"
#include "surface/hull/hull_repair.h"

namespace seaway {
namespace {

constexpr int pointsAlong = 160;
constexpr int pieces = 6;      // of a hollow, along x
constexpr int directions = 8;  // about a section

enum class Point : std::uint8_t { hull, open, outside, taken };

/// Points of a box about a mesh, a step wider each way.
struct Lattice {
  glm::dvec3 lower;
  double step;
  glm::ivec3 count;
  std::vector<Point> points;

  explicit Lattice(const TriangleMesh& mesh) {
    const MeshBounds bounds = boundsOf(mesh);
    const glm::dvec3 size = bounds.size();
    step = std::max({size.x, size.y, size.z}) / pointsAlong;
    lower = bounds.lower - 1.5 * step;
    count = glm::ivec3(glm::ceil(size / step)) + 4;
    const HullDistance distance(mesh, 0.5 * step, 2.0 * step);
    points.resize(static_cast<std::size_t>(count.x) * count.y * count.z);
    for (int z = 0; z < count.z; ++z) {
      for (int y = 0; y < count.y; ++y) {
        for (int x = 0; x < count.x; ++x) {
          // Thicker by half a step on either side, so that thin walls hold; rooms take it back, and
          // a quarter more, so that no sea shows along the wall.
          const bool hull = distance.at(place({x, y, z})) < 0.5 * step;
          at({x, y, z}) = hull ? Point::hull : Point::open;
        }
      }
    }
  }
  bool holds(glm::ivec3 i) const {
    return glm::all(glm::greaterThanEqual(i, glm::ivec3(0))) && glm::all(glm::lessThan(i, count));
  }
  Point& at(glm::ivec3 i) {
    return points[static_cast<std::size_t>((i.z * count.y + i.y) * count.x + i.x)];
  }
  glm::dvec3 place(glm::ivec3 i) const { return lower + step * glm::dvec3(i); }
};

constexpr std::array<glm::ivec3, 6> neighbours{
    {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};

/// Open points joined to `from`, through the first `ways` neighbours, become `as`; returns them.
std::vector<glm::ivec3> flood(Lattice& lattice, glm::ivec3 from, std::size_t ways, Point as) {
  std::vector<glm::ivec3> found;
  if (lattice.at(from) != Point::open) return found;
  lattice.at(from) = as;
  found.push_back(from);
  for (std::size_t next = 0; next < found.size(); ++next) {
    for (std::size_t way = 0; way < ways; ++way) {
      const glm::ivec3 other = found[next] + neighbours[way];
      if (!lattice.holds(other) || lattice.at(other) != Point::open) continue;
      lattice.at(other) = as;
      found.push_back(other);
    }
  }
  return found;
}

glm::dvec2 direction(int i) {
  const double angle = 2.0 * pi * i / directions;
  return {std::cos(angle), std::sin(angle)};
}

/// How far a hollow's section at one x reaches in each direction of y and z, m.
struct Section {
  std::array<double, directions> reach;
  Section() { reach.fill(-std::numeric_limits<double>::infinity()); }
  bool any() const { return std::isfinite(reach[0]); }
};

HullRoom between(const Section& aft, double from, const Section& fore, double to) {
  HullRoom room;
  room.planes = {{1.0, 0.0, 0.0, to}, {-1.0, 0.0, 0.0, -from}};
  for (int i = 0; i < directions; ++i) {
    const auto n = static_cast<std::size_t>(i);
    const double slope = (fore.reach[n] - aft.reach[n]) / (to - from);
    const glm::dvec3 normal(-slope, direction(i));
    const double size = glm::length(normal);
    room.planes.emplace_back(normal / size, (aft.reach[n] - slope * from) / size);
  }
  return room;
}

void addRooms(const Lattice& lattice, const std::vector<glm::ivec3>& hollow,
              std::vector<HullRoom>& rooms) {
  std::vector<Section> sections(static_cast<std::size_t>(lattice.count.x));
  for (const glm::ivec3 point : hollow) {
    const glm::dvec3 place = lattice.place(point);
    Section& section = sections[static_cast<std::size_t>(point.x)];
    for (int i = 0; i < directions; ++i) {
      double& reach = section.reach[static_cast<std::size_t>(i)];
      reach = std::max(reach,
                       glm::dot(direction(i), glm::dvec2(place.y, place.z)) + 0.75 * lattice.step);
    }
  }
  int first = 0, last = lattice.count.x - 1;
  while (!sections[static_cast<std::size_t>(first)].any()) ++first;
  while (!sections[static_cast<std::size_t>(last)].any()) --last;
  const int count = std::min(pieces, last - first);
  for (int piece = 0; piece < count; ++piece) {
    const int aft = first + (last - first) * piece / count;
    const int fore = first + (last - first) * (piece + 1) / count;
    const Section &from = sections[static_cast<std::size_t>(aft)],
                  &to = sections[static_cast<std::size_t>(fore)];
    if (!from.any() || !to.any()) continue;
    rooms.push_back(between(from, lattice.place({aft, 0, 0}).x, to, lattice.place({fore, 0, 0}).x));
  }
}

}  // namespace

std::vector<HullRoom> roomsOf(const TriangleMesh& mesh) {
  std::vector<HullRoom> rooms;
  if (mesh.triangles.empty()) return rooms;
  Lattice lattice(mesh);
  // From the rim of the box, layer by layer: what is not reached is enclosed at its height.
  for (int z = 0; z < lattice.count.z; ++z) flood(lattice, {0, 0, z}, 4, Point::outside);
  // A few points are roughness of the lattice, not a room.
  constexpr std::size_t fewest = 64;
  for (int z = 0; z < lattice.count.z; ++z) {
    for (int y = 0; y < lattice.count.y; ++y) {
      for (int x = 0; x < lattice.count.x; ++x) {
        const auto hollow = flood(lattice, {x, y, z}, 6, Point::taken);
        if (hollow.size() >= fewest) addRooms(lattice, hollow, rooms);
      }
    }
  }
  return rooms;
}

}  // namespace seaway
