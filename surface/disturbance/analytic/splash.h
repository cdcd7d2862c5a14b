#pragma once

#include <glm/vec2.hpp>
#include <limits>

namespace seaway {

/// Something falls into the water or bursts in it: Kryachko's analytical deformation (GPU Gems 2,
/// chapter 18), rings that run out from a place and die away.
struct Splash {
  glm::dvec2 place{0.0};    ///< m, sea plane
  double time = 0.0;        ///< s since the scene's epoch
  double height = 0.3;      ///< I₀ of the rings, m, ≥ 0
  double wavelength = 1.5;  ///< m, > 0
  double reach = 3.0;       ///< 1/b: rings fall to 1/e in this distance, m, > 0
  double duration = 1.5;    ///< T: and in this time, s, > 0
  /// Least and most of the above.
  static constexpr double mostHeight = 50.0, mostLength = 1000.0, mostDuration = 600.0;
};

/// One splash's rings, ready to be asked:
///
///   η = I₀ e^(−ρ/reach) e^(−τ/T) cos(kρ − ωτ),  ρ = √(r² + r₀²), r₀ = λ/4,
///
/// ω from the dispersion relation, times windows that start the motion within a quarter of a
/// period, let no ring be where its phase speed has not brought it yet, and end it all at
/// `lifetime` and `radius`: once continuously differentiable everywhere.
class SplashRings {
 public:
  /// Throws InputError for a splash outside the ranges stated beside it. `current` carries it
  /// along, m/s.
  explicit SplashRings(const Splash& splash, glm::dvec2 current = glm::dvec2(0.0),
                       double depth = std::numeric_limits<double>::infinity());

  const Splash& splash() const { return splash_; }
  double start() const { return splash_.time; }
  double end() const { return splash_.time + lifetime(); }
  double lifetime() const { return 6.0 * splash_.duration; }  ///< s
  double radius() const { return 7.0 * splash_.reach; }       ///< m: beyond it the water is still
  glm::dvec2 centre(double t) const { return splash_.place + current_ * (t - splash_.time); }
  bool isActive(double t) const { return t > start() && t < end(); }

  /// Height and its derivatives at the distance `r` m and `age` s: exact in double.
  struct Value {
    double height = 0.0, byDistance = 0.0, byTime = 0.0;
  };
  Value at(double r, double age) const noexcept;

  double angularFrequency() const { return angularFrequency_; }
  double waveNumber() const { return waveNumber_; }

 private:
  Splash splash_;
  glm::dvec2 current_;
  double waveNumber_, angularFrequency_;
};

}  // namespace seaway
