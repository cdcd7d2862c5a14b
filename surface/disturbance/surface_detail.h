#pragma once

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <vector>

#include "surface/disturbance/analytic/ripple_pool.h"
#include "surface/disturbance/layers/surface_layer.h"
#include "surface/surface_sample.h"

namespace seaway {

/// What lies on the water or ripples it, beside waves and wakes, about one time: layers of foam,
/// smoothed water and oil, and pools of ripples. Immutable as readers hold it.
struct SurfaceDetail {
  SurfaceCover cover;
  std::vector<std::shared_ptr<const RippleSheet>> ripples;

  /// Waves below this are damped by smoothed water and oil, m: octaves whose dominant wavelength is
  /// shorter fall to (1 − cover) of their height.
  static constexpr double dampedWavelength = 2.0;

  bool empty() const { return cover.empty() && ripples.empty(); }
  bool smooths() const { return cover.smooth || cover.oil; }
  double heightBound() const {
    double bound = 0.0;
    for (const auto& sheet : ripples) bound += sheet->heightBound();
    return bound;
  }

  /// Part of the short waves that is damped at `points`: 1 − (1 − smooth)(1 − oil), into `out`;
  /// `scratch` of the same size. Returns whether any is above 0.
  bool dampedAt(std::span<const glm::dvec2> points, double t, std::span<float> out,
                std::span<float> scratch) const noexcept {
    std::fill(out.begin(), out.end(), 0.0f);
    float largest = 0.0f;
    for (const auto* layer : {cover.smooth.get(), cover.oil.get()}) {
      if (!layer) continue;
      layer->sample(points, t, scratch);
      for (std::size_t i = 0; i < points.size(); ++i) {
        out[i] += (1.0f - out[i]) * scratch[i];
        largest = std::max(largest, out[i]);
      }
    }
    return largest > 0.0f;
  }
};

/// Damps the short waves in samples of waves where smoothed water or oil lies.
/// `sampleWaves(points, out, options)` samples the waves alone. No allocation.
template <class SampleWaves>
void dampShortWaves(const SurfaceDetail& detail, std::span<const glm::dvec2> points, double t,
                    std::span<SurfaceSample> out, SampleOptions options,
                    const SampleWaves& sampleWaves) noexcept {
  if (!detail.smooths() || options.shortestWavelength >= SurfaceDetail::dampedWavelength) return;
  constexpr std::size_t most = 128;
  std::array<float, most> damped, scratch;
  std::array<SurfaceSample, most> longer;
  options.shortestWavelength = SurfaceDetail::dampedWavelength;
  for (std::size_t first = 0; first < points.size(); first += most) {
    const auto some = points.subspan(first, std::min(most, points.size() - first));
    const std::size_t count = some.size();
    if (!detail.dampedAt(some, t, std::span(damped).first(count),
                         std::span(scratch).first(count))) {
      continue;
    }
    sampleWaves(some, std::span(longer).first(count), options);
    for (std::size_t i = 0; i < count; ++i) {
      if (damped[i] == 0.0f) continue;
      SurfaceSample& sample = out[first + i];
      const auto part = static_cast<double>(damped[i]);
      sample.height = glm::mix(sample.height, longer[i].height, part);
      sample.slope = glm::mix(sample.slope, longer[i].slope, part);
      sample.verticalVelocity = glm::mix(sample.verticalVelocity, longer[i].verticalVelocity, part);
      sample.orbitalVelocity = glm::mix(sample.orbitalVelocity, longer[i].orbitalVelocity, part);
    }
  }
}

}  // namespace seaway
