#include "surface/fit/spectral_solve.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>

namespace seaway {
namespace {

std::vector<double> modelDensity(const SpectralBasis& basis, const std::vector<double>& variance) {
  std::vector<double> model(basis.front().size(), 0.0);
  for (std::size_t i = 0; i < basis.size(); ++i) {
    for (std::size_t p = 0; p < model.size(); ++p) model[p] += variance[i] * basis[i][p];
  }
  return model;
}

class SpectrumResidual final : public ceres::CostFunction {
 public:
  SpectrumResidual(const SampledTarget& target, const SpectralBasis& basis, double tailWeight)
      : target_(target),
        basis_(basis),
        points_(target.density.size()),
        norm_(target.squareNorm()),
        tail_(std::sqrt(tailWeight / static_cast<double>(points_))) {
    floor_ = 1e-3 * *std::max_element(target.density.begin(), target.density.end());
    set_num_residuals(static_cast<int>(2 * points_));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(basis.size()));
  }

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const std::size_t count = basis_.size();
    std::vector<double> variance(parameters[0], parameters[0] + count);
    // A step this far is refused rather than computed: exp would overflow.
    if (*std::max_element(variance.begin(), variance.end()) > 300.0) return false;
    for (double& value : variance) value = std::exp(value);
    const std::vector<double> model = modelDensity(basis_, variance);
    for (std::size_t p = 0; p < points_; ++p) {
      const double scale = std::sqrt(target_.weight[p] / norm_);
      residuals[p] = scale * (model[p] - target_.density[p]);
      residuals[points_ + p] =
          tail_ * std::log((model[p] + floor_) / (target_.density[p] + floor_));
      if (!jacobians || !jacobians[0]) continue;
      for (std::size_t i = 0; i < count; ++i) {
        const double change = variance[i] * basis_[i][p];
        jacobians[0][p * count + i] = scale * change;
        jacobians[0][(points_ + p) * count + i] = tail_ * change / (model[p] + floor_);
      }
    }
    return true;
  }

 private:
  const SampledTarget& target_;
  const SpectralBasis& basis_;
  std::size_t points_;
  double norm_;
  double tail_;
  double floor_ = 0.0;
};

double relativeResidual(const SampledTarget& target, const std::vector<double>& model) {
  double sum = 0.0;
  for (std::size_t p = 0; p < model.size(); ++p) {
    const double difference = model[p] - target.density[p];
    sum += target.weight[p] * difference * difference;
  }
  return std::sqrt(sum / target.squareNorm());
}

}  // namespace

double SampledTarget::squareNorm() const {
  double sum = 0.0;
  for (std::size_t p = 0; p < density.size(); ++p) sum += weight[p] * density[p] * density[p];
  return sum;
}

SpectralSolution solveVariances(const SampledTarget& target, const SpectralBasis& basis,
                                const std::vector<double>& start, double totalVariance,
                                double tailWeight, int maxIterations) {
  std::vector<double> logVariance;
  for (const double value : start) logVariance.push_back(std::log(value));
  ceres::Problem::Options problemOptions;
  problemOptions.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  SpectrumResidual cost(target, basis, tailWeight);
  ceres::Problem problem(problemOptions);
  problem.AddResidualBlock(&cost, nullptr, logVariance.data());
  ceres::Solver::Options options;
  options.max_num_iterations = maxIterations;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);

  SpectralSolution solution;
  double total = 0.0;
  for (const double value : logVariance) total += std::exp(value);
  for (const double value : logVariance) {
    solution.variance.push_back(std::exp(value) * totalVariance / total);
  }
  solution.model = modelDensity(basis, solution.variance);
  solution.residual = relativeResidual(target, solution.model);
  solution.iterations = static_cast<int>(summary.iterations.size());
  solution.solved = summary.IsSolutionUsable() && std::isfinite(solution.residual);
  solution.message = summary.message;
  return solution;
}

}  // namespace seaway
