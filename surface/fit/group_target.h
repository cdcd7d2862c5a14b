#pragma once

#include <cstddef>
#include <vector>

#include "surface/spectra/directional_spectrum.h"

/// Internal to the fits.
namespace seaway::fit {

/// A target of unit variance on the points where a fit compares. Moments are NaN where they are not
/// known, and their vectors empty where the target has none.
struct GroupTarget {
  std::vector<double> frequency;          // Hz, rising
  std::vector<double> waveNumber;         // of the dispersion relation there, rad/m
  std::vector<double> weight;             // of each point in an integral over frequency, Hz
  std::vector<double> density;            // S, 1/Hz
  std::vector<double> east, north;        // S a₁, S b₁
  std::vector<double> difference, cross;  // S a₂, S b₂
  std::vector<double> direction;          // of a grid, rad; empty where there is none
  std::vector<double> grid;               // E(f, θ), 1/Hz/rad, directions fastest
  double variance = 0.0;                  // of the target itself, m²

  std::size_t points() const { return frequency.size(); }
  double squareNorm() const;                                  // ∫ S² df
  double gridSquareNorm() const;                              // ∬ E² df dθ
  double moment(int n, const std::vector<double>& of) const;  // ∫ fⁿ of(f) df
  /// Frequency below which a share of ∫ density^power lies, Hz.
  double quantile(double share, double power) const;
};

/// A target on `points` frequencies that crowd where it is high; `points` of them uniformly where
/// `uniform`. Densities, and densities times moments, are linear between its bins.
GroupTarget sampleTarget(const DirectionalSpectrum& target, double depth, std::size_t points,
                         bool uniform);

/// Bandwidth over centre below which an octave could hide between a target's points; less where the
/// target's own peak is as narrow.
double narrowestBand(const FrequencySpectrum& target);

}  // namespace seaway::fit
