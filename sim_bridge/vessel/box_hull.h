#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

namespace seaway::bridge {

/// A rectangular hull with its mass, as a vessel file gives it.
///
/// Body frame: x forward, y to port, z up; the **body origin** is the centre of the waterplane at
/// rest in still water. Added mass is not modelled.
struct BoxHull {
  double length = 10.0;                      ///< m
  double beam = 3.0;                         ///< m
  double depth = 2.0;                        ///< keel to deck edge, m
  std::optional<double> givenDraft;          ///< m; exactly one of draft and mass is given
  std::optional<double> givenMass;           ///< kg
  double centreOfGravityAboveKeel = 1.0;     ///< m
  std::optional<double> givenRollGyradius;   ///< m; else 0.35 of the beam
  std::optional<double> givenPitchGyradius;  ///< m; else 0.25 of the length
  double heaveDamping = 0.3;                 ///< part of critical damping
  double rollDamping = 0.1;
  double pitchDamping = 0.3;
  glm::ivec2 columns{9, 3};  ///< sampled columns along × across, ≥ 2 each

  double mass() const;   ///< kg
  double draft() const;  ///< in still water, m: m/(ρLB)
  double waterplaneArea() const { return length * beam; }
  double rollGyradius() const { return givenRollGyradius.value_or(0.35 * beam); }
  double pitchGyradius() const { return givenPitchGyradius.value_or(0.25 * length); }

  /// Metacentric heights, m: KB + BM − KG, BM = B²/(12T) and L²/(12T).
  double transverseMetacentricHeight() const;
  double longitudinalMetacentricHeight() const;

  /// Undamped natural frequencies at rest, rad/s: ω² = ρgA/m and ω² = mgGM/I.
  double heaveFrequency() const;
  double rollFrequency() const;
  double pitchFrequency() const;

  /// Why the hull cannot float upright, or nothing.
  std::optional<std::string> fault() const;
};

/// One vertical column of a box hull: a share of the waterplane at a place.
struct HullColumn {
  glm::dvec2 place{0.0};  ///< body frame, forward and to port, m
  double area = 0.0;      ///< m²
};

/// The hull's columns. Their places lie n/√(n² − 1) farther out than the centres of equal cells, so
/// that the second moments of the waterplane, hence metacentric heights, are those of the box for
/// any number of columns (for two, this is Gauss–Legendre quadrature).
std::vector<HullColumn> hullColumns(const BoxHull& hull);

}  // namespace seaway::bridge
