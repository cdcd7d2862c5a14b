#pragma once

#include <glm/vec4.hpp>
#include <vector>

namespace seaway::render {

/// Refractive index of sea water for visible light, 15 °C, 35 g/kg.
inline constexpr double seaWaterIndex = 1.34;

/// Reflectance of unpolarised light at a plane, from the cosine of the angle of incidence [0, 1]:
/// half the sum of both polarisations' (Fresnel; Johanson's Eq. 1.4 lacks the half). `index` is
/// that of the far side over that of the near side; below 1, total reflection gives 1.
double fresnelReflectance(double cosine, double index = seaWaterIndex);

/// What a rough patch of water reflects, averaged over the facets that a viewer sees.
///
/// Facet slopes are Gaussian and isotropic; each counts with its area projected towards the viewer
/// (no mutual shadowing). Far water is seen at grazing angles, where a flat mirror would reflect
/// all of the sky just above the horizon and real water, tilted towards the viewer, does neither.
struct RoughReflection {
  double reflectance = 0.0;  ///< mean Fresnel reflectance
  double tilt = 0.0;         ///< mean slope of reflecting facets towards the viewer
  double area = 0.0;         ///< facets' area projected towards the viewer, per area of the patch
};

/// `cosine` between the patch's normal and the viewer, [0, 1]; `slopeDeviation` standard deviation
/// of slope along one axis, ≥ 0. Quadrature over ±4 deviations; 1e-3 accurate.
RoughReflection roughReflection(double cosine, double slopeDeviation);

/// `roughReflection` over a grid, for a texture: (reflectance, tilt, area, 0), rows by slope
/// deviation from 0 to `fresnelTableRoughest`, columns by √cosine from 0 to 1.
std::vector<glm::vec4> fresnelTable(int columns, int rows);
inline constexpr double fresnelTableRoughest = 0.4;

}  // namespace seaway::render
