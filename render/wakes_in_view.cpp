#include "render/wakes_in_view.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>

namespace seaway::render {
namespace {

/// Whether a row of the grid, as a box, meets a window.
bool meets(const WakeSheet& sheet, glm::dvec2 foot, const GridLayout& layout) {
  const glm::dvec2 least = sheet.centre - 0.5 * sheet.size(),
                   most = sheet.centre + 0.5 * sheet.size();
  if (layout.rings) {  // the outermost holds all
    const glm::dvec2 off = glm::abs(foot + layout.fromPlane.foot - sheet.centre);
    const double within = layout.rings->radius(layout.size.y - 1) + 0.5 * sheet.size();
    return off.x < within && off.y < within;
  }
  return std::any_of(layout.rows.begin(), layout.rows.end(), [&](const GridLayout::Row& row) {
    const glm::dvec2 a = foot + row.start, b = a + (layout.size.x - 1.0) * row.step;
    const glm::dvec2 low = glm::min(a, b), high = glm::max(a, b);
    return low.x < most.x && high.x > least.x && low.y < most.y && high.y > least.y;
  });
}

}  // namespace

void WakesInView::fill(const DisturbanceState* disturbances, double t, glm::dvec2 foot,
                       const GridLayout& layout) {
  count_ = 0;
  if (disturbances) {
    drift_ = disturbances->drift(t);
    for (const VesselWaves& wake : disturbances->wakes()) {
      for (const WakeSheet& sheet : wake.sheets) {
        if (!meets(sheet, foot - drift_, layout)) continue;
        if (count_ == pyramids_.size()) pyramids_.emplace_back();
        pyramids_[count_++].fill(sheet, t);
      }
    }
  }
  if (count_ == 0) pyramids_ = {};
}

void WakesInView::addTo(std::span<const double> x, std::span<const double> y, double spacing,
                        const WakePyramid::Arrays& out) const {
  constexpr std::size_t together = 256;
  std::array<double, together> placeX, placeY;
  const auto part = [](auto all, std::size_t first, std::size_t count) {
    return all.empty() ? all : all.subspan(first, count);
  };
  for (std::size_t first = 0; first < x.size(); first += together) {
    const std::size_t count = std::min(together, x.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      placeX[i] = x[first + i] - drift_.x;
      placeY[i] = y[first + i] - drift_.y;
    }
    for (const WakePyramid& sheet : sheets()) {
      sheet.addTo(std::span(placeX).first(count), std::span(placeY).first(count),
                  sheet.levelFor(spacing),
                  {part(out.height, first, count), part(out.slopeX, first, count),
                   part(out.slopeY, first, count), part(out.missing, first, count)});
    }
  }
}

double WakesInView::steepest() const {
  double sum = 0.0;
  for (const WakePyramid& sheet : sheets()) sum += sheet.steepest();
  return sum;
}

std::size_t WakesInView::memoryBytes() const {
  std::size_t bytes = 0;
  for (const WakePyramid& pyramid : pyramids_) bytes += pyramid.memoryBytes();
  return bytes;
}

}  // namespace seaway::render
