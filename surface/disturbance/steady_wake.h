#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "surface/disturbance/hull_footprint.h"
#include "surface/disturbance/wake_window.h"

namespace seaway {

/// A hull that has sailed straight through still water until its wake is steady: a study of the
/// wake solver against the theory of ship waves (Kelvin 1887, Havelock 1908). Points are given from
/// the vessel: x astern, y to port, m.
class SteadyWake {
 public:
  /// A square window of `size` m on 2 · modes cells along each side, three crossings long. Throws
  /// InputError for windows that cannot be. The vessel lies 0.3 of the size ahead of its middle.
  SteadyWake(const HullFootprint& hull, double speed, double size, double depth, int modes);

  /// η at points, m.
  std::vector<double> heights(const std::vector<glm::dvec2>& fromVessel) const;

  /// |Z| at a point, m, bilinear: the envelope of the waves.
  double envelopeAt(glm::dvec2 fromVessel) const;

  /// One more step and its height map: what a step costs can be timed.
  void step();

  /// Wave resistance, N.
  double resistance() { return window_.waveResistance(place_); }

  double speed() const { return speed_; }
  double size() const { return window_.settings().size(); }
  const WakeWindowSettings& settings() const { return window_.settings(); }

 private:
  HullPlace placeAt(long long step) const;

  double speed_, dt_;
  WakeWindow window_;
  long long steps_ = 0;
  HullPlace place_;
  std::vector<float> envelope_;
  std::shared_ptr<WakeGrid> grid_;
};

/// Length of the waves on the track between two distances astern, m, from the places where they
/// cross zero; NaN for fewer than four crossings.
double transverseWavelength(const SteadyWake& wake, double first, double last);

/// That of waves that keep up with a vessel, m: 2πU²/g in deep water; NaN where none do, for
/// U ≥ √(gd).
double transverseWavelengthTheory(double speed, double depth);

/// A point of a wake's highest ridge.
struct RidgePoint {
  double astern, aside;  ///< m
};

/// Where the envelope is highest across the track, at sixty distances astern from `first` to
/// `last`, up to `widest` times the distance aside.
std::vector<RidgePoint> ridgeOf(const SteadyWake& wake, double first, double last, double widest);

/// The ridge's angle to the track at an infinite distance, rad. Near the cusp a wake is an Airy
/// function whose peak lies inside the cusp line by a length ∝ r^(1/3), an angle ∝ r^(−2/3): a
/// straight line is fitted over that.
double ridgeAngleAtInfinity(const std::vector<RidgePoint>& ridge);

/// The angle to the track, rad, of a wake's front beyond the critical speed, where there is no
/// cusp: a line through the outermost places where the envelope reaches a third of what is highest
/// across the track, at distances astern from `first` to `last`, up to `widest` times the distance
/// aside.
double frontAngle(const SteadyWake& wake, double first, double last, double widest);

/// Half the angle of the wedge that holds a wake, rad, by tracing rays: waves that stand still on a
/// ship, U cos θ = c(k), carry their energy along atan(c_g sin θ/(U − c_g cos θ)); the wedge is the
/// widest of these. asin(1/3) in deep water, asin(√(gd)/U) beyond the critical speed √(gd).
double wedgeAngle(double speed, double depth);

}  // namespace seaway
