#include "surface/disturbance/analytic/surface_events.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "surface/input_error.h"

namespace seaway {
namespace {

struct Offset {
  glm::dvec2 outwards{0.0};  // unit; 0 at the middle
  double distance = 0.0;     // m
};

Offset offsetFrom(glm::dvec2 centre, glm::dvec2 point) {
  const glm::dvec2 offset = point - centre;
  const double distance = glm::length(offset);
  return {distance > 0.0 ? offset / distance : glm::dvec2(0.0), distance};
}

double carriedPart(double wavelength, double kept) {
  if (!(kept > 0.0)) return 1.0;
  const double f = std::clamp((wavelength - 0.5 * kept) / (0.5 * kept), 0.0, 1.0);
  return f * f * (3.0 - 2.0 * f);
}

}  // namespace

SurfaceEvents::SurfaceEvents(const std::vector<Splash>& splashes, const Rain& rain,
                             const Water& water)
    : rain_(rain), water_(water) {
  if (splashes.size() > mostSplashes) {
    throw InputError(std::to_string(splashes.size()) + " splashes are not allowed; " +
                     std::to_string(mostSplashes) + " at the most");
  }
  splashes_.reserve(splashes.size());
  for (const Splash& splash : splashes) {
    splashes_.emplace_back(splash, water.current, water.depth);
    longest_ = std::max(longest_, splashes_.back().lifetime());
  }
  std::stable_sort(splashes_.begin(), splashes_.end(),
                   [](const auto& a, const auto& b) { return a.start() < b.start(); });
}

std::span<const SplashRings> SurfaceEvents::splashesAbout(double t) const noexcept {
  if (splashes_.empty() || !std::isfinite(t)) return {};
  const auto before = [](const SplashRings& splash, double time) { return splash.start() < time; };
  const auto first = std::lower_bound(splashes_.begin(), splashes_.end(), t - longest_, before);
  const auto last = std::lower_bound(first, splashes_.end(), t, before);
  return {first, last};
}

/// Calls `add` for each splash and point that it reaches, splash by splash.
template <class PlaceOf, class Add>
void SurfaceEvents::forEachReached(std::size_t count, double t, const PlaceOf& place,
                                   const Add& add) const {
  for (const SplashRings& splash : splashesAbout(t)) {
    if (!splash.isActive(t)) continue;
    const glm::dvec2 centre = splash.centre(t);
    const double radius = splash.radius();
    for (std::size_t i = 0; i < count; ++i) {
      const glm::dvec2 point = place(i);
      // False for NaN.
      if (std::abs(point.x - centre.x) < radius && std::abs(point.y - centre.y) < radius) {
        add(i, splash, offsetFrom(centre, point));
      }
    }
  }
}

void SurfaceEvents::addTo(std::span<const glm::dvec2> points, double t,
                          std::span<SurfaceSample> out,
                          const SampleOptions& options) const noexcept {
  const bool whole = options.derivatives || options.orbitalVelocity;
  const auto place = [&](std::size_t i) { return points[i]; };
  forEachReached(
      points.size(), t, place, [&](std::size_t i, const SplashRings& splash, const Offset& offset) {
        if (splash.splash().wavelength < options.shortestWavelength) return;
        const SplashRings::Value value = splash.at(offset.distance, t - splash.start());
        SurfaceSample& sample = out[i];
        sample.height += value.height;
        if (!whole) return;
        const glm::dvec2 slope = value.byDistance * offset.outwards;
        sample.slope += slope;
        sample.verticalVelocity += value.byTime - glm::dot(water_.current, slope);
        if (!options.orbitalVelocity) return;
        sample.orbitalVelocity +=
            glm::dvec3(splash.angularFrequency() * value.height * offset.outwards, value.byTime);
      });
  if (!rain_.falls(t) || options.shortestWavelength > Rain::wavelength) return;
  if (options.tolerance > Rain::ringHeight) return;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Rain::Value value = rain_.at(points[i], t);
    SurfaceSample& sample = out[i];
    sample.height += value.height;
    if (!whole) continue;
    sample.slope += glm::dvec2(value.slopeX, value.slopeY);
    sample.verticalVelocity += value.rate;
    if (options.orbitalVelocity) sample.orbitalVelocity.z += value.rate;
  }
}

void SurfaceEvents::addSplashes(std::span<const double> x, std::span<const double> y, double t,
                                double kept, const Arrays& out) const noexcept {
  const auto place = [&](std::size_t i) { return glm::dvec2(x[i], y[i]); };
  forEachReached(
      x.size(), t, place, [&](std::size_t i, const SplashRings& splash, const Offset& offset) {
        const double part = carriedPart(splash.splash().wavelength, kept);
        if (part == 0.0) return;
        const SplashRings::Value value = splash.at(offset.distance, t - splash.start());
        const glm::dvec2 slope = value.byDistance * offset.outwards;
        if (!out.height.empty()) out.height[i] += static_cast<float>(part * value.height);
        if (!out.slopeX.empty()) out.slopeX[i] += static_cast<float>(part * slope.x);
        if (!out.slopeY.empty()) out.slopeY[i] += static_cast<float>(part * slope.y);
        if (out.rate.empty()) return;
        out.rate[i] += static_cast<float>(part * (value.byTime - glm::dot(water_.current, slope)));
      });
}

double SurfaceEvents::heightBound(double t) const noexcept {
  double bound = rain_.falls(t) ? Rain::ringHeight * 4 * Rain::mostDrops : 0.0;
  for (const SplashRings& splash : splashesAbout(t)) {
    if (splash.isActive(t)) bound += splash.splash().height;
  }
  return bound;
}

}  // namespace seaway
