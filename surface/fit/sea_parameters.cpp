#include "surface/fit/sea_parameters.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "surface/constants.h"
#include "surface/fit/fit_options.h"
#include "surface/input_error.h"

namespace seaway {
namespace {

constexpr std::size_t perSystem = 3;  // ln H_m0, ln T_p, ln γ
constexpr double highestEnhancement = 20.0;

/// jonswapShape over x = f/f_p, in units where f_p = 1.
template <typename T>
T shapeAt(const T& x, const T& logGamma) {
  using std::exp;
  const T x2 = x * x, off = x - 1.0;
  const double sigma = x < 1.0 ? 0.07 : 0.09;
  return exp(-1.25 / (x2 * x2) + logGamma * exp(-0.5 / (sigma * sigma) * off * off)) /
         (x2 * x2 * x);
}

/// ∫ shape dx, 0.3 … 8: of unit peak frequency. Trapezoids in ln x, where it is smooth.
template <typename T>
T shapeIntegral(const T& logGamma) {
  constexpr int steps = 160;
  const double low = std::log(0.3), step = (std::log(8.0) - low) / steps;
  T sum(0.0);
  for (int i = 0; i <= steps; ++i) {
    const double x = std::exp(low + step * i);
    sum += (i % steps == 0 ? 0.5 : 1.0) * step * x * shapeAt(T(x), logGamma);
  }
  return sum;
}

/// Density of one system from its three parameters, m²/Hz.
template <typename T>
class SystemDensity {
 public:
  explicit SystemDensity(const T* p) : period_(exp(p[1])), logGamma_(p[2]) {
    scale_ = exp(2.0 * p[0]) / 16.0 * period_ / shapeIntegral(logGamma_);
  }
  T at(double f) const { return scale_ * shapeAt(T(f * period_), logGamma_); }

 private:
  static T exp(const T& x) {
    using std::exp;
    return exp(x);
  }
  T period_, logGamma_, scale_;
};

/// sign(S − M) √(ν (S/M − ln(S/M) − 1)) of u = ln(S/M): √ν u √((eᵘ − 1 − u)/u²), by series near 0.
template <typename T>
T devianceResidual(const T& u, double degrees) {
  using std::exp, std::sqrt;
  const bool small = u < 0.01 && u > -0.01;
  const T ratio = small ? 0.5 + u * (1.0 / 6.0 + u / 24.0) : (exp(u) - 1.0 - u) / (u * u);
  return std::sqrt(degrees) * u * sqrt(ratio);
}

struct Bins {
  std::vector<double> frequency, density;
  /// Added to S and M: where both are this far below the peak, on a spectrum's steep front, neither
  /// says anything of the sea.
  double floor = 0.0;
};

template <int systems>
struct DevianceCost {
  const Bins* bins;
  double degrees;

  template <typename T>
  bool operator()(const T* p, T* residuals) const {
    using std::log;
    std::vector<SystemDensity<T>> density;
    for (std::size_t j = 0; j < systems; ++j) {
      // A step this far is refused rather than computed: exp would overflow.
      if (!(p[perSystem * j] < 50.0) || !(p[perSystem * j] > -100.0)) return false;
      density.emplace_back(p + perSystem * j);
    }
    for (std::size_t i = 0; i < bins->frequency.size(); ++i) {
      T model(bins->floor);
      for (const auto& system : density) model += system.at(bins->frequency[i]);
      residuals[i] = devianceResidual(T(log(bins->density[i] + bins->floor) - log(model)), degrees);
    }
    return true;
  }
};

struct SpectralFit {
  std::vector<double> parameters;
  std::vector<double> covariance;  // row-major; empty where it could not be had
  double deviance = std::numeric_limits<double>::infinity();
  int iterations = 0;
};

template <int systems>
SpectralFit solveSystems(const Bins& bins, std::vector<double> start,
                         const SeaParameterOptions& options, double lowest, double highest) {
  constexpr int count = systems * static_cast<int>(perSystem);
  using Cost = ceres::AutoDiffCostFunction<DevianceCost<systems>, ceres::DYNAMIC, count>;
  ceres::Problem problem;
  problem.AddResidualBlock(new Cost(new DevianceCost<systems>{&bins, options.degreesOfFreedom},
                                    static_cast<int>(bins.frequency.size())),
                           nullptr, start.data());
  for (int j = 0; j < systems; ++j) {
    const int at = j * static_cast<int>(perSystem);
    problem.SetParameterLowerBound(start.data(), at + 1, -std::log(highest));
    problem.SetParameterUpperBound(start.data(), at + 1, -std::log(lowest));
    problem.SetParameterLowerBound(start.data(), at + 2, 0.0);
    problem.SetParameterUpperBound(start.data(), at + 2, std::log(highestEnhancement));
  }
  ceres::Solver::Options solver;
  solver.max_num_iterations = options.maxIterations;
  solver.linear_solver_type = ceres::DENSE_QR;
  solver.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(solver, &problem, &summary);
  SpectralFit fit;
  fit.iterations = static_cast<int>(summary.iterations.size());
  if (!summary.IsSolutionUsable()) return fit;
  fit.parameters = start;
  fit.deviance = 2.0 * summary.final_cost;
  ceres::Covariance::Options covarianceOptions;
  covarianceOptions.algorithm_type = ceres::DENSE_SVD;
  covarianceOptions.null_space_rank = -1;
  ceres::Covariance covariance(covarianceOptions);
  if (covariance.Compute({start.data()}, &problem)) {
    fit.covariance.resize(count * count);
    covariance.GetCovarianceBlock(start.data(), start.data(), fit.covariance.data());
  }
  return fit;
}

/// H_m0, T_p, γ in logarithms, of the part of a spectrum within [from, to).
std::vector<double> startOf(const Bins& bins, std::size_t from, std::size_t to) {
  double variance = 0.0;
  std::size_t peak = from;
  for (std::size_t i = from; i < to; ++i) {
    const double below = bins.frequency[i > 0 ? i - 1 : i];
    const double above = bins.frequency[std::min(i + 1, bins.frequency.size() - 1)];
    variance += 0.5 * (above - below) * bins.density[i];
    if (bins.density[i] > bins.density[peak]) peak = i;
  }
  return {std::log(4.0 * std::sqrt(variance)), -std::log(bins.frequency[peak]), std::log(2.0)};
}

SpectralFit fitOne(const Bins& bins, const SeaParameterOptions& options, double lowest,
                   double highest) {
  return solveSystems<1>(bins, startOf(bins, 0, bins.frequency.size()), options, lowest, highest);
}

/// Splits the band at several shares of its bins; the best is kept.
SpectralFit fitTwo(const Bins& bins, const SeaParameterOptions& options, double lowest,
                   double highest) {
  SpectralFit best;
  const std::size_t count = bins.frequency.size();
  for (const double share : {0.2, 0.35, 0.5, 0.65}) {
    const auto split = std::clamp<std::size_t>(
        static_cast<std::size_t>(share * static_cast<double>(count)), 2, count - 2);
    std::vector<double> start = startOf(bins, 0, split);
    const std::vector<double> high = startOf(bins, split, count);
    start.insert(start.end(), high.begin(), high.end());
    SpectralFit fit = solveSystems<2>(bins, start, options, lowest, highest);
    if (fit.deviance < best.deviance) best = std::move(fit);
  }
  return best;
}

double aicOf(const SpectralFit& fit, int systems) {
  return fit.deviance + 2.0 * static_cast<double>(perSystem) * systems;
}

/// Mean moment r₁ and r₂ of cos²ˢ(θ/2).
template <typename T>
T r1Of(const T& s) {
  return s / (s + 1.0);
}
template <typename T>
T r2Of(const T& s) {
  return s * (s - 1.0) / ((s + 1.0) * (s + 2.0));
}

/// Residuals of a₁ and b₁ at one bin: shares of the systems there, and how much it counts.
struct DirectionCost {
  std::array<double, 2> share;
  DirectionalMoments measured;
  double weight;

  template <typename T>
  bool operator()(const T* p, T* residuals) const {
    using std::cos, std::exp, std::sin;
    T a(0.0), b(0.0);
    for (std::size_t j = 0; j < 2; ++j) {
      if (share[j] == 0.0) continue;
      const T r1 = r1Of(exp(p[2 * j + 1]));
      a += share[j] * r1 * cos(p[2 * j]);
      b += share[j] * r1 * sin(p[2 * j]);
    }
    residuals[0] = weight * (a - measured.a1);
    residuals[1] = weight * (b - measured.b1);
    return true;
  }
};

/// Directions and spreading of systems whose densities are known.
void fitDirections(const DirectionalSpectrum& target, const SeaParameterOptions& options,
                   const std::vector<SystemDensity<double>>& density, SeaParameters& result) {
  const std::size_t systems = density.size(), count = target.energy.frequency.size();
  if (target.moments.empty()) return;
  std::array<double, 2> peak{};
  std::array<double, 2> east{}, north{}, energy{};
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < systems; ++j) {
      const double s = density[j].at(target.energy.frequency[i]);
      peak[j] = std::max(peak[j], s);
      if (!target.moments[i].hasFirst()) continue;
      double all = 0.0;
      for (const auto& other : density) all += other.at(target.energy.frequency[i]);
      if (!(s > 0.5 * all)) continue;
      east[j] += s * target.moments[i].a1;
      north[j] += s * target.moments[i].b1;
      energy[j] += s;
    }
  }
  std::array<double, 4> p{};
  for (std::size_t j = 0; j < systems; ++j) {
    if (!(energy[j] > 0.0)) return;
    const double r1 = std::clamp(std::hypot(east[j], north[j]) / energy[j], 0.1, 0.99);
    p[2 * j] = std::atan2(north[j], east[j]);
    p[2 * j + 1] = std::log(r1 / (1.0 - r1));
  }
  ceres::Problem problem;
  std::size_t rows = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (!target.moments[i].hasFirst()) continue;
    std::array<double, 2> share{};
    double all = 0.0, weight = 0.0;
    for (std::size_t j = 0; j < systems; ++j) {
      share[j] = density[j].at(target.energy.frequency[i]);
      all += share[j];
      weight = std::max(weight, share[j] / peak[j]);
    }
    if (!(all > 0.0) || weight < 0.05) continue;
    for (double& part : share) part /= all;
    const double s = std::exp(p[share[0] >= share[1] ? 1 : 3]);
    const double r1 = r1Of(s), r2 = r2Of(s);
    const double variance =
        0.5 * ((1.0 + r2 - 2.0 * r1 * r1) + (1.0 - r2)) / options.degreesOfFreedom;
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<DirectionCost, 2, 4>(new DirectionCost{
                                 share, target.moments[i], std::sqrt(weight / variance)}),
                             nullptr, p.data());
    rows += 2;
  }
  if (rows < 2 * systems + 2) return;
  for (int j = 0; j < static_cast<int>(systems); ++j) {
    problem.SetParameterLowerBound(p.data(), 2 * j + 1, std::log(0.1));
    problem.SetParameterUpperBound(p.data(), 2 * j + 1, std::log(200.0));
  }
  ceres::Solver::Options solver;
  solver.max_num_iterations = options.maxIterations;
  solver.linear_solver_type = ceres::DENSE_QR;
  solver.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(solver, &problem, &summary);
  if (!summary.IsSolutionUsable()) return;
  ceres::Covariance::Options covarianceOptions;
  covarianceOptions.algorithm_type = ceres::DENSE_SVD;
  covarianceOptions.null_space_rank = -1;
  ceres::Covariance covariance(covarianceOptions);
  std::array<double, 16> matrix{};
  const bool known = covariance.Compute({p.data()}, &problem) &&
                     covariance.GetCovarianceBlock(p.data(), p.data(), matrix.data());
  // Seas whose direction turns with frequency scatter more than sampling alone would.
  const double scatter =
      std::max(1.0, 2.0 * summary.final_cost / static_cast<double>(rows - 2 * systems));
  const auto deviation = [&](std::size_t n) {
    return known ? std::sqrt(scatter * matrix[5 * n]) : std::nan("");
  };
  for (std::size_t j = 0; j < systems; ++j) {
    const double s = std::exp(p[2 * j + 1]);
    result.systems[j].toward = {std::remainder(p[2 * j], 2.0 * pi), deviation(2 * j)};
    result.systems[j].spreadExponent = {s, s * deviation(2 * j + 1)};
  }
}

WaveSystem systemOf(const SpectralFit& fit, std::size_t j) {
  const std::size_t size = fit.parameters.size();
  const auto estimate = [&](std::size_t n) {
    const std::size_t at = perSystem * j + n;
    const double value = std::exp(fit.parameters[at]);
    const double deviation =
        fit.covariance.empty() ? std::nan("") : std::sqrt(fit.covariance[at * size + at]);
    return Estimate{value, value * deviation};
  };
  WaveSystem system;
  system.significantWaveHeight = estimate(0);
  system.peakPeriod = estimate(1);
  system.peakEnhancement = estimate(2);
  return system;
}

void check(const SeaParameterOptions& options) {
  if (!(options.degreesOfFreedom >= 2.0) || !std::isfinite(options.degreesOfFreedom)) {
    throw InputError("degrees of freedom must be >= 2");
  }
  if (options.systems < 0 || options.systems > 2) throw InputError("systems must be 0, 1 or 2");
  if (options.maxIterations < 1) throw InputError("iterations must be >= 1");
}

void describe(const DirectionalSpectrum& target, const SeaParameterOptions& options,
              const SpectralFit& fit, SeaParameters& result) {
  std::vector<SystemDensity<double>> density;
  const std::size_t systems = fit.parameters.size() / perSystem;
  std::vector<std::size_t> order{0, 1};
  order.resize(systems);
  if (systems == 2 && fit.parameters[1] < fit.parameters[perSystem + 1]) order = {1, 0};
  for (const std::size_t j : order) {
    result.systems.push_back(systemOf(fit, j));
    density.emplace_back(&fit.parameters[perSystem * j]);
  }
  result.model.frequency = target.energy.frequency;
  for (const double f : target.energy.frequency) {
    double sum = 0.0;
    for (const auto& system : density) sum += system.at(f);
    result.model.density.push_back(sum);
  }
  result.usable = true;
  result.deviance = fit.deviance;
  result.iterations = fit.iterations;
  fitDirections(target, options, density, result);
}

}  // namespace

SeaParameters fitSeaParameters(const DirectionalSpectrum& target,
                               const SeaParameterOptions& options) {
  check(options);
  SeaParameters result;
  if (auto problem = fit::problemOf(target.energy)) {
    result.message = *problem;
    return result;
  }
  Bins bins;
  for (std::size_t i = 0; i < target.energy.frequency.size(); ++i) {
    if (!(target.energy.density[i] > 0.0)) {
      ++result.zeroBins;
      continue;
    }
    bins.frequency.push_back(target.energy.frequency[i]);
    bins.density.push_back(target.energy.density[i]);
  }
  result.bins = bins.frequency.size();
  bins.floor = 1e-6 * *std::max_element(bins.density.begin(), bins.density.end());
  const std::size_t needed = options.systems == 2 ? 7 : 4;
  if (result.bins < needed) {
    result.message =
        std::to_string(result.bins) + " bins with energy; the fit needs " + std::to_string(needed);
    return result;
  }
  const double lowest = target.energy.lowest(), highest = target.energy.highest();
  std::optional<SpectralFit> one, two;
  if (options.systems != 2) one = fitOne(bins, options, lowest, highest);
  if (options.systems == 2 || (options.systems == 0 && result.bins >= 7)) {
    two = fitTwo(bins, options, lowest, highest);
  }
  if (one) result.aicOfOne = aicOf(*one, 1);
  if (two) result.aicOfTwo = aicOf(*two, 2);
  const bool useTwo = two && (!one || result.aicOfTwo < result.aicOfOne);
  const SpectralFit& fit = useTwo ? *two : *one;
  if (fit.parameters.empty()) {
    result.message = "the solver found no parameters";
    return result;
  }
  result.aic = useTwo ? result.aicOfTwo : result.aicOfOne;
  describe(target, options, fit, result);
  return result;
}

}  // namespace seaway
