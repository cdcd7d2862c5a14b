#pragma once

#include <glm/vec2.hpp>

#include "surface/field/wave_field.h"

namespace seaway {

/// Part of the sea that whitecaps cover at a wind of `windSpeed` m/s (10 m): 3.84e-6 U^3.41, 1 at
/// the most (Monahan & O'Muircheartaigh 1980, doi:10.1175/1520-0485(1980)010<2094:OPLDOO>2.0.CO;2).
/// 0 for a wind that is not above 0.
double whitecapCover(double windSpeed);

/// Where a wave field is white: on crests that break and in the foam they leave behind.
///
/// Kryachko's rule (GPU Gems 2, chapter 18), cover = sat((H − H₀)/(H_max − H₀)), with H the wave's
/// phase in place of its height: elevation η/σ_η and slope along the mean direction, both Gaussian
/// and independent, combine to B = η cos α − s sin α of unit variance, largest α ahead of the crest
/// where waves spill, and likewise behind it. So H₀ follows from the cover that the wind asks for,
/// in closed form: the mean over a Gaussian sea is whitecapCover(U)
/// (tests/surface/whitecaps_test.cpp: within 10 % from 5 to 25 m/s).
///
/// Besides, water steeper than waves stand is white, wherever it comes from: a wake's breaking bow
/// wave. Slopes of 0.55 begin to break (Stokes' highest wave: 0.577), those of 0.85 are all white.
struct WhitecapRule {
  WhitecapRule() = default;
  WhitecapRule(const WaveField& waves, double windSpeed);

  /// A ramp from 0 at `threshold` to `most` at `threshold` + `width`.
  struct Ramp {
    double threshold = 1e9, width = 1.0, most = 1.0;
    double at(double x) const;
  };

  glm::dvec2 toward{1.0, 0.0};  ///< mean direction of the waves
  double perHeight = 0.0;       ///< 1/σ_η, 1/m; 0: the field has no whitecaps
  double perSlope = 0.0;        ///< 1/σ of the slope along `toward`
  double mean = 0.0;            ///< cover that the wind asks for
  Ramp breaking;                ///< of B, 31° ahead of the crest
  Ramp old;                     ///< of B, 60° behind it: what breaking left
  static constexpr double aheadCosine = 0.857, aheadSine = 0.515;
  static constexpr double behindCosine = 0.5, behindSine = 0.866;
  static constexpr double steep = 0.55, allSteep = 0.85;

  /// Part of the water that is white where the surface has this height, m, and slope: [0, 1].
  double cover(double height, glm::dvec2 slope) const;
};

}  // namespace seaway
