#include "render/grid_cover.h"

#include <algorithm>
#include <glm/common.hpp>
#include <iterator>
#include <limits>

#include "render/surf.h"

namespace seaway::render {
namespace {

const SurfaceCover* coverOf(const SurfaceAtTime& water) {
  const SurfaceDetail* detail = water.extras().detail.get();
  return detail && !detail->cover.empty() ? &detail->cover : nullptr;
}

/// Points are asked about in as many at a time: most of a row lies far from what is left on it.
constexpr std::size_t perBox = 32;

struct Box {
  glm::dvec2 least{std::numeric_limits<double>::infinity()};
  glm::dvec2 most{-std::numeric_limits<double>::infinity()};
};
using Boxes = std::array<Box, (gridChunk + perBox - 1) / perBox>;

/// Around each `perBox` of the points.
Boxes boxesOf(std::span<const glm::dvec2> points) {
  Boxes boxes;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Box& box = boxes[i / perBox];
    box.least = glm::min(box.least, points[i]);
    box.most = glm::max(box.most, points[i]);
  }
  return boxes;
}

}  // namespace

void GridCover::sample(const SurfaceAtTime& water, std::span<const double> x,
                       std::span<const double> y) {
  any = damps = false;
  const SurfaceCover* cover = coverOf(water);
  if (!cover) return;
  const std::size_t count = x.size();
  std::array<glm::dvec2, gridChunk> points;
  for (std::size_t i = 0; i < count; ++i) points[i] = {x[i], y[i]};
  const Boxes boxes = boxesOf(std::span(points).first(count));
  const auto read = [&](const std::shared_ptr<const SurfaceLayer>& layer,
                        std::array<float, gridChunk>& to) {
    bool near = false;
    for (std::size_t first = 0; first < count; first += perBox) {
      const std::size_t some = std::min(perBox, count - first);
      const Box& box = boxes[first / perBox];
      const auto values = std::span(to).subspan(first, some);
      if (layer && layer->mayCover(box.least, box.most, water.time())) {
        layer->sample(std::span(points).subspan(first, some), water.time(), values);
        near = true;
      } else {
        std::fill(values.begin(), values.end(), 0.0f);
      }
    }
    return near;
  };
  const bool foams = read(cover->foam, foam), smooths = read(cover->smooth, smooth);
  const bool oils = read(cover->oil, oil);
  any = foams || smooths || oils;
  damps = smooths || oils;
  for (std::size_t i = 0; damps && i < count; ++i) {
    damped[i] = 1.0f - (1.0f - smooth[i]) * (1.0f - oil[i]);
  }
}

void GridCover::addSurf(const Surf& surf, const SurfaceAtTime& water, std::span<const double> x,
                        std::span<const double> y, double keptWavelength) {
  if (!any) {
    for (auto* values : {&foam, &smooth, &oil}) std::fill_n(values->begin(), x.size(), 0.0f);
  }
  any = surf.addTo(water, x, y, keptWavelength, std::span(foam).first(x.size())) || any;
}

std::uint32_t packCover(glm::vec3 cover) {
  const glm::uvec3 bytes(glm::clamp(cover, 0.0f, 1.0f) * 255.0f + 0.5f);
  return bytes.x | bytes.y << 8 | bytes.z << 16;
}

std::uint32_t GridCover::packed(std::size_t i) const {
  return packCover({foam[i], smooth[i], oil[i]});
}

void addExtras(const SurfaceAtTime& water, std::span<const double> x, std::span<const double> y,
               double keptWavelength, const GridCover& cover, const GridWaves& waves) {
  const SurfaceExtras& extras = water.extras();
  if (cover.any && cover.damps && keptWavelength < SurfaceDetail::dampedWavelength) {
    const auto isDamped = [](float part) { return part != 0.0f; };
    const auto end = cover.damped.begin() + static_cast<std::ptrdiff_t>(x.size());
    const auto from = std::find_if(cover.damped.begin(), end, isDamped);
    const auto to =
        std::find_if(std::make_reverse_iterator(end), std::make_reverse_iterator(from), isDamped)
            .base();
    const auto first = static_cast<std::size_t>(from - cover.damped.begin());
    const auto count = static_cast<std::size_t>(to - from);
    std::array<float, gridChunk> height, slopeX, slopeY;
    water.waves().sample(x.subspan(first, count), y.subspan(first, count),
                         {std::span(height).first(count),
                          std::span(slopeX).first(count),
                          std::span(slopeY).first(count),
                          {}},
                         {.shortestWavelength = SurfaceDetail::dampedWavelength});
    for (std::size_t i = 0; i < count; ++i) {
      const float part = cover.damped[first + i];
      waves.height[first + i] += part * (height[i] - waves.height[first + i]);
      waves.slopeX[first + i] += part * (slopeX[i] - waves.slopeX[first + i]);
      waves.slopeY[first + i] += part * (slopeY[i] - waves.slopeY[first + i]);
    }
  }
  if (extras.events) {
    extras.events->addSplashes(x, y, water.time(), keptWavelength,
                               {waves.height, waves.slopeX, waves.slopeY, {}});
  }
  if (!extras.detail) return;
  for (const auto& sheet : extras.detail->ripples) {
    sheet->addTo(x, y, water.time(), keptWavelength,
                 {waves.height, waves.slopeX, waves.slopeY, {}});
  }
}

glm::vec3 coverAt(const SurfaceAtTime& water, const Surf* surf, glm::dvec2 point) {
  const auto one = [](auto& value) { return std::span(&value, 1); };
  GridCover cover;
  cover.sample(water, one(point.x), one(point.y));
  if (surf) cover.addSurf(*surf, water, one(point.x), one(point.y), 0.0);
  if (!cover.any) return glm::vec3(0.0f);
  return {cover.foam[0], cover.smooth[0], cover.oil[0]};
}

bool mayHaveCover(const SurfaceExtras& extras, const Surf* surf) {
  return surf || (extras.detail && !extras.detail->cover.empty());
}

}  // namespace seaway::render
