#pragma once

#include <ceres/jet.h>

#include <cmath>

#include "surface/constants.h"
#include "surface/dispersion.h"
#include "surface/field/group_spectrum.h"
#include "surface/field/octave.h"

/// What a buoy at a fixed point reads of one group octave of unit variance, with derivatives where
/// T is a ceres::Jet. Internal to the fits.
namespace seaway::fit {

template <int N>
double valueOf(const ceres::Jet<double, N>& x) {
  return x.a;
}
inline double valueOf(double x) { return x; }

/// The value and derivative of a function at x, put in the place of x.
template <int N>
ceres::Jet<double, N> chained(const ceres::Jet<double, N>& x, double value, double derivative) {
  return {value, derivative * x.v};
}
inline double chained(double, double value, double) { return value; }

/// A group octave as a fit moves it: the arguments of `makeGroupOctave`.
template <typename T>
struct GroupShape {
  T frequency;         // Hz
  T bandwidth;         // Hz
  T toward;            // rad
  T directionalWidth;  // rad
};

/// Densities over frequency at one frequency, per unit variance. κ is the octave's wave number
/// along its direction there, over that of the dispersion relation; s the root mean square of the
/// one along its crests, likewise.
template <typename T>
struct GroupReading {
  T energy;       // heave, C₁₁
  T deviation;    // ((κ − 1)² + s⁴/4) C₁₁: mean square deviation of |k|
  T slopes;       // (κ² + s²) C₁₁ = (C₂₂ + C₃₃)/k²
  T east, north;  // κ cos θ C₁₁ = Q₁₂/k, κ sin θ C₁₁ = Q₁₃/k
  T difference, cross;  // (κ² − s²) cos 2θ C₁₁ = (C₂₂ − C₃₃)/k², likewise 2C₂₃/k²
};

/// Root mean square of an envelope's derivative along one axis over its FWHM in spectrum, both
/// squared and in cycles: √(225/256 π² 128/315) rad per cell (octave.cpp) over 2π · 0.692.
inline constexpr double rmsOverWidth = 0.43180;

template <typename T>
class GroupResponse {
 public:
  GroupResponse(const GroupShape<T>& shape, double depth) : shape_(shape) {
    using std::cos, std::sin;
    const double f = valueOf(shape.frequency);
    const double k = seaway::waveNumber(2.0 * pi * f, depth);
    const double speed = groupSpeed(k, depth);
    constexpr double h = 1e-5;
    const auto speedAt = [&](double at) {
      return groupSpeed(seaway::waveNumber(2.0 * pi * at, depth), depth);
    };
    const double speedSlope = (speedAt(f * (1.0 + h)) - speedAt(f * (1.0 - h))) / (2.0 * h * f);
    waveNumber_ = chained(shape.frequency, k, 2.0 * pi / speed);
    groupSpeed_ = chained(shape.frequency, speed, speedSlope);
    cellsPerHertz_ = groupBandCycles / shape.bandwidth;
    acrossRms_ = rmsOverWidth * waveNumber_ * shape.directionalWidth;
    cos1_ = cos(shape.toward);
    sin1_ = sin(shape.toward);
  }

  /// Whether anything is read at f, Hz.
  bool reaches(double f) const {
    return std::abs(f - valueOf(shape_.frequency)) * valueOf(cellsPerHertz_) < 4.0;
  }

  T energyAt(double f) const {
    const T q = (f - shape_.frequency) * cellsPerHertz_;
    const double at = valueOf(q);
    return cellsPerHertz_ * chained(q, groupEnvelopeDensity(at), groupEnvelopeSlope(at));
  }

  /// All readings at f, where the dispersion relation's wave number is `waveNumber` rad/m.
  GroupReading<T> at(double f, double waveNumber) const {
    const T energy = energyAt(f);
    const T kappa = alongAt(f) / waveNumber;
    const T s = acrossRms_ / waveNumber;
    const T s2 = s * s, kappa2 = kappa * kappa, off = kappa - 1.0;
    const T first = kappa * energy, second = (kappa2 - s2) * energy;
    GroupReading<T> reading;
    reading.energy = energy;
    reading.deviation = (off * off + 0.25 * s2 * s2) * energy;
    reading.slopes = (kappa2 + s2) * energy;
    reading.east = cos1_ * first;
    reading.north = sin1_ * first;
    reading.difference = (cos1_ * cos1_ - sin1_ * sin1_) * second;
    reading.cross = 2.0 * (cos1_ * sin1_) * second;
    return reading;
  }

  /// The energy and deviation alone; the rest is 0.
  GroupReading<T> undirected(double f, double waveNumber) const {
    GroupReading<T> reading{};
    const T s = acrossRms_ / waveNumber, off = alongAt(f) / waveNumber - 1.0;
    reading.energy = energyAt(f);
    reading.deviation = (off * off + 0.25 * s * s * s * s) * reading.energy;
    return reading;
  }

  /// Density over direction (1/rad) at frequency f and direction θ: the octave's waves there have
  /// the components k∥ and k⊥ = k∥ tan(θ − θᵢ).
  T spreadAt(double f, double theta) const {
    using std::tan;
    const T along = alongAt(f);
    const double turned = std::remainder(theta - valueOf(shape_.toward), 2.0 * pi);
    const double forward = valueOf(along) >= 0.0 ? 1.0 : -1.0;
    if (forward * std::cos(turned) < 1e-3) return T(0.0);
    const T off = theta - shape_.toward;
    const T slope = tan(off);
    const T perSlope = groupBandCycles * along / (waveNumber_ * shape_.directionalWidth);
    const T q = perSlope * slope;
    const double at = valueOf(q);
    return forward * perSlope * (1.0 + slope * slope) *
           chained(q, groupEnvelopeDensity(at), groupEnvelopeSlope(at));
  }

 private:
  /// Wave number along the octave's direction at a frequency f, rad/m.
  T alongAt(double f) const {
    return waveNumber_ + 2.0 * pi * (f - shape_.frequency) / groupSpeed_;
  }

  GroupShape<T> shape_;
  T waveNumber_, groupSpeed_, cellsPerHertz_, acrossRms_, cos1_, sin1_;
};

}  // namespace seaway::fit
