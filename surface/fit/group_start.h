#pragma once

#include <limits>
#include <optional>
#include <random>

#include "surface/fit/group_solve.h"

/// Internal to the fits.
namespace seaway::fit {

/// How octaves are laid out before a solver moves them.
struct GroupLayout {
  std::size_t octaves = 8;
  double power = 0.5;              // centres at quantiles of S^power
  double overlap = 1.25;           // bandwidth over the room between neighbours
  bool directions = false;         // from the target, else as below
  double toward = 0.0;             // rad
  double directionalWidth = 0.35;  // rad
};

/// Octaves at quantiles of a power of the target, with variances from the density there. Where the
/// target has directions, neighbours lean to either side of its mean direction by its spread.
GroupState startGroups(const GroupTarget& target, const GroupLayout& layout,
                       const GroupLimits& limits, double depth);

/// Multiplies variances by e^u, u uniform in ± `scatter`.
void scatterVariances(GroupState& state, double scatter, std::mt19937_64& random);

/// Moves centres by up to a bandwidth and bandwidths by up to e^±0.5.
void scatterShapes(GroupState& state, const GroupLimits& limits, std::mt19937_64& random);

}  // namespace seaway::fit
