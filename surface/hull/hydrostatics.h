#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "surface/constants.h"
#include "surface/hull/triangle_mesh.h"

/// Hydrostatics of a closed mesh cut by a plane of still water: exact for the polyhedron.
/// Heel is positive starboard down, trim positive bow up, both rad.
namespace seaway {

/// Still water as the body sees it: points with dot(up, p) < height are under water.
struct WaterPlane {
  glm::dvec3 up{0.0, 0.0, 1.0};  ///< unit, body frame
  double height = 0.0;           ///< m along `up` from the body's origin

  /// The plane of a body heeled and trimmed, its origin `height` m under the surface.
  static WaterPlane at(double height, double heel = 0.0, double trim = 0.0);
};

/// The part of a mesh below a plane. Second moments are about the waterplane's centroid.
struct SubmergedPart {
  double volume = 0.0;                ///< m³
  glm::dvec3 centre{0.0};             ///< of buoyancy, body frame, m
  double wettedArea = 0.0;            ///< m²
  double waterplaneArea = 0.0;        ///< m²
  glm::dvec3 waterplaneCentre{0.0};   ///< centre of flotation, body frame, m
  double transverseMoment = 0.0;      ///< ∫ y² dA, y to port in the plane, m⁴
  double longitudinalMoment = 0.0;    ///< ∫ x² dA, x forward in the plane, m⁴
  glm::dvec3 forward{1.0, 0.0, 0.0};  ///< the body's x axis laid into the plane
  glm::dvec3 port{0.0, 1.0, 0.0};     ///< up × forward

  /// I/V, m; 0 where nothing is under water.
  double transverseRadius() const { return volume > 0.0 ? transverseMoment / volume : 0.0; }
  double longitudinalRadius() const { return volume > 0.0 ? longitudinalMoment / volume : 0.0; }
};

/// Integrals of depth over the wet surface; no cap polygon is made, for the integrands are 0 on it:
/// V = −∫ d n·up dA. A triangle with a corner in the plane is cut there.
SubmergedPart submergedPart(const TriangleMesh& mesh, const WaterPlane& plane);

/// What floats: a closed mesh with its mass.
struct FloatingBody {
  const TriangleMesh* mesh = nullptr;
  double mass = 0.0;                      ///< kg
  glm::dvec3 centreOfGravity{0.0};        ///< body frame, m
  double waterDensity = seaWaterDensity;  ///< kg/m³
};

/// How a body lies at rest.
struct Equilibrium {
  WaterPlane plane;
  double heel = 0.0, trim = 0.0;  ///< rad
  SubmergedPart part;
  int iterations = 0;
  bool converged = false;  ///< volume and moments balance to 1e-10
  /// GM about both axes, m: stable where positive.
  double transverseMetacentricHeight = 0.0, longitudinalMetacentricHeight = 0.0;
};

/// Still water of a displacement for a body held at an attitude, by bisection and Newton. Throws
/// InputError where the volume is not in (0, the mesh's own).
WaterPlane planeOfVolume(const TriangleMesh& mesh, double volume, double heel = 0.0,
                         double trim = 0.0);

/// Heel, trim and sinkage at which weight and buoyancy balance, from the attitude given: Newton
/// with halved steps. `heel` fixed where `heelIsFree` is false. Throws InputError for a body that
/// would sink or weighs nothing.
Equilibrium equilibrium(const FloatingBody& body, double heel = 0.0, double trim = 0.0,
                        bool heelIsFree = true);

/// A righting lever.
struct RightingLever {
  double heel = 0.0;   ///< rad
  double lever = 0.0;  ///< GZ, m, positive where it rights a heel to starboard
  double trim = 0.0;   ///< that the body takes up, rad
};

/// GZ at each of `heels` (rad), the body free to sink and trim.
std::vector<RightingLever> rightingLevers(const FloatingBody& body, std::span<const double> heels);

}  // namespace seaway
