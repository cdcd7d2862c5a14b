#include "surface/fit/octave_fit.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "surface/constants.h"
#include "surface/dispersion.h"
#include "surface/field/group_spectrum.h"
#include "surface/field/perlin_spectrum.h"
#include "surface/fit/spectral_solve.h"
#include "surface/input_error.h"

namespace seaway {
namespace {

constexpr std::size_t fitPoints = 600;

/// An octave with less than this share of the variance is nothing: 1e-10 changes H_m0 by 5e-11.
constexpr double negligibleShare = 1e-10;

/// The target on points uniform in frequency, and what one of them is in the spectrum that is
/// fitted: frequency itself, or wave number κ in cycles per metre with S(κ) = S(f) df/dκ.
struct GriddedTarget {
  std::vector<double> frequency;  // Hz
  std::vector<double> abscissa;   // Hz or cycles/m
  std::vector<double> perHertz;   // density in the abscissa per density in frequency: 1 or c_g
  SampledTarget sampled;
  double variance = 0.0;  // m²
};

GriddedTarget gridded(const FrequencySpectrum& target, double depth, bool overWaveNumber) {
  GriddedTarget result;
  for (std::size_t i = 0; i < fitPoints; ++i) {
    const double fraction = static_cast<double>(i) / (fitPoints - 1);
    const double f = target.lowest() + fraction * (target.highest() - target.lowest());
    const double k = waveNumber(2.0 * pi * f, depth);
    result.frequency.push_back(f);
    result.abscissa.push_back(overWaveNumber ? k / (2.0 * pi) : f);
    result.perHertz.push_back(overWaveNumber ? groupSpeed(k, depth) : 1.0);
    result.sampled.density.push_back(target.at(f) * result.perHertz.back());
  }
  for (std::size_t i = 0; i < fitPoints; ++i) {
    const double below = result.abscissa[i > 0 ? i - 1 : i];
    const double above = result.abscissa[std::min(i + 1, fitPoints - 1)];
    result.sampled.weight.push_back(0.5 * (above - below));
  }
  result.variance = target.moment(0);
  return result;
}

/// Abscissa below which a share of the integral of `density`^`power` lies.
double quantile(const GriddedTarget& target, double share, double power = 1.0) {
  std::vector<double> cumulative;
  double sum = 0.0;
  for (std::size_t p = 0; p < fitPoints; ++p) {
    sum += target.sampled.weight[p] * std::pow(target.sampled.density[p], power);
    cumulative.push_back(sum);
  }
  const auto at = std::lower_bound(cumulative.begin(), cumulative.end(), share * sum);
  return target.abscissa[std::min<std::size_t>(static_cast<std::size_t>(at - cumulative.begin()), fitPoints - 1)];
}

/// Octaves before their variances are known: where each stands, how wide it is, and its spectrum.
struct Trial {
  std::vector<double> centre;  // abscissa
  std::vector<double> width;   // perlin: lattice size, m; group: bandwidth, Hz
  SpectralBasis basis;
  SpectralSolution solution;
};

void solve(Trial& trial, const GriddedTarget& target, const OctaveFitOptions& options) {
  // Start: the target's density at each centre times the room to its neighbours.
  std::vector<double> start;
  for (std::size_t i = 0; i < trial.centre.size(); ++i) {
    const double peak = *std::max_element(trial.basis[i].begin(), trial.basis[i].end());
    const auto at = std::lower_bound(target.abscissa.begin(), target.abscissa.end(), trial.centre[i]);
    const std::size_t p = std::min<std::size_t>(static_cast<std::size_t>(at - target.abscissa.begin()), fitPoints - 1);
    const double variance = peak > 0.0 ? target.sampled.density[p] / peak : 0.0;
    start.push_back(std::clamp(variance, 1e-4 * target.variance, target.variance));
  }
  trial.solution = solveVariances(target.sampled, trial.basis, start, target.variance,
                                  options.tailWeight, options.maxIterations);
}

/// The trial of least residual; of none solved, the last.
Trial best(std::vector<Trial> trials) {
  const auto better = [](const Trial& a, const Trial& b) {
    if (a.solution.solved != b.solution.solved) return a.solution.solved;
    return a.solution.residual < b.solution.residual;
  };
  return std::move(*std::min_element(trials.begin(), trials.end(), better));
}

/// Where the first octave's peak should stand is not known beforehand: tries from the target's
/// lowest energy up to its median. An octave beyond the band would have nothing to fit: where so
/// many would pass its end they stand closer.
Trial bestPerlin(const GriddedTarget& target, const OctaveFitOptions& options) {
  const double low = quantile(target, 0.01), high = quantile(target, 0.5);
  std::vector<Trial> trials;
  for (int n = 0; n < options.latticeTrials; ++n) {
    const double fraction =
        options.latticeTrials > 1 ? static_cast<double>(n) / (options.latticeTrials - 1) : 0.5;
    const double first = low * std::pow(high / low, fraction);
    double lacunarity = options.lacunarity;
    if (options.octaves > 1) {
      lacunarity = std::min(lacunarity, std::pow(target.abscissa.back() / first,
                                                 1.0 / (options.octaves - 1)));
    }
    Trial trial;
    for (int i = 0; i < options.octaves; ++i) {
      trial.centre.push_back(first * std::pow(lacunarity, i));
      const double lattice = perlinPeakCyclesPerCell / trial.centre.back();
      trial.width.push_back(lattice);
      std::vector<double> spectrum;
      for (const double kappa : target.abscissa) {
        spectrum.push_back(lattice * perlinWaveNumberDensity(kappa * lattice));
      }
      trial.basis.push_back(std::move(spectrum));
    }
    solve(trial, target, options);
    trials.push_back(std::move(trial));
  }
  return best(std::move(trials));
}

/// Centres crowd where the target is high (quantiles of a power of it); widths are a multiple of
/// the room to their neighbours. The best of a few powers and multiples is kept. Wider octaves would
/// follow S(f) still closer, but short ones then leak into the peak with wave numbers that are not
/// the peak's: slopes and spread go wrong while the residual looks right.
Trial bestGroup(const GriddedTarget& target, const OctaveFitOptions& options) {
  std::vector<Trial> trials;
  for (const double power : {0.35, 0.5, 0.65}) {
    for (const double overlap : {1.0, 1.25, 1.55}) {
      Trial trial;
      const auto count = static_cast<std::size_t>(options.octaves);
      for (std::size_t i = 0; i < count; ++i) {
        trial.centre.push_back(quantile(target, (static_cast<double>(i) + 0.5) / static_cast<double>(count), power));
      }
      for (std::size_t i = 0; i < count; ++i) {
        const double left = i > 0 ? trial.centre[i - 1] : target.abscissa.front();
        const double right = i + 1 < count ? trial.centre[i + 1] : target.abscissa.back();
        const double room = (right - left) / (i > 0 && i + 1 < count ? 2.0 : 1.5);
        const double narrowest = 1e-3 * trial.centre[i];
        trial.width.push_back(std::max(overlap * room, narrowest));
        const double cellsPerHertz = groupBandCycles / trial.width[i];
        std::vector<double> spectrum;
        for (const double f : target.abscissa) {
          spectrum.push_back(cellsPerHertz * groupEnvelopeDensity((f - trial.centre[i]) * cellsPerHertz));
        }
        trial.basis.push_back(std::move(spectrum));
      }
      solve(trial, target, options);
      trials.push_back(std::move(trial));
    }
  }
  return best(std::move(trials));
}

void check(const OctaveFitOptions& options) {
  if (options.octaves < 1 || options.octaves > 64) {
    throw InputError("octaves " + std::to_string(options.octaves) +
                     " is not allowed; must be in [1, 64]");
  }
  if (!(options.lacunarity > 1.0)) throw InputError("lacunarity must be > 1");
  if (!(options.depth > 0.0)) throw InputError("depth must be > 0 m");
  if (!(options.tailWeight >= 0.0)) throw InputError("tail weight must be >= 0");
  if (!(options.directionalWidth > 0.0 && options.directionalWidth <= pi)) {
    throw InputError("directional width must be in (0, pi] rad");
  }
  if (options.maxIterations < 1 || options.latticeTrials < 1) {
    throw InputError("iterations and lattice trials must be >= 1");
  }
}

std::optional<std::string> problemOf(const FrequencySpectrum& target) {
  if (const auto problem = target.validate()) return "the target is not valid: " + *problem;
  if (!(target.moment(0) > 0.0)) return "the target has no energy";
  return std::nullopt;
}

void summarise(const FrequencySpectrum& target, const GriddedTarget& grid,
               const SpectralSolution& solution, OctaveFit& fit) {
  fit.model.frequency = grid.frequency;
  for (std::size_t p = 0; p < fitPoints; ++p) {
    fit.model.density.push_back(solution.model[p] / grid.perHertz[p]);
  }
  double fitted = 0.0;
  for (const Octave& octave : fit.octaves) {
    fitted += octave.standardDeviation * octave.standardDeviation;
  }
  OctaveFitSummary& summary = fit.summary;
  summary.usable = true;
  summary.iterations = solution.iterations;
  summary.residualL2 = solution.residual;
  summary.hm0Target = target.significantWaveHeight();
  summary.hm0Fit = 4.0 * std::sqrt(fitted);
  summary.tm02Target = target.zeroCrossingPeriod();
  summary.tm02Fit = fit.model.zeroCrossingPeriod();
  summary.tpTarget = target.peakPeriod();
  summary.tpFit = fit.model.peakPeriod();
}

/// Makes an octave of a standard deviation (m) at a trial's place.
using MakeOctave = std::function<Octave(double standardDeviation, double centre, double width)>;

OctaveFit fitOctaves(const FrequencySpectrum& target, const OctaveFitOptions& options,
                     bool overWaveNumber,
                     const std::function<Trial(const GriddedTarget&)>& bestTrial,
                     const MakeOctave& make) {
  check(options);
  OctaveFit fit;
  if (const auto problem = problemOf(target)) {
    fit.summary.message = *problem;
    return fit;
  }
  const GriddedTarget grid = gridded(target, options.depth, overWaveNumber);
  const Trial trial = bestTrial(grid);
  fit.summary.message = trial.solution.message;
  if (!trial.solution.solved) return fit;
  for (std::size_t i = 0; i < trial.centre.size(); ++i) {
    const double variance = trial.solution.variance[i];
    const bool negligible = variance < negligibleShare * grid.variance;
    fit.octaves.push_back(make(negligible ? 0.0 : std::sqrt(variance), trial.centre[i], trial.width[i]));
  }
  summarise(target, grid, trial.solution, fit);
  return fit;
}

}  // namespace

OctaveFit fitPerlinOctaves(const FrequencySpectrum& target, const OctaveFitOptions& options) {
  return fitOctaves(
      target, options, true, [&](const GriddedTarget& grid) { return bestPerlin(grid, options); },
      [&](double standardDeviation, double, double latticeSize) {
        return makePerlinOctave(standardDeviation, latticeSize, options.toward, options.depth);
      });
}

OctaveFit fitGroupOctaves(const FrequencySpectrum& target, const OctaveFitOptions& options) {
  return fitOctaves(
      target, options, false, [&](const GriddedTarget& grid) { return bestGroup(grid, options); },
      [&](double standardDeviation, double frequency, double bandwidth) {
        return makeGroupOctave(standardDeviation, frequency, bandwidth, options.toward,
                               options.directionalWidth, options.depth);
      });
}

}  // namespace seaway
