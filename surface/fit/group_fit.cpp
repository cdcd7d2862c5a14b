#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "surface/fit/field_reading.h"
#include "surface/fit/fit_options.h"
#include "surface/fit/group_start.h"
#include "surface/fit/octave_fit.h"

namespace seaway {
namespace {

using fit::GroupSolution;
using fit::GroupState;
using fit::GroupTarget;

constexpr std::size_t frequencyPoints = 160, momentPoints = 160, gridPoints = 64;

struct Attempt {
  GroupState state;
  GroupSolution solution;
};

bool better(const Attempt& a, const Attempt& b) {
  if (a.solution.solved != b.solution.solved) return a.solution.solved;
  return a.solution.cost < b.solution.cost;
}

bool hasDirections(const DirectionalSpectrum& target) {
  if (target.hasGrid()) return true;
  return std::any_of(target.moments.begin(), target.moments.end(),
                     [](const DirectionalMoments& m) { return m.hasFirst(); });
}

class GroupFitter {
 public:
  GroupFitter(const DirectionalSpectrum& target, const OctaveFitOptions& options)
      : options_(options),
        directional_(hasDirections(target)),
        sampled_(fit::sampleTarget(target, options.depth, pointsFor(target), false)) {
    solve_.limits.lowest = target.energy.lowest();
    solve_.limits.highest = target.energy.highest();
    solve_.limits.narrowest = fit::narrowestBand(target.energy);
    if (target.hasGrid()) {
      // An octave narrower than the grid would fall between its directions.
      solve_.limits.sharpest = 2.0 * pi / static_cast<double>(target.direction.size());
    }
    solve_.tailWeight = options.tailWeight;
    solve_.deviationWeight = options.deviationWeight;
    solve_.maxIterations = options.maxIterations;
  }

  Attempt best() const {
    std::mt19937_64 random(options_.seed);
    Attempt best = attempt(start(0.5, 1.25), random);
    for (int n = 1; n < options_.starts; ++n) {
      constexpr double powers[] = {0.35, 0.65, 0.5};
      GroupState state = start(powers[n % 3], 1.0 + 0.25 * (n % 4));
      if (n > 3) fit::scatterShapes(state, solve_.limits, random);
      Attempt next = attempt(std::move(state), random);
      if (better(next, best)) best = std::move(next);
    }
    return best;
  }

 private:
  std::size_t pointsFor(const DirectionalSpectrum& target) const {
    return target.hasGrid() ? gridPoints : directional_ ? momentPoints : frequencyPoints;
  }

  GroupState start(double power, double overlap) const {
    fit::GroupLayout layout;
    layout.octaves = static_cast<std::size_t>(options_.octaves);
    layout.power = power;
    layout.overlap = overlap;
    layout.directions = directional_;
    layout.toward = options_.toward;
    layout.directionalWidth = options_.directionalWidth;
    return fit::startGroups(sampled_, layout, solve_.limits, options_.depth);
  }

  /// Variances alone first: a convex problem but for the logarithms, so that poor variances do not
  /// push shapes astray.
  Attempt attempt(GroupState state, std::mt19937_64& random) const {
    if (options_.startScatter > 0.0) {
      fit::scatterVariances(state, options_.startScatter, random);
    }
    Attempt result{std::move(state), {}};
    fit::GroupSolveOptions solve = solve_;
    solve.freeShapes = false;
    result.solution = fit::solveGroups(sampled_, result.state, solve);
    revive(result.state);
    result.solution = add(result.solution, fit::solveGroups(sampled_, result.state, solve));
    if (!options_.freeShapes || !result.solution.solved) return result;
    revive(result.state);
    // Rounded, so that starts that agree within the solver's tolerance go on alike: shapes have
    // many minima close to each other, and the last digit would choose among them.
    for (double& variance : result.state.variance) {
      variance = std::exp(0.1 * std::round(10.0 * std::log(variance)));
    }
    solve.freeShapes = true;
    solve.freeDirections = directional_;
    result.solution = add(result.solution, fit::solveGroups(sampled_, result.state, solve));
    return result;
  }

  /// An octave that came out at nothing would have no slope to come back by.
  static void revive(GroupState& state) {
    for (double& variance : state.variance) variance = std::max(variance, 1e-4);
  }

  static GroupSolution add(const GroupSolution& before, GroupSolution now) {
    now.iterations += before.iterations;
    return now;
  }

  const OctaveFitOptions& options_;
  bool directional_;
  GroupTarget sampled_;
  fit::GroupSolveOptions solve_;
};

/// The octaves at the target's H_m0, from long waves to short.
std::vector<Octave> octavesOf(const GroupState& state, double variance) {
  const double total = std::accumulate(state.variance.begin(), state.variance.end(), 0.0);
  std::vector<std::size_t> order(state.octaves());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return state.shape[a].frequency < state.shape[b].frequency;
  });
  std::vector<Octave> octaves;
  for (const std::size_t i : order) {
    const double share = state.variance[i] / total;
    const auto& shape = state.shape[i];
    octaves.push_back(makeGroupOctave(
        share < fit::negligibleShare ? 0.0 : std::sqrt(share * variance), shape.frequency,
        shape.bandwidth, shape.toward, shape.directionalWidth, state.depth));
  }
  return octaves;
}

double relativeL2(const std::vector<double>& model, const std::vector<double>& target,
                  const std::vector<double>& weight, double scale) {
  const std::size_t each = target.size() / weight.size();
  double sum = 0.0, norm = 0.0;
  for (std::size_t i = 0; i < target.size(); ++i) {
    const double wanted = target[i] * scale;
    sum += weight[i / each] * (model[i] - wanted) * (model[i] - wanted);
    norm += weight[i / each] * wanted * wanted;
  }
  return std::sqrt(sum / norm);
}

void summariseDirections(const GroupTarget& judged, OctaveFit& result) {
  if (judged.east.empty()) return;
  double energy = 0.0, turned = 0.0, spread = 0.0;
  for (std::size_t p = 0; p < judged.points(); ++p) {
    const double s = judged.density[p];
    const DirectionalMoments wanted{judged.east[p] / s, judged.north[p] / s};
    if (!(s > 0.0) || !wanted.hasFirst()) continue;
    const DirectionalMoments& read = result.model.moments[p];
    if (!read.hasFirst()) continue;
    const double weight = judged.weight[p] * s;
    const double angle = std::remainder(read.meanDirection() - wanted.meanDirection(), 2.0 * pi);
    energy += weight;
    turned += weight * angle * angle;
    spread += weight * std::pow(read.spread() - wanted.spread(), 2);
  }
  if (!(energy > 0.0)) return;
  result.summary.directionError = std::sqrt(turned / energy);
  result.summary.spreadError = std::sqrt(spread / energy);
}

void summarise(const DirectionalSpectrum& target, const OctaveFitOptions& options,
               const GroupSolution& solution, OctaveFit& result) {
  const GroupTarget judged = fit::sampleTarget(target, options.depth, fit::judgedPoints, true);
  FieldReading reading = readField(result.octaves, judged.frequency, 0, options.depth);
  result.model = std::move(reading.spectrum);
  OctaveFitSummary& summary = result.summary;
  summary.usable = true;
  summary.iterations = solution.iterations;
  summary.cost = solution.cost;
  summary.residualL2 =
      relativeL2(result.model.energy.density, judged.density, judged.weight, judged.variance);
  summary.waveNumberDeviation = reading.waveNumberDeviation;
  fit::summariseMoments(target.energy, result);
  summariseDirections(judged, result);
  if (!target.hasGrid()) return;
  result.model.direction = target.direction;
  result.model.density = fit::curvesOf(judged, fit::stateOf(result.octaves, options.depth)).grid;
  summary.residualGrid =
      relativeL2(result.model.density, judged.grid, judged.weight, judged.variance);
}

}  // namespace

OctaveFit fitGroupOctaves(const DirectionalSpectrum& target, const OctaveFitOptions& options) {
  fit::check(options);
  OctaveFit result;
  if (auto problem = fit::problemOf(target.energy)) {
    result.summary.message = *problem;
    return result;
  }
  if (auto problem = target.validate()) {
    result.summary.message = "the target is not valid: " + *problem;
    return result;
  }
  const Attempt best = GroupFitter(target, options).best();
  result.summary.message = best.solution.message;
  if (!best.solution.solved) return result;
  result.octaves = octavesOf(best.state, target.energy.moment(0));
  summarise(target, options, best.solution, result);
  return result;
}

OctaveFit fitGroupOctaves(const FrequencySpectrum& target, const OctaveFitOptions& options) {
  DirectionalSpectrum plain;
  plain.energy = target;
  return fitGroupOctaves(plain, options);
}

std::vector<OctaveFit> fitGroupOctaves(std::span<const DirectionalSpectrum> targets,
                                       const OctaveFitOptions& options) {
  fit::check(options);
  std::vector<OctaveFit> fits(targets.size());
  tbb::parallel_for(std::size_t{0}, targets.size(),
                    [&](std::size_t i) { fits[i] = fitGroupOctaves(targets[i], options); });
  return fits;
}

}  // namespace seaway
