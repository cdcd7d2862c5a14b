#pragma once

#include <complex>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace seaway {

/// One waterline of a hull: where the plane z cuts its underwater part.
struct Waterline {
  double z = 0.0;                   ///< m, ≤ 0, 0 at the waterplane
  std::vector<glm::dvec2> outline;  ///< closed polygon, body frame, either sense; empty: nothing
};

/// How a hull presses on the water: the pressure head H(x) = hull depth, as a function of wave
/// number and with each layer's influence decaying from its depth. A displacement source and this
/// head make the same waves outside the hull.
///
/// Body frame: x forward, y to port, z up, metres. Between waterlines the hull is interpolated
/// linearly in the spectrum; below the last there is none. Immutable; const calls are thread-safe.
class HullFootprint {
 public:
  /// Waterlines from the top down, at least two. Throws InputError for fewer, for heights above 0
  /// or that do not fall, and for outlines that are not finite.
  explicit HullFootprint(std::vector<Waterline> waterlines);

  /// A box of draft T: H-hat is Ŵ (1 − e^(−kT))/k in deep water.
  static HullFootprint box(double length, double beam, double draft);

  /// Wigley's parabolic hull, y = ±(B/2)(1 − (2x/L)²)(1 − (z/T)²), at `waterlines` heights.
  static HullFootprint wigley(double length, double beam, double draft, int waterlines = 5);

  /// A table of half-breadths ≥ 0, m: `stations` x rising, `heights` z falling from 0, the breadths
  /// of one height after another. Throws InputError for sizes that do not match.
  static HullFootprint fromHalfBreadths(std::span<const double> stations,
                                        std::span<const double> heights,
                                        std::span<const double> halfBreadths);

  /// The same hull with all its breadth on the centreplane: Michell's thin ship.
  HullFootprint collapsedOntoCentreplane() const;

  /// Ĥ(k) = ∫dz [cosh k(z + d)/cosh kd] ∫∫ e^(−ik·x) dx dy over the waterline at z, m³, for a wave
  /// number k in rad/m in the body frame and a depth of water d in m, maybe infinite. Exact for the
  /// polygons, to relative 1e-8 (tests/surface/disturbance/hull_footprint_test.cpp).
  std::complex<double> spectrum(glm::dvec2 k, double depth) const;

  /// Ĥ for k_x = 0 … alongX and k_y = −alongY … alongY times `spacing`, k_x running fastest: as
  /// `spectrum`, some thirty times quicker.
  std::vector<std::complex<float>> tabulate(double spacing, int alongX, int alongY,
                                            double depth) const;

  double volume() const;  ///< m³: Ĥ(0)

  /// The hull's largest distance from the body's origin, m.
  double extent() const { return extent_; }

  /// Corners of the smallest box about the hull, m.
  glm::dvec2 lower() const { return lower_; }
  glm::dvec2 upper() const { return upper_; }

  std::span<const Waterline> waterlines() const { return waterlines_; }

 private:
  std::complex<double> overDepth(double number, double depth,
                                 std::span<const std::complex<double>> areas) const;

  std::vector<Waterline> waterlines_;
  glm::dvec2 lower_{0.0}, upper_{0.0};
  double extent_ = 0.0;
  bool thin_ = false;
};

}  // namespace seaway
