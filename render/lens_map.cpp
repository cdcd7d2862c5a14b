#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <sstream>

#include "render/lens.h"
#include "surface/angles.h"
#include "surface/input_error.h"

namespace seaway::render {
namespace {

const double farthestOff = std::tan(radiansFromDegrees(89.9));

/// Derivatives of `distorted`: columns by x and by y.
glm::dmat2 derivatives(const Distortion& d, glm::dvec2 p) {
  const double r2 = glm::dot(p, p);
  const double radial = 1.0 + r2 * (d.k1 + r2 * (d.k2 + r2 * d.k3));
  const double slope = 2.0 * (d.k1 + r2 * (2.0 * d.k2 + r2 * 3.0 * d.k3));  // of radial, by p
  const double cross = slope * p.x * p.y + 2.0 * d.p1 * p.x + 2.0 * d.p2 * p.y;
  return {radial + slope * p.x * p.x + 2.0 * d.p1 * p.y + 6.0 * d.p2 * p.x, cross, cross,
          radial + slope * p.y * p.y + 6.0 * d.p1 * p.y + 2.0 * d.p2 * p.x};
}

/// The derivatives are symmetric: neither turned over nor folded where both of their eigenvalues are
/// above 0.
bool keepsSense(const glm::dmat2& m) {
  return glm::determinant(m) > 0.0 && m[0][0] + m[1][1] > 0.0;
}

/// Newton's method from a place near by; false where it leaves the sheet.
bool refine(const Distortion& d, glm::dvec2 seen, glm::dvec2& place) {
  double before = std::numeric_limits<double>::infinity();
  for (int step = 0; step < 30; ++step) {
    const glm::dmat2 by = derivatives(d, place);
    if (!keepsSense(by) || !(glm::length(place) <= farthestOff)) return false;
    const glm::dvec2 off = distorted(d, place) - seen;
    const double left = glm::length(off);
    if (left <= 1e-15 * (1.0 + glm::length(seen)) || left >= before) {
      return left <= 1e-12 * (1.0 + glm::length(seen));
    }
    before = left;
    place -= glm::inverse(by) * off;
  }
  return false;
}

std::string coefficients(const Distortion& d) {
  std::ostringstream text;
  text << "k1 = " << d.k1 << ", k2 = " << d.k2 << ", k3 = " << d.k3 << ", p1 = " << d.p1
       << ", p2 = " << d.p2;
  return text.str();
}

/// Tangents of samples of a picture that a lens bends.
struct Samples {
  glm::ivec2 size;
  glm::dvec2 first, step;

  glm::dvec2 seen(int x, int y) const { return first + glm::dvec2(x, y) * step; }
};

Samples samplesOf(const Camera& camera, int perSide) {
  const Intrinsics pinhole = scaled(camera.pinhole(), camera.size, camera.size * perSide);
  const glm::dvec2 step(1.0 / pinhole.fx, 1.0 / pinhole.fy);
  return {camera.size * perSide, -glm::dvec2(pinhole.cx, pinhole.cy) * step, step};
}

/// Where a pinhole sees what the samples do.
std::vector<glm::dvec2> pinholePlaces(const Distortion& distortion, const Samples& samples) {
  std::vector<glm::dvec2> places(static_cast<std::size_t>(samples.size.x) * samples.size.y);
  std::atomic<bool> folds = false;
  tbb::parallel_for(0, samples.size.y, [&](int y) {
    std::optional<glm::dvec2> place = undistorted(distortion, samples.seen(0, y));
    for (int x = 0; x < samples.size.x && place; ++x) {
      // From its neighbour; by the long way where that is too far.
      const glm::dvec2 seen = samples.seen(x, y);
      if (!refine(distortion, seen, *place)) place = undistorted(distortion, seen);
      if (place) places[static_cast<std::size_t>(y) * samples.size.x + x] = *place;
    }
    if (!place) folds = true;
  });
  if (folds) {
    throw InputError("camera: distortion " + coefficients(distortion) +
                     " is not allowed: it folds, or passes 89.9 degrees from the view axis, within "
                     "the picture");
  }
  return places;
}

/// How much larger than the pinhole's the lens' picture is where it is largest: by that much finer
/// the pinhole's pixels must be.
double largestScale(const Distortion& distortion, const std::vector<glm::dvec2>& places) {
  double largest = 1.0;
  for (const glm::dvec2& place : places) {
    const glm::dmat2 by = derivatives(distortion, place);
    largest = std::max({largest, glm::length(by[0]), glm::length(by[1])});
  }
  return largest;
}

}  // namespace

glm::dvec2 distorted(const Distortion& d, glm::dvec2 p) {
  const double r2 = glm::dot(p, p);
  const double radial = 1.0 + r2 * (d.k1 + r2 * (d.k2 + r2 * d.k3));
  return {p.x * radial + 2.0 * d.p1 * p.x * p.y + d.p2 * (r2 + 2.0 * p.x * p.x),
          p.y * radial + d.p1 * (r2 + 2.0 * p.y * p.y) + 2.0 * d.p2 * p.x * p.y};
}

std::optional<glm::dvec2> undistorted(const Distortion& distortion, glm::dvec2 seen) {
  // Steps of a twentieth of the distance to the view axis at 45 degrees.
  const double distance = glm::length(seen);
  if (!(distance < farthestOff * farthestOff)) return std::nullopt;
  const int steps = 1 + static_cast<int>(std::min(20.0 * distance, 20000.0));
  glm::dvec2 place(0.0);
  for (int i = 1; i <= steps; ++i) {
    if (!refine(distortion, seen * (static_cast<double>(i) / steps), place)) return std::nullopt;
  }
  return place;
}

LensMap lensMap(const Camera& camera, int samplesPerSide) {
  validate(camera);
  validateSamples(camera.size, samplesPerSide);
  const Distortion distortion = camera.distortion.value_or(Distortion{});
  const Samples samples = samplesOf(camera, samplesPerSide);
  const std::vector<glm::dvec2> places = pinholePlaces(distortion, samples);
  glm::dvec2 least(std::numeric_limits<double>::infinity()), most(-least);
  for (const glm::dvec2& place : places) {
    least = glm::min(least, place);
    most = glm::max(most, place);
  }
  LensMap map;
  map.size = samples.size;
  map.wide = camera;
  map.wide.distortion.reset();
  const glm::dvec2 pixel = samples.step / largestScale(distortion, places);
  // A pixel more on each side: the places at the rim are read between pixels, and edges are smoothed.
  const glm::dvec2 sides = glm::ceil((most - least) / pixel) + 5.0;
  if (!(sides.x * sides.y <= static_cast<double>(mostLensPixels)) || glm::any(glm::greaterThan(sides, glm::dvec2(32768.0)))) {
    std::ostringstream message;
    message << "camera: distortion " << coefficients(distortion)
            << " needs an undistorted picture of " << sides.x << " x " << sides.y
            << " pixels; at most " << mostLensPixels << " are allowed, 32768 a side";
    throw InputError(message.str());
  }
  map.wide.size = glm::ivec2(sides);
  map.wide.intrinsics = Intrinsics{1.0 / pixel.x, 1.0 / pixel.y, 2.0 - least.x / pixel.x,
                                   2.0 - least.y / pixel.y};
  validate(map.wide);
  map.places.reserve(places.size());
  for (const glm::dvec2& place : places) {
    map.places.emplace_back((place - least) / pixel + 2.0);
  }
  return map;
}

void validateSamples(glm::ivec2 size, int samplesPerSide) {
  if (samplesPerSide < 1 || samplesPerSide > mostSamplesPerSide) {
    throw InputError("samples: " + std::to_string(samplesPerSide) +
                     " a pixel's side are not allowed; must be in [1, " +
                     std::to_string(mostSamplesPerSide) + "]");
  }
  const long long pixels = 1LL * size.x * size.y * samplesPerSide * samplesPerSide;
  if (samplesPerSide > 1 && pixels > mostLensPixels) {
    throw InputError("samples: " + std::to_string(samplesPerSide) + " a side of " +
                     std::to_string(size.x) + "x" + std::to_string(size.y) + " pixels are " +
                     std::to_string(pixels) + " in all; at most " +
                     std::to_string(mostLensPixels) + " are allowed");
  }
}

}  // namespace seaway::render
