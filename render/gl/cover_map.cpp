#include "render/gl/cover_map.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

#include "render/grid_cover.h"
#include "render/surf.h"

namespace seaway::render {

namespace {

/// The waves that a row carries, as the wave map has them.
void sampleCarried(const SurfaceAtTime& water, std::span<const double> x, std::span<const double> y,
                   const TwinRow& row, const GridWaves& waves) {
  water.waves().sample(x, y, waves, {.shortestWavelength = row.keptWavelength});
  if (row.weight <= 0.0f) return;
  std::array<float, gridChunk> height, slopeX, slopeY;
  water.waves().sample(x, y,
                       {std::span(height).first(x.size()),
                        std::span(slopeX).first(x.size()),
                        std::span(slopeY).first(x.size()),
                        {}},
                       {.shortestWavelength = row.fadingWavelength});
  for (std::size_t i = 0; i < x.size(); ++i) {
    waves.height[i] += row.weight * (height[i] - waves.height[i]);
    waves.slopeX[i] += row.weight * (slopeX[i] - waves.slopeX[i]);
    waves.slopeY[i] += row.weight * (slopeY[i] - waves.slopeY[i]);
  }
}

}  // namespace

void CoverMap::resize(glm::ivec2 size) {
  const auto count = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  if (size != size_) {
    cover_ = GlTexture();
    extras_ = GlTexture();
  }
  size_ = size;
  if (coverIsOn_) {
    if (cover_ == 0) cover_ = makeTexture(GL_RGBA8, size, GL_LINEAR);
    covers_.assign(count, 0u);
  }
  if (extrasAreOn_) {
    if (extras_ == 0) extras_ = makeTexture(GL_RGBA32F, size, GL_LINEAR);
    added_.assign(count, glm::vec4(0.0f));
  }
}

void CoverMap::fill(const View& view, std::span<const TwinRow> rows, int columns) {
  const SurfaceExtras& extras = view.water->extras();
  const SurfaceDetail* detail = extras.detail.get();
  const std::optional<Surf> surf = surfOf(view);
  coverIsOn_ = mayHaveCover(extras, surf ? &*surf : nullptr);
  const bool splashes = extras.events && !extras.events->splashesAbout(view.time).empty();
  extrasAreOn_ = splashes || (detail && (!detail->ripples.empty() || detail->smooths()));
  if (!coverIsOn_ && !extrasAreOn_) return;
  resize({columns, static_cast<int>(rows.size())});
  const SurfaceAtTime now = view.water->at(view.time);
  const glm::dvec2 foot(view.camera.position);
  tbb::parallel_for(0, size_.y, [&](int row) {
    fillRow(now, foot, rows[static_cast<std::size_t>(row)], surf ? &*surf : nullptr, row);
  });
  if (coverIsOn_) {
    glTextureSubImage2D(cover_, 0, 0, 0, size_.x, size_.y, GL_RGBA, GL_UNSIGNED_BYTE,
                        covers_.data());
  }
  if (extrasAreOn_) {
    glTextureSubImage2D(extras_, 0, 0, 0, size_.x, size_.y, GL_RGBA, GL_FLOAT, added_.data());
  }
}

void CoverMap::fillRow(const SurfaceAtTime& water, glm::dvec2 foot, const TwinRow& row,
                       const Surf* surf, int index) {
  std::array<double, gridChunk> x, y;
  std::array<float, gridChunk> height, slopeX, slopeY;
  GridCover cover;
  for (int first = 0; first < size_.x; first += gridChunk) {
    const int count = std::min(gridChunk, size_.x - first);
    for (int i = 0; i < count; ++i) {
      const glm::dvec2 point = foot + glm::dvec2(row.point(first + i));
      x[i] = point.x, y[i] = point.y;
    }
    const auto some = static_cast<std::size_t>(count);
    const std::span<const double> xs(x.data(), some), ys(y.data(), some);
    cover.sample(water, xs, ys);
    if (surf) cover.addSurf(*surf, water, xs, ys, row.keptWavelength);
    const std::size_t at = static_cast<std::size_t>(index) * size_.x + first;
    for (std::size_t i = 0; cover.any && i < some; ++i) covers_[at + i] = cover.packed(i);
    if (!extrasAreOn_) continue;
    const GridWaves waves{std::span(height).first(some),
                          std::span(slopeX).first(some),
                          std::span(slopeY).first(some),
                          {}};
    // What is added to the waves that are there: with damping, the difference that it makes.
    const bool damps = cover.any && cover.damps;
    if (damps) {
      sampleCarried(water, xs, ys, row, waves);
    } else {
      for (const auto& values : {waves.height, waves.slopeX, waves.slopeY}) {
        std::fill(values.begin(), values.end(), 0.0f);
      }
    }
    const auto before = std::array{height, slopeX, slopeY};
    addExtras(water, xs, ys, row.keptWavelength, cover, waves);
    for (std::size_t i = 0; i < some; ++i) {
      const glm::vec4 all(height[i], slopeX[i], slopeY[i], 0.0f);
      added_[at + i] =
          damps ? all - glm::vec4(before[0][i], before[1][i], before[2][i], 0.0f) : all;
    }
  }
}

std::size_t CoverMap::memoryBytes() const {
  const auto texels = static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y);
  return (cover_ != 0 ? texels * 4 : 0) + (extras_ != 0 ? texels * 16 : 0) +
         covers_.capacity() * sizeof(std::uint32_t) + added_.capacity() * sizeof(glm::vec4);
}

}  // namespace seaway::render
