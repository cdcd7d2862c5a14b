#include "sim_bridge/service/wave_arrays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <type_traits>

#include "sim_bridge/service/side_by_side.h"

namespace seaway::bridge {
namespace {

/// As many points as the field's kernels take at once: what is between stays in the first cache.
constexpr std::size_t block = 256;

/// Points of a block and what they are told beside the field's sums.
template <class Real>
struct Told {
  std::span<const double> x, y;
  double error;
  SampleStatus common;
  WaveArrays<Real> out;  // from the block's first point on

  glm::dvec2 point(std::size_t i) const { return {x[i], y[i]}; }

  bool allServed(double t) const noexcept {
    bool all = WaveField::serves({0.0, 0.0}, t);
    for (std::size_t i = 0; i < x.size(); ++i) {
      all &= (std::abs(x[i]) <= WaveField::farthest) & (std::abs(y[i]) <= WaveField::farthest);
    }
    return all;
  }

  void tellAll(const WaveField& waves) const noexcept {
    const auto status = common | (error > 0.0 ? SampleStatus::truncated : SampleStatus::ok);
    if (out.error) std::fill_n(out.error, x.size(), static_cast<Real>(error));
    if (out.status) std::fill_n(out.status, x.size(), static_cast<std::uint32_t>(status));
    if (!out.bound) return;
    for (std::size_t i = 0; i < x.size(); ++i) {
      out.bound[i] = static_cast<Real>(waves.bound(glm::length(point(i))));
    }
  }

  /// Of the others, as WaveField::sample has it.
  void tellUnserved(double t) const noexcept {
    constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (WaveField::serves(point(i), t)) continue;
      const bool finite = std::isfinite(t) && std::isfinite(x[i]) && std::isfinite(y[i]);
      const auto status = common | (finite ? SampleStatus::outOfRange : SampleStatus::notFinite);
      if (out.error) out.error[i] = nan;
      if (out.bound) out.bound[i] = nan;
      if (out.status) out.status[i] = static_cast<std::uint32_t>(status);
    }
  }
};

/// Floats of a block on their way to where they are wanted.
template <class Real>
class Stage {
 public:
  Stage(Real* to, std::size_t count) : to_(to), count_(count) {}
  /// Where the field writes.
  std::span<float> floats() {
    if constexpr (std::is_same_v<Real, float>) {
      if (to_) return {to_, count_};
    }
    return std::span(between_).first(count_);
  }
  void handOver() {
    if constexpr (!std::is_same_v<Real, float>) {
      if (to_) std::copy_n(between_.data(), count_, to_);
    }
  }

 private:
  Real* to_;
  std::size_t count_;
  std::array<float, block> between_;
};

template <class Real>
void sampleBlock(const FieldAtTime& waves, const Told<Real>& told, const SampleOptions& options) {
  const std::size_t count = told.x.size();
  Stage<double> height(told.out.height, count);
  FieldAtTime::Arrays arrays{height.floats(), {}, {}, {}};
  if (options.derivatives) {
    Stage<Real> slopeEast(told.out.slopeEast, count), slopeNorth(told.out.slopeNorth, count);
    Stage<Real> rate(told.out.verticalVelocity, count);
    arrays = {height.floats(), slopeEast.floats(), slopeNorth.floats(), rate.floats()};
    waves.sample(told.x, told.y, arrays, options);
    slopeEast.handOver();
    slopeNorth.handOver();
    rate.handOver();
  } else {
    waves.sample(told.x, told.y, arrays, options);
  }
  height.handOver();
}

double leftOut(const WaveField& field, const SampleOptions& options) {
  return options.tolerance > 0.0 ? field.leftOut(field.octavesFor(options.tolerance))
                                 : field.leftOut(field.octaves().size());
}

}  // namespace

bool isPlain(const SurfaceAtTime& water, const SampleOptions& options) noexcept {
  return !options.orbitalVelocity && options.shortestWavelength == 0.0 && !water.disturbances() &&
         !water.outline() && !water.terrain() && !water.extras().events && !water.extras().detail;
}

template <class Real>
void sampleWaves(const SurfaceAtTime& water, std::span<const double> x, std::span<const double> y,
                 const SampleOptions& options, SampleStatus common,
                 const WaveArrays<Real>& out) noexcept {
  const WaveField& field = water.waves().field();
  const double error = leftOut(field, options);
  for (std::size_t first = 0; first < x.size(); first += block) {
    const std::size_t count = std::min(block, x.size() - first);
    const Told<Real> told{x.subspan(first, count), y.subspan(first, count), error, common,
                          partOf(out, first)};
    sampleBlock(water.waves(), told, options);
    told.tellAll(field);
    if (!told.allServed(water.time())) told.tellUnserved(water.time());
  }
}

LargestFaults largestFaults(const SurfaceAtTime& water, std::span<const double> x,
                            std::span<const double> y, const SampleOptions& options) noexcept {
  if (!WaveField::serves({0.0, 0.0}, water.time())) return {};
  // The bound grows with the distance, which grows with its square.
  const double farthest = largestOf(x.size(), [&](std::size_t i) {
    const bool served =
        (std::abs(x[i]) <= WaveField::farthest) & (std::abs(y[i]) <= WaveField::farthest);
    return served ? x[i] * x[i] + y[i] * y[i] : -1.0;
  });
  if (farthest < 0.0) return {};
  const WaveField& field = water.waves().field();
  return {leftOut(field, options), field.bound(std::sqrt(farthest))};
}

template void sampleWaves(const SurfaceAtTime&, std::span<const double>, std::span<const double>,
                          const SampleOptions&, SampleStatus, const WaveArrays<double>&) noexcept;
template void sampleWaves(const SurfaceAtTime&, std::span<const double>, std::span<const double>,
                          const SampleOptions&, SampleStatus, const WaveArrays<float>&) noexcept;

}  // namespace seaway::bridge
