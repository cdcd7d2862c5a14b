#pragma once

#include <span>
#include <string>
#include <vector>

#include "surface/fit/group_response.h"
#include "surface/fit/group_target.h"

/// Internal to the fits.
namespace seaway::fit {

/// What a solver may do to octaves.
struct GroupLimits {
  double lowest = 0.0, highest = 0.0;     // centres, Hz
  double narrowest = 0.03, widest = 0.8;  // bandwidth over centre
  double sharpest = 0.1, broadest = 0.5;  // directional width, rad: wider lengthens |k| by 2 %
};

/// Octaves of a fit, of variances relative to the target's.
struct GroupState {
  std::vector<double> variance;
  std::vector<GroupShape<double>> shape;
  double depth = 0.0;  // m

  std::size_t octaves() const { return variance.size(); }
};

struct GroupSolveOptions {
  GroupLimits limits;
  bool freeShapes = true;       // centres and bandwidths
  bool freeDirections = false;  // and directions and directional widths
  double tailWeight = 0.02;
  double deviationWeight = 1.0;
  double directionWeight = 1.5;
  int maxIterations = 100;
};

struct GroupSolution {
  double cost = 0.0;
  int iterations = 0;
  bool solved = false;
  std::string message;
};

/// Least squares by Ceres over ln variances and, where free, shapes (held within the limits by
/// logistic functions): no bound is ever active. Residuals at every point, over ‖S‖: S, the mean
/// square deviation of the wave number from the dispersion relation, S a₁ … S b₂ where known, the
/// grid where there is one; ln S and the relative deviation, times the tail's weight; and over all:
/// the whole variance, m₀ and m₂ of the band.
GroupSolution solveGroups(const GroupTarget& target, GroupState& state,
                          const GroupSolveOptions& options);

/// Sums over the octaves at each point of a target, per unit variance of it.
struct GroupCurves {
  std::vector<GroupReading<double>> reading;
  std::vector<double> grid;
};
/// The group octaves of a field, with variances in m².
GroupState stateOf(std::span<const Octave> octaves, double depth);

GroupCurves curvesOf(const GroupTarget& target, const GroupState& state);

}  // namespace seaway::fit
