#include "surface/hull/mesh_calibration.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "surface/hull/hydrostatics.h"
#include "surface/input_error.h"

namespace seaway {
namespace {

constexpr double fadesWithin = 0.03;  // of half the breadth
constexpr double farthest = 0.1;      // of the breadth

/// How the second distance varies with depth below the waterline, in drafts.
enum class Deepening {
  bulge,  ///< most at a fifth of the draft: what an inscribed mesh of a round hull lacks
  taper,  ///< most at the keel, for a mesh without vertices between waterline and keel
};

/// Vertices moved apart by `even` m and, below the waterline, by up to `deep` m more.
TriangleMesh spread(const TriangleMesh& mesh, double even, double deep, Deepening how) {
  const MeshBounds bounds = boundsOf(mesh);
  const double fade = fadesWithin * 0.5 * bounds.size().y;
  TriangleMesh result = mesh;
  for (glm::dvec3& vertex : result.vertices) {
    const double below = std::clamp(vertex.z / bounds.lower.z, 0.0, 1.0);
    const double part = how == Deepening::taper ? below : 12.2 * below * std::pow(1.0 - below, 4.0);
    vertex.y += (even + deep * part) * std::clamp(vertex.y / fade, -1.0, 1.0);
  }
  return result;
}

struct Figures {
  double volume, area;
};

Figures figuresOf(const TriangleMesh& mesh) {
  const SubmergedPart part = submergedPart(mesh, WaterPlane::at(0.0));
  return {part.volume, part.waterplaneArea};
}

}  // namespace

TriangleMesh calibrated(const TriangleMesh& mesh, double volume, double waterplane) {
  const MeshBounds bounds = boundsOf(mesh);
  const double unit = 0.01 * bounds.size().y;
  const Figures own = figuresOf(mesh);
  if (!(own.volume > 0.0) || !(own.area > 0.0)) {
    throw InputError("a hull that is calibrated needs parts below and above z = 0");
  }
  const Figures wider = figuresOf(spread(mesh, unit, 0.0, Deepening::taper));
  const double a = wider.volume - own.volume;
  Deepening how = Deepening::bulge;
  Figures deeper = figuresOf(spread(mesh, 0.0, unit, how));
  if (std::abs(deeper.volume - own.volume) < 0.01 * a) {
    how = Deepening::taper;
    deeper = figuresOf(spread(mesh, 0.0, unit, how));
  }
  const double b = deeper.volume - own.volume;
  const double c = wider.area - own.area, d = deeper.area - own.area;
  const double determinant = a * d - b * c;
  const double volumeLacks = volume - own.volume, areaLacks = waterplane - own.area;
  const double even = unit * (d * volumeLacks - b * areaLacks) / determinant;
  const double deep = unit * (a * areaLacks - c * volumeLacks) / determinant;
  const double moves = std::abs(even) + std::abs(deep);
  if (!(moves <= farthest * bounds.size().y)) {
    throw InputError("a known displacement of " + std::to_string(volume) +
                     " m3 on a waterplane of " + std::to_string(waterplane) +
                     " m2 is too far from the mesh's, " + std::to_string(own.volume) + " m3 on " +
                     std::to_string(own.area) + " m2");
  }
  return spread(mesh, even, deep, how);
}

}  // namespace seaway
