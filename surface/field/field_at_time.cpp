#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "surface/field/tile.h"
#include "surface/field/wave_field.h"

namespace seaway {

FieldAtTime::FieldAtTime(const WaveField& field, double t) { moveTo(field, t); }

void FieldAtTime::moveTo(const WaveField& field, double t) {
  field_ = &field;
  time_ = t;
  if (!field.serves({0.0, 0.0}, t)) return sections_.clear();  // `blank` marks every sample
  sections_.resize(FieldSection::count(field.lists()));
  for (std::size_t s = 0; s < sections_.size(); ++s) sections_[s].prepare(field.lists(), s, t);
}

void FieldAtTime::sample(std::span<const glm::dvec2> points, std::span<SurfaceSample> out,
                         const SampleOptions& options) const noexcept {
  const WaveField::Selection selection = field_->select(options);
  Tile tile(selection.what);
  for (std::size_t first = 0; first < points.size(); first += pointsPerTile) {
    const std::size_t count = std::min(pointsPerTile, points.size() - first);
    tile.load(points.subspan(first, count));
    for (const FieldSection& section : sections_) {
      section.addBatch(selection.kept, tile.x(), tile.y(), count, tile.sums());
    }
    field_->finish(points.subspan(first, count), time_, selection, tile, out.subspan(first, count));
  }
}

SurfaceSample FieldAtTime::sample(glm::dvec2 point, const SampleOptions& options) const noexcept {
  const WaveField::Selection selection = field_->select(options);
  SurfaceSample result = field_->blank(point, time_, selection);
  if (std::isnan(result.height)) return result;
  float values[mostSums] = {};
  FieldSums sums{selection.what, {}, nullptr, 0.0f};
  for (std::size_t n = 0; n < mostSums; ++n) sums.sum[n] = &values[n];
  for (const FieldSection& section : sections_) {
    section.addPoint(selection.kept, point.x, point.y, sums);
  }
  storeSums(selection.what, values, field_->settings().current, result);
  result.bound = field_->bound(glm::length(point));
  return result;
}

void FieldAtTime::sample(std::span<const double> x, std::span<const double> y, const Arrays& out,
                         const SampleOptions& options) const noexcept {
  const KeptOctaves kept = field_->select(options).kept;
  const bool heightOnly = out.slopeX.empty() && out.slopeY.empty() && out.rate.empty();
  Tile tile(heightOnly ? Quantities::height : Quantities::surface);
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
    copy(sums.sum[0], out.height);
    if (heightOnly) continue;
    copy(sums.sum[1], out.slopeX);
    copy(sums.sum[2], out.slopeY);
    copy(sums.sum[3], out.rate);
  }
}

void FieldAtTime::sampleBelow(std::span<const glm::dvec2> points, std::span<const float> stretched,
                              const Motion& out, const SampleOptions& options) const noexcept {
  const KeptOctaves kept = field_->select(options).kept;
  const std::size_t count = points.size();
  const bool moves = !out.velocity.empty();
  Tile tile(moves ? Quantities::motion : Quantities::pressure,
            static_cast<float>(field_->settings().depth));
  tile.load(points);
  tile.loadStretched(stretched);
  const FieldSums sums = tile.sums();
  for (const FieldSection& section : sections_) {
    section.addBatch({kept.groups, 0, kept.regulars, kept.shortestWavelength}, tile.x(), tile.y(),
                     count, sums);
  }
  std::copy_n(sums.sum[moves ? 6 : 0], count, out.head.begin());
  for (std::size_t i = 0; moves && i < count; ++i) {
    out.velocity[i] = {sums.sum[0][i], sums.sum[1][i], sums.sum[2][i]};
    out.acceleration[i] = {sums.sum[3][i], sums.sum[4][i], sums.sum[5][i]};
  }
}

}  // namespace seaway
