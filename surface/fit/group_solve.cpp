#include "surface/fit/group_solve.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace seaway::fit {
namespace {

constexpr double wholeVarianceWeight = 10.0;
constexpr double bandMomentWeight = 4.0;
/// Relative to the first moments': measured second moments scatter more, and shape little.
constexpr double secondMomentWeight = 0.1;
/// The relative deviation of wave numbers in the tail, against the absolute one: at 0.1 it reaches
/// 4 % for JONSWAP with 12 octaves; 0.2 would cost twice the residual for γ = 1.
constexpr double deviationInTail = 0.1;
constexpr std::size_t wholeRows = 3;

/// A value between two positive ends, from any number.
template <typename T>
T between(const T& x, double low, double high) {
  using std::exp;
  return low * exp(std::log(high / low) / (1.0 + exp(-x)));
}

/// Its inverse; ends are kept a little off, where the slope would vanish.
double unbound(double value, double low, double high) {
  const double share = std::clamp(std::log(value / low) / std::log(high / low), 0.02, 0.98);
  return std::log(share / (1.0 - share));
}

/// Shapes as the solver sees them: M numbers an octave, M = 2 where directions are held.
template <int M>
struct Coordinates {
  static void pack(const GroupShape<double>& shape, const GroupLimits& limits, double* x) {
    x[0] = unbound(shape.frequency, limits.lowest, limits.highest);
    x[1] = unbound(shape.bandwidth / shape.frequency, limits.narrowest, limits.widest);
    if constexpr (M == 4) {
      x[2] = shape.toward;
      x[3] = unbound(shape.directionalWidth, limits.sharpest, limits.broadest);
    }
  }

  template <typename T>
  static GroupShape<T> unpack(const T* x, const GroupShape<double>& held,
                              const GroupLimits& limits) {
    GroupShape<T> shape;
    shape.frequency = between(x[0], limits.lowest, limits.highest);
    shape.bandwidth = shape.frequency * between(x[1], limits.narrowest, limits.widest);
    if constexpr (M == 4) {
      shape.toward = x[2];
      shape.directionalWidth = between(x[3], limits.sharpest, limits.broadest);
    } else {
      shape.toward = T(held.toward);
      shape.directionalWidth = T(held.directionalWidth);
    }
    return shape;
  }
};

enum class Channel { energy, deviation, east, north, difference, cross };

template <typename T>
const T& pick(const GroupReading<T>& reading, Channel channel) {
  switch (channel) {
    case Channel::energy:
      return reading.energy;
    case Channel::deviation:
      return reading.deviation;
    case Channel::east:
      return reading.east;
    case Channel::north:
      return reading.north;
    case Channel::difference:
      return reading.difference;
    case Channel::cross:
      return reading.cross;
  }
  return reading.energy;
}

/// A row of residuals for every point: a reading, what it should be, and how much it counts.
struct ChannelRows {
  Channel channel;
  std::vector<double> target;
  std::vector<double> scale;  // 0 where the target is not known
};

/// Rows of residuals that are linear in the octaves' readings, and what they need.
struct Rows {
  Rows(const GroupTarget& target, const GroupSolveOptions& options);

  std::vector<ChannelRows> channels;
  double gridScale = 0.0;
  double tail = 0.0;   // weight of a tail's row
  double floor = 0.0;  // 1/Hz, added to S where it divides
  double secondMoment = 0.0, zerothMoment = 0.0;

  std::size_t tailStart(std::size_t points) const { return channels.size() * points; }
  std::size_t gridStart(std::size_t points) const { return tailStart(points) + 2 * points; }
  std::size_t count(const GroupTarget& target) const {
    return gridStart(target.points()) + target.grid.size() + wholeRows;
  }
};

Rows::Rows(const GroupTarget& target, const GroupSolveOptions& options) {
  const std::size_t points = target.points();
  const double highest = *std::max_element(target.density.begin(), target.density.end());
  floor = 1e-3 * highest;
  tail = std::sqrt(options.tailWeight / static_cast<double>(points));
  zerothMoment = target.moment(0, target.density);
  secondMoment = target.moment(2, target.density);
  const double norm = target.squareNorm();
  std::vector<double> plain(points), leaning(points);
  for (std::size_t p = 0; p < points; ++p) {
    plain[p] = std::sqrt(target.weight[p] / norm);
    // Directions matter in the tail too: there they count by √S rather than S.
    leaning[p] = options.directionWeight * plain[p] *
                 std::sqrt(0.5 * highest / (target.density[p] + 0.1 * highest));
  }
  const auto add = [&](Channel channel, const std::vector<double>& wanted,
                       const std::vector<double>& scale, double weight) {
    if (wanted.empty() || weight == 0.0) return;
    ChannelRows rows{channel, wanted, scale};
    for (std::size_t p = 0; p < points; ++p) {
      rows.scale[p] *= weight;
      if (!std::isfinite(wanted[p])) rows.target[p] = rows.scale[p] = 0.0;
    }
    channels.push_back(std::move(rows));
  };
  add(Channel::energy, target.density, plain, 1.0);
  add(Channel::deviation, std::vector<double>(points, 0.0), plain, options.deviationWeight);
  if (!target.grid.empty()) {
    gridScale = std::sqrt(2.0 * std::numbers::pi / static_cast<double>(target.direction.size()) /
                          target.gridSquareNorm());
  } else if (options.freeDirections) {
    add(Channel::east, target.east, leaning, 1.0);
    add(Channel::north, target.north, leaning, 1.0);
    add(Channel::difference, target.difference, leaning, secondMomentWeight);
    add(Channel::cross, target.cross, leaning, secondMomentWeight);
  }
}

template <int M>
class GroupCost final : public ceres::CostFunction {
 public:
  GroupCost(const GroupTarget& target, const GroupState& start, const GroupSolveOptions& options)
      : target_(target), start_(start), options_(options), rows_(target, options) {
    set_num_residuals(static_cast<int>(rows_.count(target)));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(start.octaves()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(M * start.octaves()));
  }

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const std::size_t octaves = start_.octaves();
    // A step this far is refused rather than computed: exp would overflow.
    if (*std::max_element(parameters[0], parameters[0] + octaves) > 300.0) return false;
    double* energyJacobian = jacobians ? jacobians[0] : nullptr;
    double* shapeJacobian = jacobians ? jacobians[1] : nullptr;
    const std::size_t count = static_cast<std::size_t>(num_residuals());
    std::fill(residuals, residuals + count, 0.0);
    if (energyJacobian) std::fill(energyJacobian, energyJacobian + count * octaves, 0.0);
    if (shapeJacobian) std::fill(shapeJacobian, shapeJacobian + count * octaves * M, 0.0);
    for (std::size_t i = 0; i < octaves; ++i) {
      const double variance = std::exp(parameters[0][i]);
      const double* x = parameters[1] + M * i;
      const Into into{residuals, energyJacobian, shapeJacobian, i, variance};
      if (shapeJacobian) {
        std::array<Jet, M> jets;
        for (int j = 0; j < M; ++j) jets[static_cast<std::size_t>(j)] = Jet(x[j], j);
        addOctave<Jet>(Coordinates<M>::unpack(jets.data(), start_.shape[i], options_.limits), into);
      } else {
        addOctave<double>(Coordinates<M>::unpack(x, start_.shape[i], options_.limits), into);
      }
    }
    finish(residuals, energyJacobian, shapeJacobian);
    return true;
  }

 private:
  using Jet = ceres::Jet<double, M>;

  struct Into {
    double* residuals;
    double* energyJacobian;
    double* shapeJacobian;
    std::size_t octave;
    double variance;
  };

  static void spread(const Jet& value, double scale, double* slopes) {
    for (int j = 0; j < M; ++j) slopes[j] += scale * value.v[j];
  }
  static void spread(double, double, double*) {}

  template <typename T>
  void addTo(std::size_t row, const T& value, double scale, const Into& into) const {
    const double part = scale * into.variance;
    const std::size_t octaves = start_.octaves();
    into.residuals[row] += part * valueOf(value);
    if (into.energyJacobian) {
      into.energyJacobian[row * octaves + into.octave] += part * valueOf(value);
    }
    if (into.shapeJacobian) {
      spread(value, part, into.shapeJacobian + (row * octaves + into.octave) * M);
    }
  }

  /// Tail rows first hold S and the deviation as they are; `finish` divides.
  template <typename T>
  void addOctave(const GroupShape<T>& shape, const Into& into) const {
    const GroupResponse<T> response(shape, start_.depth);
    const std::size_t points = target_.points(), directions = target_.direction.size();
    const std::size_t tail = rows_.tailStart(points), grid = rows_.gridStart(points);
    const std::size_t whole = grid + target_.grid.size();
    T zeroth(0.0), second(0.0);
    for (std::size_t p = 0; p < points; ++p) {
      const double f = target_.frequency[p];
      if (!response.reaches(f)) continue;
      const GroupReading<T> reading = M == 2 ? response.undirected(f, target_.waveNumber[p])
                                             : response.at(f, target_.waveNumber[p]);
      for (std::size_t c = 0; c < rows_.channels.size(); ++c) {
        addTo(c * points + p, pick(reading, rows_.channels[c].channel), rows_.channels[c].scale[p],
              into);
      }
      addTo(tail + p, reading.energy, 1.0, into);
      addTo(tail + points + p, reading.deviation, 1.0, into);
      zeroth += target_.weight[p] * reading.energy;
      second += target_.weight[p] * f * f * reading.energy;
      const double gridScale = rows_.gridScale * std::sqrt(target_.weight[p]);
      for (std::size_t d = 0; d < directions; ++d) {
        addTo(grid + p * directions + d,
              reading.energy * response.spreadAt(f, target_.direction[d]), gridScale, into);
      }
    }
    addTo(whole, T(1.0), wholeVarianceWeight, into);
    addTo(whole + 1, zeroth, bandMomentWeight / rows_.zerothMoment, into);
    addTo(whole + 2, second, bandMomentWeight / rows_.secondMoment, into);
  }

  void scaleRow(std::size_t row, double scale, double* energyJacobian,
                double* shapeJacobian) const {
    const std::size_t octaves = start_.octaves();
    const auto scaled = [&](double* jacobian, std::size_t width) {
      if (!jacobian) return;
      for (std::size_t i = 0; i < width; ++i) jacobian[row * width + i] *= scale;
    };
    scaled(energyJacobian, octaves);
    scaled(shapeJacobian, octaves * M);
  }

  /// Takes the targets off, and makes the tail's rows relative.
  void finish(double* residuals, double* energyJacobian, double* shapeJacobian) const {
    const std::size_t points = target_.points();
    const std::size_t tail = rows_.tailStart(points), grid = rows_.gridStart(points);
    const std::size_t directions = target_.direction.size();
    for (std::size_t c = 0; c < rows_.channels.size(); ++c) {
      const ChannelRows& rows = rows_.channels[c];
      for (std::size_t p = 0; p < points; ++p) {
        residuals[c * points + p] -= rows.scale[p] * rows.target[p];
      }
    }
    for (std::size_t p = 0; p < points; ++p) {
      const double model = residuals[tail + p] + rows_.floor;
      const double wanted = target_.density[p] + rows_.floor;
      residuals[tail + p] = rows_.tail * std::log(model / wanted);
      scaleRow(tail + p, rows_.tail / model, energyJacobian, shapeJacobian);
      const double relative = deviationInTail * options_.deviationWeight * rows_.tail / wanted;
      residuals[tail + points + p] *= relative;
      scaleRow(tail + points + p, relative, energyJacobian, shapeJacobian);
    }
    for (std::size_t i = 0; i < target_.grid.size(); ++i) {
      residuals[grid + i] -=
          rows_.gridScale * std::sqrt(target_.weight[i / directions]) * target_.grid[i];
    }
    double* whole = residuals + grid + target_.grid.size();
    whole[0] -= wholeVarianceWeight;
    whole[1] -= bandMomentWeight;
    whole[2] -= bandMomentWeight;
  }

  const GroupTarget& target_;
  const GroupState& start_;
  const GroupSolveOptions& options_;
  Rows rows_;
};

template <int M>
GroupSolution solve(const GroupTarget& target, GroupState& state,
                    const GroupSolveOptions& options) {
  const std::size_t octaves = state.octaves();
  std::vector<double> logVariance(octaves), shapes(M * octaves);
  for (std::size_t i = 0; i < octaves; ++i) {
    logVariance[i] = std::log(state.variance[i]);
    Coordinates<M>::pack(state.shape[i], options.limits, &shapes[M * i]);
  }
  GroupCost<M> cost(target, state, options);
  ceres::Problem::Options problemOptions;
  problemOptions.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(problemOptions);
  problem.AddResidualBlock(&cost, nullptr, logVariance.data(), shapes.data());
  if (!options.freeShapes) problem.SetParameterBlockConstant(shapes.data());
  ceres::Solver::Options solver;
  solver.max_num_iterations = options.maxIterations;
  solver.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  // Variances alone are cheap, and where shapes start from; shapes gain little beyond this.
  solver.function_tolerance = options.freeShapes ? 1e-3 : 1e-9;
  solver.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(solver, &problem, &summary);
  for (std::size_t i = 0; i < octaves; ++i) {
    state.variance[i] = std::exp(logVariance[i]);
    if (options.freeShapes) {
      state.shape[i] = Coordinates<M>::unpack(&shapes[M * i], state.shape[i], options.limits);
    }
  }
  return {summary.final_cost, static_cast<int>(summary.iterations.size()),
          summary.IsSolutionUsable() && std::isfinite(summary.final_cost), summary.message};
}

}  // namespace

GroupSolution solveGroups(const GroupTarget& target, GroupState& state,
                          const GroupSolveOptions& options) {
  return options.freeDirections ? solve<4>(target, state, options)
                                : solve<2>(target, state, options);
}

GroupCurves curvesOf(const GroupTarget& target, const GroupState& state) {
  GroupCurves curves;
  curves.reading.resize(target.points(), {});
  curves.grid.resize(target.grid.size(), 0.0);
  const std::size_t directions = target.direction.size();
  for (std::size_t i = 0; i < state.octaves(); ++i) {
    const GroupResponse<double> response(state.shape[i], state.depth);
    const double variance = state.variance[i];
    for (std::size_t p = 0; p < target.points(); ++p) {
      const double f = target.frequency[p];
      if (!response.reaches(f)) continue;
      const GroupReading<double> reading = response.at(f, target.waveNumber[p]);
      GroupReading<double>& sum = curves.reading[p];
      for (const auto part : {&GroupReading<double>::energy, &GroupReading<double>::deviation,
                              &GroupReading<double>::slopes, &GroupReading<double>::east,
                              &GroupReading<double>::north, &GroupReading<double>::difference,
                              &GroupReading<double>::cross}) {
        sum.*part += variance * (reading.*part);
      }
      for (std::size_t d = 0; d < directions; ++d) {
        curves.grid[p * directions + d] +=
            variance * reading.energy * response.spreadAt(f, target.direction[d]);
      }
    }
  }
  return curves;
}

}  // namespace seaway::fit
