#include "surface/fit/octave_fit.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <optional>

#include "surface/constants.h"
#include "surface/dispersion.h"
#include "surface/field/perlin_spectrum.h"
#include "surface/input_error.h"

namespace seaway {
namespace {

constexpr std::size_t fitPoints = 600;

/// An octave with less than this share of the variance is nothing: 1e-10 changes H_m0 by 5e-11.
constexpr double negligibleShare = 1e-10;

/// The target on a grid uniform in frequency, seen over wave number κ in cycles per metre.
struct WaveNumberTarget {
  std::vector<double> frequency;   // Hz
  std::vector<double> kappa;       // cycles/m
  std::vector<double> density;     // m²/(cycles/m)
  std::vector<double> groupSpeed;  // dκ → df, m/s
  std::vector<double> weight;      // trapezoid dκ
  double squareNorm = 0.0;         // ∫S² dκ
};

WaveNumberTarget overWaveNumber(const FrequencySpectrum& target, double depth) {
  WaveNumberTarget result;
  for (std::size_t i = 0; i < fitPoints; ++i) {
    const double fraction = static_cast<double>(i) / (fitPoints - 1);
    const double f = target.lowest() + fraction * (target.highest() - target.lowest());
    const double k = waveNumber(2.0 * pi * f, depth);
    result.frequency.push_back(f);
    result.kappa.push_back(k / (2.0 * pi));
    result.groupSpeed.push_back(groupSpeed(k, depth));
    result.density.push_back(target.at(f) * result.groupSpeed.back());
  }
  for (std::size_t i = 0; i < fitPoints; ++i) {
    const double below = result.kappa[i > 0 ? i - 1 : i];
    const double above = result.kappa[std::min(i + 1, fitPoints - 1)];
    result.weight.push_back(0.5 * (above - below));
    result.squareNorm += result.weight[i] * result.density[i] * result.density[i];
  }
  return result;
}

/// Spectra of unit-variance octaves on the target's wave numbers, [octave][point].
using Basis = std::vector<std::vector<double>>;

Basis perlinBasis(const WaveNumberTarget& target, const std::vector<double>& latticeSizes) {
  Basis basis;
  for (const double lattice : latticeSizes) {
    std::vector<double> spectrum;
    for (const double kappa : target.kappa) {
      spectrum.push_back(lattice * perlinWaveNumberDensity(kappa * lattice));
    }
    basis.push_back(std::move(spectrum));
  }
  return basis;
}

std::vector<double> modelDensity(const Basis& basis, const std::vector<double>& logVariance) {
  std::vector<double> model(fitPoints, 0.0);
  for (std::size_t i = 0; i < basis.size(); ++i) {
    const double variance = std::exp(logVariance[i]);
    for (std::size_t p = 0; p < fitPoints; ++p) model[p] += variance * basis[i][p];
  }
  return model;
}

double relativeResidual(const WaveNumberTarget& target, const std::vector<double>& model) {
  double sum = 0.0;
  for (std::size_t p = 0; p < fitPoints; ++p) {
    const double difference = model[p] - target.density[p];
    sum += target.weight[p] * difference * difference;
  }
  return std::sqrt(sum / target.squareNorm);
}

/// Residuals: √dκ (M − S)/‖S‖ at every point, then √(w/n) ln((M + ε)/(S + ε)).
class SpectrumResidual final : public ceres::CostFunction {
 public:
  SpectrumResidual(const WaveNumberTarget& target, const Basis& basis, double tailWeight)
      : target_(target), basis_(basis), tail_(std::sqrt(tailWeight / fitPoints)) {
    floor_ = 1e-3 * *std::max_element(target.density.begin(), target.density.end());
    set_num_residuals(2 * fitPoints);
    mutable_parameter_block_sizes()->push_back(static_cast<int>(basis.size()));
  }

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const std::size_t count = basis_.size();
    const std::vector<double> logVariance(parameters[0], parameters[0] + count);
    // A step this far is refused rather than computed: exp would overflow.
    if (*std::max_element(logVariance.begin(), logVariance.end()) > 300.0) return false;
    const std::vector<double> model = modelDensity(basis_, logVariance);
    for (std::size_t p = 0; p < fitPoints; ++p) {
      const double scale = std::sqrt(target_.weight[p] / target_.squareNorm);
      residuals[p] = scale * (model[p] - target_.density[p]);
      residuals[fitPoints + p] =
          tail_ * std::log((model[p] + floor_) / (target_.density[p] + floor_));
      if (!jacobians || !jacobians[0]) continue;
      for (std::size_t i = 0; i < count; ++i) {
        const double change = std::exp(logVariance[i]) * basis_[i][p];
        jacobians[0][p * count + i] = scale * change;
        jacobians[0][(fitPoints + p) * count + i] = tail_ * change / (model[p] + floor_);
      }
    }
    return true;
  }

 private:
  const WaveNumberTarget& target_;
  const Basis& basis_;
  double tail_;
  double floor_;
};

struct Trial {
  std::vector<double> latticeSizes;
  std::vector<double> logVariance;
  std::vector<double> model;
  double residual = std::numeric_limits<double>::infinity();
  int iterations = 0;
  bool solved = false;
  std::string message;
};

/// Start: the target's variance in each octave's band around its peak; a little where there is none.
std::vector<double> bandIntegrals(const WaveNumberTarget& target,
                                  const std::vector<double>& latticeSizes, double lacunarity,
                                  double variance) {
  std::vector<double> start;
  for (const double lattice : latticeSizes) {
    const double centre = perlinPeakCyclesPerCell / lattice;
    double band = 0.0;
    for (std::size_t p = 0; p < fitPoints; ++p) {
      const double ratio = target.kappa[p] / centre;
      if (ratio * ratio * lacunarity < 1.0 || ratio * ratio > lacunarity) continue;
      band += target.weight[p] * target.density[p];
    }
    start.push_back(std::log(std::max(band, 1e-4 * variance)));
  }
  return start;
}

/// An octave beyond the band would have nothing to fit: neighbours stand closer instead.
double lacunarityWithin(const WaveNumberTarget& target, double firstLattice,
                        const OctaveFitOptions& options) {
  if (options.octaves == 1) return options.lacunarity;
  const double firstCentre = perlinPeakCyclesPerCell / firstLattice;
  const double fitting = std::pow(target.kappa.back() / firstCentre, 1.0 / (options.octaves - 1));
  return std::min(options.lacunarity, fitting);
}

Trial solve(const WaveNumberTarget& target, double firstLattice, double variance,
            const OctaveFitOptions& options) {
  Trial trial;
  const double lacunarity = lacunarityWithin(target, firstLattice, options);
  for (int i = 0; i < options.octaves; ++i) {
    trial.latticeSizes.push_back(firstLattice / std::pow(lacunarity, i));
  }
  const Basis basis = perlinBasis(target, trial.latticeSizes);
  trial.logVariance = bandIntegrals(target, trial.latticeSizes, lacunarity, variance);

  ceres::Problem::Options problemOptions;
  problemOptions.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  SpectrumResidual cost(target, basis, options.tailWeight);
  ceres::Problem problem(problemOptions);
  problem.AddResidualBlock(&cost, nullptr, trial.logVariance.data());
  ceres::Solver::Options solverOptions;
  solverOptions.max_num_iterations = options.maxIterations;
  solverOptions.linear_solver_type = ceres::DENSE_QR;
  solverOptions.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(solverOptions, &problem, &summary);

  double total = 0.0;
  for (const double value : trial.logVariance) total += std::exp(value);
  for (double& value : trial.logVariance) value += std::log(variance / total);
  trial.model = modelDensity(basis, trial.logVariance);
  trial.residual = relativeResidual(target, trial.model);
  trial.iterations = static_cast<int>(summary.iterations.size());
  trial.solved = summary.IsSolutionUsable() && std::isfinite(trial.residual);
  trial.message = summary.message;
  return trial;
}

/// Wave number (cycles/m) below which a share of the target's variance lies.
double quantile(const WaveNumberTarget& target, double share) {
  double total = 0.0, sum = 0.0;
  for (std::size_t p = 0; p < fitPoints; ++p) total += target.weight[p] * target.density[p];
  for (std::size_t p = 0; p < fitPoints; ++p) {
    sum += target.weight[p] * target.density[p];
    if (sum >= share * total) return target.kappa[p];
  }
  return target.kappa.back();
}

/// Where the first octave's peak should stand is not known beforehand: tries from the target's
/// lowest energy up to its median.
Trial bestTrial(const WaveNumberTarget& target, double variance, const OctaveFitOptions& options) {
  const double low = quantile(target, 0.01), high = quantile(target, 0.5);
  Trial best;
  for (int i = 0; i < options.latticeTrials; ++i) {
    const double fraction = options.latticeTrials > 1 ? static_cast<double>(i) / (options.latticeTrials - 1) : 0.5;
    const double centre = low * std::pow(high / low, fraction);
    Trial trial = solve(target, perlinPeakCyclesPerCell / centre, variance, options);
    if (trial.solved && trial.residual < best.residual) best = std::move(trial);
    else if (!best.solved) best.message = trial.message;
  }
  return best;
}

void check(const OctaveFitOptions& options) {
  if (options.octaves < 1 || options.octaves > 32) {
    throw InputError("octaves " + std::to_string(options.octaves) + " is not allowed; must be in [1, 32]");
  }
  if (!(options.lacunarity > 1.0)) throw InputError("lacunarity must be > 1");
  if (!(options.depth > 0.0)) throw InputError("depth must be > 0 m");
  if (!(options.tailWeight >= 0.0)) throw InputError("tail weight must be >= 0");
  if (options.maxIterations < 1 || options.latticeTrials < 1) {
    throw InputError("iterations and lattice trials must be >= 1");
  }
}

}  // namespace

OctaveFit fitPerlinOctaves(const FrequencySpectrum& target, const OctaveFitOptions& options) {
  check(options);
  OctaveFit fit;
  if (const auto problem = target.validate()) {
    fit.summary.message = "the target is not valid: " + *problem;
    return fit;
  }
  const double variance = target.moment(0);
  if (!(variance > 0.0)) {
    fit.summary.message = "the target has no energy";
    return fit;
  }
  const WaveNumberTarget overK = overWaveNumber(target, options.depth);
  const Trial best = bestTrial(overK, variance, options);
  fit.summary.message = best.message;
  if (!best.solved) return fit;

  for (std::size_t i = 0; i < best.latticeSizes.size(); ++i) {
    const double share = std::exp(best.logVariance[i]) / variance;
    const double standardDeviation = share < negligibleShare ? 0.0 : std::exp(0.5 * best.logVariance[i]);
    fit.octaves.push_back(makePerlinOctave(standardDeviation, best.latticeSizes[i], options.toward,
                                           options.depth));
  }
  fit.model.frequency = overK.frequency;
  for (std::size_t p = 0; p < fitPoints; ++p) {
    fit.model.density.push_back(best.model[p] / overK.groupSpeed[p]);
  }
  double fitted = 0.0;
  for (const Octave& octave : fit.octaves) {
    fitted += octave.standardDeviation * octave.standardDeviation;
  }
  OctaveFitSummary& summary = fit.summary;
  summary.usable = true;
  summary.iterations = best.iterations;
  summary.residualL2 = best.residual;
  summary.hm0Target = target.significantWaveHeight();
  summary.hm0Fit = 4.0 * std::sqrt(fitted);
  summary.tm02Target = target.zeroCrossingPeriod();
  summary.tm02Fit = fit.model.zeroCrossingPeriod();
  summary.tpTarget = target.peakPeriod();
  summary.tpFit = fit.model.peakPeriod();
  return fit;
}

}  // namespace seaway
