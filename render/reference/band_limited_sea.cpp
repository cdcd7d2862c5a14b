#include "render/reference/band_limited_sea.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/grid_cover.h"
#include "surface/constants.h"

namespace seaway::render {
namespace {

BandLimitedSea::Point mixed(const BandLimitedSea::Point& a, const BandLimitedSea::Point& b,
                            double part) {
  return {glm::mix(a.height, b.height, part), glm::mix(a.slope, b.slope, part),
          glm::mix(a.missingSlope, b.missingSlope, part)};
}

/// Splashes and ripples come with slopes of up to this.
double steepestExtra(const SurfaceAtTime& water) {
  const SurfaceExtras& extras = water.extras();
  const bool any = (extras.events && !extras.events->splashesAbout(water.time()).empty()) ||
                   (extras.detail && !extras.detail->ripples.empty());
  return any ? 1.5 : 0.0;
}

bool carrySame(const BandLimit::Plan& a, const BandLimit::Plan& b) {
  return a.missingSlope == b.missingSlope;
}

}  // namespace

BandLimitedSea::BandLimitedSea(const SurfaceAtTime& water, const WakesInView& wakes,
                               const GridLayout& layout, glm::dvec2 foot)
    : water_(water),
      wakes_(wakes),
      layout_(layout),
      foot_(foot),
      totalSlope_(BandLimit(water.waves().field()).totalSlope()),
      steepestWake_(wakes.steepest() + steepestExtra(water)),
      bound_(water.heightBound()) {}

/// What lies on the water and disturbs it beside wakes, as a grid adds it.
void BandLimitedSea::addExtras(glm::dvec2 point, double keptWavelength, Point& carried) const {
  if (!water_.extras().events && !water_.extras().detail) return;
  auto height = static_cast<float>(carried.height);
  auto x = static_cast<float>(carried.slope.x), y = static_cast<float>(carried.slope.y);
  const auto one = [](auto& value) { return std::span(&value, 1); };
  GridCover cover;
  cover.sample(water_, one(point.x), one(point.y));
  render::addExtras(water_, one(point.x), one(point.y), keptWavelength, cover,
                    {one(height), one(x), one(y), {}});
  carried.height = height;
  carried.slope = {x, y};
}

BandLimitedSea::Point BandLimitedSea::row(int index, glm::dvec2 point) const {
  const BandLimit::Plan& plan = layout_.rows[index].plan;
  const auto ask = [&](double shortest) {
    const SurfaceSample sample = water_.waves().sample(point, {.shortestWavelength = shortest});
    return Point{sample.height, sample.slope, plan.missingSlope};
  };
  Point carried = ask(plan.keptWavelength);
  if (plan.weight != 0.0) carried = mixed(carried, ask(plan.fadingWavelength), plan.weight);
  addExtras(point, plan.keptWavelength, carried);
  if (wakes_.empty()) return carried;
  float height = 0.0f, x = 0.0f, y = 0.0f, missing = 0.0f;
  const auto one = [](auto& value) { return std::span(&value, 1); };
  wakes_.addTo(one(point.x), one(point.y), plan.spacing,
               {one(height), one(x), one(y), one(missing)});
  return {carried.height + height, carried.slope + glm::dvec2(x, y),
          carried.missingSlope + missing};
}

BandLimitedSea::Point BandLimitedSea::at(glm::dvec2 place) const {
  // Outside the outline it lies as the ground does.
  if (water_.outline() && !water_.outline()->contains(foot_ + place)) return {};
  const double at = layout_.rowAt(place);
  const int near = std::min(static_cast<int>(at), layout_.size.y - 2);
  const Point before = row(near, foot_ + place);
  const bool alone = wakes_.empty() && !water_.extras().events && !water_.extras().detail;
  if (alone && carrySame(layout_.rows[near].plan, layout_.rows[near + 1].plan)) {
    return before;
  }
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
    const double steepest = 6.0 * carriedSlope(place(before)) + steepestWake_;
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
