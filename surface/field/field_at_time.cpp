#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "surface/field/tile.h"
#include "surface/field/wave_field.h"

namespace seaway {

FieldAtTime::FieldAtTime(const WaveField& field, double t) : field_(&field), time_(t) {
  if (!field.serves({0.0, 0.0}, t)) return;  // no section: `blank` marks every sample
  sections_.resize(FieldSection::count(field.lists()));
  for (std::size_t s = 0; s < sections_.size(); ++s) sections_[s].prepare(field.lists(), s, t);
}

void FieldAtTime::sample(std::span<const glm::dvec2> points, std::span<SurfaceSample> out,
                         const SampleOptions& options) const noexcept {
  const WaveField::Selection selection = field_->select(options);
  Tile tile(selection.orbital);
  for (std::size_t first = 0; first < points.size(); first += pointsPerTile) {
    const std::size_t count = std::min(pointsPerTile, points.size() - first);
    tile.load(points.subspan(first, count));
    for (const FieldSection& section : sections_) {
      section.addBatch(selection.kept, tile.x(), tile.y(), count, tile.sums());
    }
    field_->finish(points.subspan(first, count), time_, selection, tile,
                   out.subspan(first, count));
  }
}

SurfaceSample FieldAtTime::sample(glm::dvec2 point, const SampleOptions& options) const noexcept {
  const WaveField::Selection selection = field_->select(options);
  SurfaceSample result = field_->blank(point, time_, selection);
  if (std::isnan(result.height)) return result;
  float height = 0.0f, slopeX = 0.0f, slopeY = 0.0f, rate = 0.0f, orbitalX = 0.0f, orbitalY = 0.0f;
  const bool orbital = selection.orbital;
  const FieldSums sums{&height, &slopeX, &slopeY, &rate, orbital ? &orbitalX : nullptr,
                       orbital ? &orbitalY : nullptr};
  for (const FieldSection& section : sections_) {
    section.addPoint(selection.kept, point.x, point.y, sums);
  }
  result.height = height;
  result.slope = {slopeX, slopeY};
  result.verticalVelocity = rate;
  result.bound = field_->bound(glm::length(point));
  if (orbital && !has(result.status, SampleStatus::noKinematics)) {
    result.orbitalVelocity = {orbitalX, orbitalY,
                              result.verticalVelocity +
                                  glm::dot(field_->settings().current, result.slope)};
  }
  return result;
}

void FieldAtTime::sample(std::span<const double> x, std::span<const double> y, const Arrays& out,
                         const SampleOptions& options) const noexcept {
  const KeptOctaves kept = field_->select(options).kept;
  Tile tile(false);
  for (std::size_t first = 0; first < x.size(); first += pointsPerTile) {
    const std::size_t count = std::min(pointsPerTile, x.size() - first);
    tile.load(x.subspan(first, count), y.subspan(first, count));
    const FieldSums sums = tile.sums();
    for (const FieldSection& section : sections_) {
      section.addBatch(kept, tile.x(), tile.y(), count, sums);
    }
    const bool whole = tile.allServed() && !sections_.empty();
    const auto copy = [&](const float* from, std::span<float> to) {
      if (to.empty()) return;
      std::copy(from, from + count, to.begin() + static_cast<std::ptrdiff_t>(first));
      for (std::size_t i = 0; !whole && i < count; ++i) {
        if (!field_->serves({x[first + i], y[first + i]}, time_)) to[first + i] = std::nanf("");
      }
    };
    copy(sums.height, out.height);
    copy(sums.slopeX, out.slopeX);
    copy(sums.slopeY, out.slopeY);
    copy(sums.rate, out.rate);
  }
}

}  // namespace seaway
