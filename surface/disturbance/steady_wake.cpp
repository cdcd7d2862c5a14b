#include "surface/disturbance/steady_wake.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "surface/constants.h"
#include "surface/dispersion.h"
#include "surface/disturbance/disturbance_state.h"

namespace seaway {
namespace {

constexpr double lead = 0.3;  // sizes that the vessel lies ahead of the window's middle
constexpr int stepsPerCrossing = 400;
constexpr int crossings = 3;
constexpr int stepsPerBorder = 4;

WakeWindowSettings settingsOf(double speed, double size, double depth, int modes) {
  WakeWindowSettings settings;
  settings.cells = 2 * modes;
  settings.modes = modes;
  settings.cellSize = size / settings.cells;
  settings.depth = depth;
  settings.band.shortNone = settings.wavelengthLimit();
  settings.band.shortAll = 2.0 * settings.band.shortNone;
  settings.absorption = 40.0 * speed / size;
  check(settings);
  return settings;
}

std::shared_ptr<const FootprintTable> footprintOf(const HullFootprint& hull,
                                                  const WakeWindowSettings& settings) {
  return std::make_shared<const FootprintTable>(hull, settings.depth,
                                                WakeWindow::largestWaveNumber(settings));
}

}  // namespace

SteadyWake::SteadyWake(const HullFootprint& hull, double speed, double size, double depth,
                       int modes)
    : speed_(speed),
      dt_(size / speed / stepsPerCrossing),
      window_(std::make_shared<const WakeTables>(settingsOf(speed, size, depth, modes), dt_),
              footprintOf(hull, settingsOf(speed, size, depth, modes))),
      grid_(std::make_shared<WakeGrid>(2 * modes, false)) {
  window_.settle(placeAt(0));
  while (steps_ < crossings * stepsPerCrossing - 1) {
    window_.step(dt_, placeAt(steps_), placeAt(steps_ + 1));
    ++steps_;
    if (steps_ % stepsPerBorder != 0) continue;
    window_.absorb(placeAt(steps_).position - glm::dvec2(lead * size, 0.0), stepsPerBorder * dt_);
  }
  step();
}

HullPlace SteadyWake::placeAt(long long step) const {
  return {{speed_ * static_cast<double>(step) * dt_, 0.0}, 0.0, 1.0};
}

void SteadyWake::step() {
  window_.step(dt_, placeAt(steps_), placeAt(steps_ + 1));
  place_ = placeAt(++steps_);
  if (steps_ % stepsPerBorder == 0) {
    window_.absorb(place_.position - glm::dvec2(lead * size(), 0.0), stepsPerBorder * dt_);
  }
  window_.draw(*grid_);
  envelope_ = window_.envelope();
}

std::vector<double> SteadyWake::heights(const std::vector<glm::dvec2>& fromVessel) const {
  const glm::dvec2 centre = place_.position - glm::dvec2(lead * size(), 0.0);
  const DisturbanceState state({{1, {{grid_, grid_, 0.0, 1.0, settings().cellSize, centre}}, 0.0}},
                               {});
  std::vector<glm::dvec2> points;
  for (const glm::dvec2 p : fromVessel) {
    points.push_back(place_.position + glm::dvec2(-p.x, p.y));
  }
  std::vector<SurfaceSample> samples(points.size());
  state.addTo(points, 0.0, samples, {.derivatives = false});
  std::vector<double> result;
  for (const SurfaceSample& sample : samples) result.push_back(sample.height);
  return result;
}

double SteadyWake::envelopeAt(glm::dvec2 fromVessel) const {
  const long long cells = settings().cells;
  const glm::dvec2 cell =
      (place_.position + glm::dvec2(-fromVessel.x, fromVessel.y)) / settings().cellSize;
  const double i = std::floor(cell.x), j = std::floor(cell.y), u = cell.x - i, v = cell.y - j;
  const auto value = [&](double x, double y) {
    const auto wrap = [&](double c) { return static_cast<long long>(c) & (cells - 1); };
    return static_cast<double>(envelope_[static_cast<std::size_t>(wrap(y) * cells + wrap(x))]);
  };
  return (1 - v) * ((1 - u) * value(i, j) + u * value(i + 1, j)) +
         v * ((1 - u) * value(i, j + 1) + u * value(i + 1, j + 1));
}

namespace {

struct Line {
  double slope, intercept;
};

/// Least squares.
Line lineThrough(const std::vector<glm::dvec2>& points) {
  double n = 0, sumX = 0, sumY = 0, sumXX = 0, sumXY = 0;
  for (const glm::dvec2 p : points) {
    n += 1, sumX += p.x, sumY += p.y, sumXX += p.x * p.x, sumXY += p.x * p.y;
  }
  const double slope = (n * sumXY - sumX * sumY) / (n * sumXX - sumX * sumX);
  return {slope, (sumY - slope * sumX) / n};
}

constexpr int placesAstern = 60, placesAcross = 2000;

double asideOf(std::ptrdiff_t place, double astern, double widest) {
  return astern * widest * static_cast<double>(place + 1) / placesAcross;
}

/// The envelope at places across the track, from the innermost.
std::vector<double> envelopeAcross(const SteadyWake& wake, double astern, double widest) {
  std::vector<double> heights;
  for (int j = 0; j < placesAcross; ++j) {
    heights.push_back(wake.envelopeAt({astern, asideOf(j, astern, widest)}));
  }
  return heights;
}

}  // namespace

double transverseWavelength(const SteadyWake& wake, double first, double last) {
  constexpr int places = 4000;
  std::vector<glm::dvec2> track, crossings;
  for (int i = 0; i <= places; ++i) track.emplace_back(first + (last - first) * i / places, 0.0);
  const std::vector<double> heights = wake.heights(track);
  for (std::size_t i = 1; i < heights.size(); ++i) {
    if ((heights[i - 1] < 0.0) == (heights[i] < 0.0)) continue;
    const double part = heights[i - 1] / (heights[i - 1] - heights[i]);
    crossings.emplace_back(static_cast<double>(crossings.size()),
                           track[i - 1].x + part * (track[i].x - track[i - 1].x));
  }
  if (crossings.size() < 4) return std::numeric_limits<double>::quiet_NaN();
  return 2.0 * lineThrough(crossings).slope;
}

double transverseWavelengthTheory(double speed, double depth) {
  if (speed * speed >= standardGravity * depth) return std::numeric_limits<double>::quiet_NaN();
  // c falls with k from √(gd) to 0.
  double low = 0.0, high = standardGravity / (speed * speed);
  for (int i = 0; i < 200; ++i) {
    const double k = 0.5 * (low + high);
    (phaseSpeed(k, depth) > speed ? low : high) = k;
  }
  return 2.0 * pi / high;
}

std::vector<RidgePoint> ridgeOf(const SteadyWake& wake, double first, double last, double widest) {
  std::vector<RidgePoint> ridge;
  for (int i = 0; i < placesAstern; ++i) {
    const double astern = first + (last - first) * i / (placesAstern - 1);
    const std::vector<double> across = envelopeAcross(wake, astern, widest);
    const auto highest = std::max_element(across.begin(), across.end());
    ridge.push_back({astern, asideOf(highest - across.begin(), astern, widest)});
  }
  return ridge;
}

double frontAngle(const SteadyWake& wake, double first, double last, double widest) {
  std::vector<glm::dvec2> front;
  for (int i = 0; i < placesAstern; ++i) {
    const double astern = first + (last - first) * i / (placesAstern - 1);
    const std::vector<double> across = envelopeAcross(wake, astern, widest);
    const double third = *std::max_element(across.begin(), across.end()) / 3.0;
    const auto outermost =
        std::find_if(across.rbegin(), across.rend(), [&](double height) { return height > third; });
    front.emplace_back(astern, asideOf(across.rend() - outermost - 1, astern, widest));
  }
  return std::atan(lineThrough(front).slope);
}

double ridgeAngleAtInfinity(const std::vector<RidgePoint>& ridge) {
  std::vector<glm::dvec2> points;
  for (const RidgePoint& r : ridge) {
    points.emplace_back(std::pow(r.astern, -2.0 / 3.0), r.aside / r.astern);
  }
  return std::atan(lineThrough(points).intercept);
}

double wedgeAngle(double speed, double depth) {
  double widest = 0.0;
  const double k0 = standardGravity / (speed * speed), longest = std::min(k0, 1e-3 / depth);
  constexpr int rays = 200000;  // k from the longest to a hundredth of the transverse length
  const double first = std::isinf(depth) ? 0.99 * k0 : longest;
  for (int i = 0; i < rays; ++i) {
    const double k = first * std::pow(100.0 * k0 / first, static_cast<double>(i) / (rays - 1));
    const double cosine = phaseSpeed(k, depth) / speed;
    if (cosine > 1.0) continue;
    const double sine = std::sqrt(1.0 - cosine * cosine), group = groupSpeed(k, depth);
    widest = std::max(widest, std::atan2(group * sine, speed - group * cosine));
  }
  return widest;
}

}  // namespace seaway
