#include <algorithm>
#include <cmath>

#include "surface/constants.h"
#include "surface/dispersion.h"
#include "surface/field/perlin_spectrum.h"
#include "surface/fit/fit_options.h"
#include "surface/fit/octave_fit.h"
#include "surface/fit/spectral_solve.h"

namespace seaway {
namespace {

constexpr std::size_t fitPoints = fit::judgedPoints;

/// The target on points uniform in frequency, as S(κ) = S(f) df/dκ over wave number κ, cycles/m.
struct GriddedTarget {
  std::vector<double> frequency;   // Hz
  std::vector<double> waveNumber;  // cycles/m
  std::vector<double> perHertz;    // density in wave number per density in frequency: c_g, m/s
  SampledTarget sampled;
  double variance = 0.0;  // m²
};

GriddedTarget gridded(const FrequencySpectrum& target, double depth) {
  GriddedTarget result;
  for (std::size_t i = 0; i < fitPoints; ++i) {
    const double fraction = static_cast<double>(i) / (fitPoints - 1);
    const double f = target.lowest() + fraction * (target.highest() - target.lowest());
    const double k = waveNumber(2.0 * pi * f, depth);
    result.frequency.push_back(f);
    result.waveNumber.push_back(k / (2.0 * pi));
    result.perHertz.push_back(groupSpeed(k, depth));
    result.sampled.density.push_back(target.at(f) * result.perHertz.back());
  }
  for (std::size_t i = 0; i < fitPoints; ++i) {
    const double below = result.waveNumber[i > 0 ? i - 1 : i];
    const double above = result.waveNumber[std::min(i + 1, fitPoints - 1)];
    result.sampled.weight.push_back(0.5 * (above - below));
  }
  result.variance = target.moment(0);
  return result;
}

/// Point of the first wave number at or above κ; of the last, beyond it.
std::size_t pointAt(const GriddedTarget& target, double kappa) {
  const auto at = std::lower_bound(target.waveNumber.begin(), target.waveNumber.end(), kappa);
  return std::min<std::size_t>(static_cast<std::size_t>(at - target.waveNumber.begin()),
                               fitPoints - 1);
}

/// Wave number below which a share of the variance lies.
double quantile(const GriddedTarget& target, double share) {
  std::vector<double> cumulative;
  double sum = 0.0;
  for (std::size_t p = 0; p < fitPoints; ++p) {
    cumulative.push_back(sum += target.sampled.weight[p] * target.sampled.density[p]);
  }
  const auto at = std::lower_bound(cumulative.begin(), cumulative.end(), share * sum);
  return target.waveNumber[std::min<std::size_t>(static_cast<std::size_t>(at - cumulative.begin()),
                                                 fitPoints - 1)];
}

/// Octaves before their variances are known: their peaks (cycles/m), lattices (m) and spectra.
struct Trial {
  std::vector<double> centre, lattice;
  SpectralBasis basis;
  SpectralSolution solution;
};

void solve(Trial& trial, const GriddedTarget& target, const OctaveFitOptions& options) {
  std::vector<double> start;
  for (std::size_t i = 0; i < trial.centre.size(); ++i) {
    const double peak = *std::max_element(trial.basis[i].begin(), trial.basis[i].end());
    const double density = target.sampled.density[pointAt(target, trial.centre[i])];
    const double variance = peak > 0.0 ? density / peak : 0.0;
    start.push_back(std::clamp(variance, 1e-4 * target.variance, target.variance));
  }
  trial.solution = solveVariances(target.sampled, trial.basis, start, target.variance,
                                  options.tailWeight, options.maxIterations);
}

Trial trialFrom(double first, double lacunarity, const GriddedTarget& target,
                const OctaveFitOptions& options) {
  Trial trial;
  for (int i = 0; i < options.octaves; ++i) {
    trial.centre.push_back(first * std::pow(lacunarity, i));
    const double lattice = perlinPeakCyclesPerCell / trial.centre.back();
    trial.lattice.push_back(lattice);
    std::vector<double> spectrum;
    for (const double kappa : target.waveNumber) {
      spectrum.push_back(lattice * perlinWaveNumberDensity(kappa * lattice));
    }
    trial.basis.push_back(std::move(spectrum));
  }
  solve(trial, target, options);
  return trial;
}

/// Where the first octave's peak should stand is not known beforehand: tries from the target's
/// lowest energy up to its median. An octave beyond the band would have nothing to fit: where so
/// many would pass its end they stand closer.
Trial bestTrial(const GriddedTarget& target, const OctaveFitOptions& options) {
  const double low = quantile(target, 0.01), high = quantile(target, 0.5);
  std::vector<Trial> trials;
  for (int n = 0; n < options.latticeTrials; ++n) {
    const double fraction =
        options.latticeTrials > 1 ? static_cast<double>(n) / (options.latticeTrials - 1) : 0.5;
    const double first = low * std::pow(high / low, fraction);
    double lacunarity = options.lacunarity;
    if (options.octaves > 1) {
      lacunarity = std::min(
          lacunarity, std::pow(target.waveNumber.back() / first, 1.0 / (options.octaves - 1)));
    }
    trials.push_back(trialFrom(first, lacunarity, target, options));
  }
  const auto better = [](const Trial& a, const Trial& b) {
    if (a.solution.solved != b.solution.solved) return a.solution.solved;
    return a.solution.residual < b.solution.residual;
  };
  return std::move(*std::min_element(trials.begin(), trials.end(), better));
}

}  // namespace

OctaveFit fitPerlinOctaves(const FrequencySpectrum& target, const OctaveFitOptions& options) {
  fit::check(options);
  OctaveFit result;
  if (const auto problem = fit::problemOf(target)) {
    result.summary.message = *problem;
    return result;
  }
  const GriddedTarget grid = gridded(target, options.depth);
  const Trial trial = bestTrial(grid, options);
  result.summary.message = trial.solution.message;
  if (!trial.solution.solved) return result;
  for (std::size_t i = 0; i < trial.centre.size(); ++i) {
    const double variance = trial.solution.variance[i];
    const bool negligible = variance < fit::negligibleShare * grid.variance;
    result.octaves.push_back(makePerlinOctave(negligible ? 0.0 : std::sqrt(variance),
                                              trial.lattice[i], options.toward, options.depth));
  }
  result.model.energy.frequency = grid.frequency;
  for (std::size_t p = 0; p < fitPoints; ++p) {
    result.model.energy.density.push_back(trial.solution.model[p] / grid.perHertz[p]);
  }
  result.summary.usable = true;
  result.summary.iterations = trial.solution.iterations;
  result.summary.residualL2 = trial.solution.residual;
  fit::summariseMoments(target, result);
  return result;
}

}  // namespace seaway
