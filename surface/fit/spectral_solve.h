#pragma once

#include <string>
#include <vector>

namespace seaway {

/// A target density on a grid of abscissae, with the weight of each point in an integral.
struct SampledTarget {
  std::vector<double> density;
  std::vector<double> weight;

  /// ∫ S² over the grid.
  double squareNorm() const;
};

/// Spectra of octaves of unit variance on the target's grid, [octave][point].
using SpectralBasis = std::vector<std::vector<double>>;

struct SpectralSolution {
  std::vector<double> variance;  ///< of each octave; adds up to the one asked for
  std::vector<double> model;     ///< on the target's grid
  double residual = 0.0;         ///< √(∫(M − S)²/∫S²)
  int iterations = 0;
  bool solved = false;
  std::string message;
};

/// Least squares of √w (M − S)/‖S‖ at every point, and of √(tailWeight/n) ln((M + ε)/(S + ε)), over
/// x = ln variance (no active bounds), by Ceres; then the sum is scaled to `totalVariance`.
/// `start` are variances > 0.
SpectralSolution solveVariances(const SampledTarget& target, const SpectralBasis& basis,
                                const std::vector<double>& start, double totalVariance,
                                double tailWeight, int maxIterations);

}  // namespace seaway
