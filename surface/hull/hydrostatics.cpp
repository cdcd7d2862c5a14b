#include "surface/hull/hydrostatics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "surface/hull/wet_triangle.h"
#include "surface/input_error.h"

namespace seaway {
namespace {

/// A corner in the plane's axes: forward, to port, and depth below it.
struct Corner {
  double x, y, depth;
};

Corner between(const Corner& a, const Corner& b, double part) {
  return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y), 0.0};
}

/// Mean of f g over a triangle with linear f and g.
double meanProduct(const glm::dvec3& f, const glm::dvec3& g) {
  return ((f.x + f.y + f.z) * (g.x + g.y + g.z) + glm::dot(f, g)) / 12.0;
}

/// Surface integrals over the wet part, of what follow volume, waterplane and their moments.
/// For u along the plane, ∫ u dV = −∫ u d n·up dA and ∫ u² over the waterplane = −∫ u² n·up dA.
struct Sums {
  double volume = 0.0, area = 0.0, wetted = 0.0;
  double volumeX = 0.0, volumeY = 0.0, volumeDepth = 0.0;
  double areaX = 0.0, areaY = 0.0, areaXX = 0.0, areaYY = 0.0;

  void add(const Corner& a, const Corner& b, const Corner& c) {
    const glm::dvec3 x(a.x, b.x, c.x), y(a.y, b.y, c.y), d(a.depth, b.depth, c.depth);
    const glm::dvec3 p(b.x - a.x, b.y - a.y, a.depth - b.depth);
    const glm::dvec3 q(c.x - a.x, c.y - a.y, a.depth - c.depth);
    const glm::dvec3 areaVector = 0.5 * glm::cross(p, q);
    const double down = -areaVector.z;
    wetted += glm::length(areaVector);
    area += down;
    volume += down * (d.x + d.y + d.z) / 3.0;
    volumeX += down * meanProduct(x, d);
    volumeY += down * meanProduct(y, d);
    volumeDepth += 0.5 * down * meanProduct(d, d);
    areaX += down * (x.x + x.y + x.z) / 3.0;
    areaY += down * (y.x + y.y + y.z) / 3.0;
    areaXX += down * meanProduct(x, x);
    areaYY += down * meanProduct(y, y);
  }

  void addWetPart(const std::array<Corner, 3>& t) {
    const Wetness wetness({t[0].depth, t[1].depth, t[2].depth});
    if (wetness.wet == 0) return;
    if (wetness.wet == 3) return add(t[0], t[1], t[2]);
    const auto i = static_cast<std::size_t>(wetness.lone);
    const Corner &lone = t[i], &next = t[(i + 1) % 3], &before = t[(i + 2) % 3];
    const Corner n = between(lone, next, wetness.next), b = between(lone, before, wetness.before);
    if (wetness.wet == 1) return add(lone, n, b);
    add(n, next, before);
    add(n, before, b);
  }
};

std::string text(const char* format, double a, double b) {
  char out[160];
  std::snprintf(out, sizeof out, format, a, b);
  return out;
}

/// Heights along `up` between which the mesh lies, m.
glm::dvec2 heightRange(const TriangleMesh& mesh, const glm::dvec3& up) {
  glm::dvec2 range(1e300, -1e300);
  for (const glm::dvec3& vertex : mesh.vertices) {
    const double height = glm::dot(up, vertex);
    range = {std::min(range.x, height), std::max(range.y, height)};
  }
  return range;
}

/// What does not balance, each part made dimensionless: volume, trimming and heeling lever.
struct Imbalance {
  glm::dvec3 value{0.0};
  SubmergedPart part;
  double size() const { return glm::length(value); }
};

/// Where a body is tried: height over the mesh's depth, trim, heel.
Imbalance imbalanceAt(const FloatingBody& body, const glm::dvec3& unknown, const glm::dvec3& size,
                      bool heelIsFree) {
  Imbalance result;
  const WaterPlane plane = WaterPlane::at(unknown.x * size.z, unknown.z, unknown.y);
  result.part = submergedPart(*body.mesh, plane);
  const double wanted = body.mass / body.waterDensity;
  const glm::dvec3 arm = result.part.centre - body.centreOfGravity;
  const double share = result.part.volume / wanted;
  result.value = {share - 1.0, share * glm::dot(arm, result.part.forward) / size.x,
                  heelIsFree ? share * glm::dot(arm, result.part.port) / size.y : 0.0};
  return result;
}

glm::dmat3 jacobian(const FloatingBody& body, const glm::dvec3& at, const glm::dvec3& size,
                    bool heelIsFree) {
  glm::dmat3 columns(1.0);
  constexpr double step = 1e-6;
  for (int i = 0; i < (heelIsFree ? 3 : 2); ++i) {
    glm::dvec3 up = at, down = at;
    up[i] += step;
    down[i] -= step;
    columns[i] = (imbalanceAt(body, up, size, heelIsFree).value -
                  imbalanceAt(body, down, size, heelIsFree).value) /
                 (2.0 * step);
  }
  return columns;
}

/// Newton's step, no farther than a quarter of the depth and 0.2 rad.
glm::dvec3 stepFrom(const glm::dmat3& slope, const glm::dvec3& value) {
  if (std::abs(glm::determinant(slope)) < 1e-14) return glm::dvec3(0.0);
  const glm::dvec3 step = -glm::inverse(slope) * value;
  const double largest =
      std::max({std::abs(step.x) / 0.25, std::abs(step.y) / 0.2, std::abs(step.z) / 0.2, 1.0});
  return step / largest;
}

/// Part of the volume that may be under water: the plane has a place, rounding aside.
constexpr double submersible = 1.0 - 1e-12;

double volumeOf(const TriangleMesh& mesh) { return massProperties(mesh).volume; }

}  // namespace

WaterPlane WaterPlane::at(double height, double heel, double trim) {
  return {{std::sin(trim), std::cos(trim) * std::sin(heel), std::cos(trim) * std::cos(heel)},
          height};
}

SubmergedPart submergedPart(const TriangleMesh& mesh, const WaterPlane& plane) {
  SubmergedPart part;
  const glm::dvec3 laid = glm::dvec3(1.0, 0.0, 0.0) - plane.up.x * plane.up;
  part.forward = glm::length(laid) > 1e-9
                     ? glm::normalize(laid)
                     : glm::normalize(glm::cross(glm::dvec3(0.0, 1.0, 0.0), plane.up));
  part.port = glm::cross(plane.up, part.forward);
  const glm::dvec3 middle = boundsOf(mesh).middle();
  const glm::dvec3 origin = middle + (plane.height - glm::dot(plane.up, middle)) * plane.up;
  Sums sums;
  const auto corner = [&](std::uint32_t v) -> Corner {
    const glm::dvec3 p = mesh.vertices[v] - origin;
    return {glm::dot(p, part.forward), glm::dot(p, part.port), -glm::dot(p, plane.up)};
  };
  for (const auto& t : mesh.triangles) {
    sums.addWetPart({corner(t.x), corner(t.y), corner(t.z)});
  }
  part.volume = sums.volume;
  part.wettedArea = sums.wetted;
  part.waterplaneArea = sums.area;
  if (sums.volume > 0.0) {
    part.centre = origin + (sums.volumeX * part.forward + sums.volumeY * part.port -
                            sums.volumeDepth * plane.up) /
                               sums.volume;
  }
  if (sums.area > 0.0) {
    const double x = sums.areaX / sums.area, y = sums.areaY / sums.area;
    part.waterplaneCentre = origin + x * part.forward + y * part.port;
    part.longitudinalMoment = sums.areaXX - sums.area * x * x;
    part.transverseMoment = sums.areaYY - sums.area * y * y;
  }
  return part;
}

WaterPlane planeOfVolume(const TriangleMesh& mesh, double volume, double heel, double trim) {
  const double all = volumeOf(mesh);
  if (!(volume > 0.0) || !(volume < submersible * all)) {
    throw InputError(
        text("a displacement of %.6g m3 must be above 0 and below the hull's volume, %.6g m3",
             volume, all));
  }
  WaterPlane plane = WaterPlane::at(0.0, heel, trim);
  glm::dvec2 range = heightRange(mesh, plane.up);
  const double span = range.y - range.x;
  plane.height = 0.5 * (range.x + range.y);
  for (int i = 0; i < 100; ++i) {
    const SubmergedPart part = submergedPart(mesh, plane);
    const double excess = part.volume - volume;
    (excess > 0.0 ? range.y : range.x) = plane.height;
    if (std::abs(excess) < 1e-13 * all || range.y - range.x < 1e-15 * span) break;
    const double newton = plane.height - excess / std::max(part.waterplaneArea, 1e-300);
    plane.height = newton > range.x && newton < range.y ? newton : 0.5 * (range.x + range.y);
  }
  return plane;
}

Equilibrium equilibrium(const FloatingBody& body, double heel, double trim, bool heelIsFree) {
  if (!(body.mass > 0.0) || !std::isfinite(body.mass)) {
    throw InputError("a mass of " + text("%.6g kg", body.mass, 0.0) + " must be above 0");
  }
  const double sinks = body.waterDensity * volumeOf(*body.mesh);
  if (body.mass >= submersible * sinks) {
    throw InputError(
        text("the hull would sink: it weighs %.6g kg, its whole volume displaces %.6g kg",
             body.mass, sinks));
  }
  const glm::dvec3 size = boundsOf(*body.mesh).size();
  const double height = planeOfVolume(*body.mesh, body.mass / body.waterDensity, heel, trim).height;
  glm::dvec3 at(height / size.z, trim, heel);
  Imbalance now = imbalanceAt(body, at, size, heelIsFree);
  Equilibrium result;
  for (; result.iterations < 200 && now.size() > 1e-12; ++result.iterations) {
    const glm::dvec3 step = stepFrom(jacobian(body, at, size, heelIsFree), now.value);
    double part = 1.0;
    Imbalance next = imbalanceAt(body, at + step, size, heelIsFree);
    while (next.size() >= now.size() && part > 1e-4) {
      part *= 0.5;
      next = imbalanceAt(body, at + part * step, size, heelIsFree);
    }
    if (next.size() >= now.size()) break;
    at += part * step;
    now = next;
  }
  result.trim = at.y;
  result.heel = at.z;
  result.plane = WaterPlane::at(at.x * size.z, at.z, at.y);
  result.part = now.part;
  result.converged = now.size() < 1e-10;
  const double rise = glm::dot(now.part.centre - body.centreOfGravity, result.plane.up);
  result.transverseMetacentricHeight = now.part.transverseRadius() + rise;
  result.longitudinalMetacentricHeight = now.part.longitudinalRadius() + rise;
  return result;
}

std::vector<RightingLever> rightingLevers(const FloatingBody& body, std::span<const double> heels) {
  std::vector<RightingLever> levers;
  double trim = 0.0;
  for (const double heel : heels) {
    Equilibrium rest = equilibrium(body, heel, trim, false);
    if (!rest.converged) rest = equilibrium(body, heel, 0.0, false);
    trim = rest.trim;
    const glm::dvec3 arm = body.centreOfGravity - rest.part.centre;
    levers.push_back({heel, glm::dot(arm, rest.part.port), trim});
  }
  return levers;
}

}  // namespace seaway
