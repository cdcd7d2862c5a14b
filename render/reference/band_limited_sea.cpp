#include "render/reference/band_limited_sea.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "surface/constants.h"

namespace seaway::render {
namespace {

BandLimitedSea::Point mixed(const BandLimitedSea::Point& a, const BandLimitedSea::Point& b,
                            double part) {
  return {glm::mix(a.height, b.height, part), glm::mix(a.slope, b.slope, part),
          glm::mix(a.missingSlope, b.missingSlope, part)};
}

bool carrySame(const BandLimit::Plan& a, const BandLimit::Plan& b) {
  return a.missingSlope == b.missingSlope;
}

}  // namespace

BandLimitedSea::BandLimitedSea(const SurfaceAtTime& water, const GridLayout& layout,
                               glm::dvec2 foot)
    : water_(water),
      layout_(layout),
      foot_(foot),
      totalSlope_(BandLimit(water.waves().field()).totalSlope()),
      bound_(water.heightBound()) {}

BandLimitedSea::Point BandLimitedSea::row(int index, glm::dvec2 point) const {
  const BandLimit::Plan& plan = layout_.rows[index].plan;
  const auto ask = [&](double shortest) {
    const SurfaceSample sample = water_.sample(point, {.shortestWavelength = shortest});
    return Point{sample.height, sample.slope, plan.missingSlope};
  };
  const Point kept = ask(plan.keptWavelength);
  if (plan.weight == 0.0) return kept;
  return mixed(kept, ask(plan.fadingWavelength), plan.weight);
}

BandLimitedSea::Point BandLimitedSea::at(glm::dvec2 place) const {
  // Outside the outline it lies as the ground does.
  if (water_.outline() && !water_.outline()->contains(foot_ + place)) return {};
  const double at = layout_.rowAt(place);
  const int near = std::min(static_cast<int>(at), layout_.size.y - 2);
  const Point before = row(near, foot_ + place);
  if (carrySame(layout_.rows[near].plan, layout_.rows[near + 1].plan)) return before;
  return mixed(before, row(near + 1, foot_ + place), at - near);
}

double BandLimitedSea::carriedSlope(glm::dvec2 place) const {
  const BandLimit::Plan& plan = layout_.rows[static_cast<int>(layout_.rowAt(place))].plan;
  return std::sqrt(std::max(totalSlope_ - plan.missingSlope, 0.0));
}

std::optional<double> BandLimitedSea::distance(double height, glm::dvec3 direction, double nearest,
                                               double farthest) const {
  const double level = glm::length(glm::dvec2(direction));
  const double bend = level * level / earthMeanRadius;
  const auto place = [&](double distance) { return glm::dvec2(direction) * distance; };
  const auto aboveStill = [&](double distance) {
    return height + direction.z * distance + 0.5 * bend * distance * distance;
  };
  const auto aboveWater = [&](double distance) {
    return aboveStill(distance) - at(place(distance)).height;
  };
  double before = nearest, above = aboveWater(before);
  const double side = above < 0.0 ? -1.0 : 1.0;  // +1: looking from above
  while (before < farthest) {
    // Farther away than the highest crest, still water tells how far the next step may go.
    const double sinking = std::abs(direction.z) + bend * before + 1e-12;
    const double clear = (side * aboveStill(before) - bound_) / sinking;
    const double steepest = 6.0 * carriedSlope(place(before));
    const double safe = side * above / (sinking + level * steepest);
    const double step =
        std::clamp(std::max(clear, safe), 5e-4 * before + 1e-5, 0.5 * before + farthest / 16);
    const double next = std::min(before + step, farthest);
    const double nextAbove =
        side * aboveStill(next) > bound_ ? aboveStill(next) - side * bound_ : aboveWater(next);
    if (side * nextAbove <= 0.0) {
      double low = before, high = next;
      while (high - low > std::max(1e-7 * high, 1e-6)) {
        const double middle = 0.5 * (low + high);
        (side * aboveWater(middle) > 0.0 ? low : high) = middle;
      }
      return 0.5 * (low + high);
    }
    before = next;
    above = nextAbove;
  }
  return std::nullopt;
}

}  // namespace seaway::render
