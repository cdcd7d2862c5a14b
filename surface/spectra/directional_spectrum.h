#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "surface/spectra/frequency_spectrum.h"

namespace seaway {

/// The first two Fourier moments of the distribution D(θ) of the energy over direction at one
/// frequency, ∫D dθ = 1. θ is where the waves go, rad counter-clockwise from east. NaN: not
/// measured.
struct DirectionalMoments {
  double a1 = std::numeric_limits<double>::quiet_NaN();  ///< ∫ D cos θ dθ
  double b1 = std::numeric_limits<double>::quiet_NaN();  ///< ∫ D sin θ dθ
  double a2 = std::numeric_limits<double>::quiet_NaN();  ///< ∫ D cos 2θ dθ
  double b2 = std::numeric_limits<double>::quiet_NaN();  ///< ∫ D sin 2θ dθ

  bool hasFirst() const { return std::isfinite(a1) && std::isfinite(b1); }
  bool hasSecond() const { return std::isfinite(a2) && std::isfinite(b2); }

  double r1() const { return std::hypot(a1, b1); }  ///< 0: from everywhere, 1: one direction
  double meanDirection() const { return std::atan2(b1, a1); }  ///< rad, toward
  /// Directional spread √(2(1 − r₁)), rad (Kuik et al. 1988).
  double spread() const { return std::sqrt(2.0 * (r1() > 1.0 ? 0.0 : 1.0 - r1())); }
};

/// Variance density of the surface elevation over frequency, with what is known of its directions:
/// nothing, two moments at each frequency (buoys), or a grid (wave models).
struct DirectionalSpectrum {
  FrequencySpectrum energy;  ///< S(f) = ∫E(f, θ) dθ

  /// One for each frequency, or empty where no direction is known. Filled for grids too.
  std::vector<DirectionalMoments> moments;

  /// Directions of the grid: where the waves go, rad counter-clockwise from east, evenly over a
  /// whole turn, rising; empty where there is no grid.
  std::vector<double> direction;
  /// E(f, θ), m²/Hz/rad, directions running fastest; one for each frequency and direction.
  std::vector<double> density;

  bool hasGrid() const { return !direction.empty(); }
  double at(std::size_t frequency, std::size_t towards) const {
    return density[frequency * direction.size() + towards];
  }

  /// What is wrong with it, or nothing: sizes, order, finite, ≥ 0, r ≤ 1.
  std::optional<std::string> validate() const;

  /// `energy` and `moments` from the grid.
  void integrateGrid();
};

}  // namespace seaway
