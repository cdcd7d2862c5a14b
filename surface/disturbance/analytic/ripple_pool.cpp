#include "surface/disturbance/analytic/ripple_pool.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "surface/constants.h"
#include "surface/input_error.h"

namespace seaway {
namespace {

void require(const char* what, double value, double least, double most) {
  if (value >= least && value <= most) return;
  throw InputError(std::string("ripples: ") + what + " " + std::to_string(value) +
                   " is not allowed; must be in [" + std::to_string(least) + ", " +
                   std::to_string(most) + "]");
}

/// Ten cells carry a ripple; fewer where the square is too large for that.
int cellsFor(const RippleSource& source) {
  const double wanted = std::ceil(source.side / (0.1 * source.wavelength));
  return std::clamp(static_cast<int>(wanted), 16, RipplePool::mostCells);
}

const RippleSource& checked(const RippleSource& source) {
  if (!std::isfinite(source.place.x + source.place.y + source.time)) {
    throw InputError("ripples: place and time must be finite");
  }
  require("duration", source.duration, 0.0, 3600.0);
  require("height", source.height, 0.0, 5.0);
  require("period", source.period, 0.2, 60.0);
  require("wavelength", source.wavelength, 0.1, 100.0);
  require("side", source.side, 2.0 * source.wavelength, 25.0 * source.wavelength);
  const double cell = source.side / cellsFor(source);
  const double speed = source.wavelength / source.period;
  if (speed * RipplePool::step > cell / 3.0) {
    throw InputError("ripples: a speed of " + std::to_string(speed) +
                     " m/s is not allowed; at most " +
                     std::to_string(cell / 3.0 / RipplePool::step) + " for cells of " +
                     std::to_string(cell) + " m: make the side larger");
  }
  return source;
}

/// Weights of a cubic B-spline's four cells and of its derivative.
struct Spline {
  float value[4], slope[4];

  explicit Spline(float f) {
    const float g = 1.0f - f;
    value[0] = g * g * g / 6.0f;
    value[1] = (4.0f - 3.0f * f * f * (1.0f + g)) / 6.0f;
    value[2] = (4.0f - 3.0f * g * g * (1.0f + f)) / 6.0f;
    value[3] = f * f * f / 6.0f;
    slope[0] = -0.5f * g * g;
    slope[1] = 0.5f * f * (3.0f * f - 4.0f);
    slope[2] = -0.5f * g * (3.0f * g - 4.0f);
    slope[3] = 0.5f * f * f;
  }
};

double carriedPart(double wavelength, double kept) {
  if (!(kept > 0.0)) return 1.0;
  const double f = std::clamp((wavelength - 0.5 * kept) / (0.5 * kept), 0.0, 1.0);
  return f * f * (3.0 - 2.0 * f);
}

}  // namespace

RippleSheet::RippleSheet(const RippleSource& source, glm::dvec2 current, int cells,
                         std::vector<float> before, std::vector<float> after, double start,
                         double end)
    : source_(source),
      current_(current),
      cells_(cells),
      before_(std::move(before)),
      after_(std::move(after)),
      start_(start),
      end_(end) {
  // Splines stay within their cells' values.
  for (const auto* grid : {&before_, &after_}) {
    for (const float height : *grid) largest_ = std::max(largest_, std::abs(height));
  }
}

float RippleSheet::partAt(double t) const noexcept {
  return static_cast<float>(std::clamp((t - start_) / (end_ - start_), 0.0, 1.0));
}

RippleSheet::Value RippleSheet::at(glm::dvec2 offset, float part) const noexcept {
  const double perCell = cells_ / source_.side;
  const double x = offset.x * perCell - 0.5, y = offset.y * perCell - 0.5;
  // False for NaN; the outermost cells are still.
  const bool inside = x >= 1.0 && y >= 1.0 && x < cells_ - 2.0 && y < cells_ - 2.0;
  if (!inside) return {};
  const auto i = static_cast<int>(x), j = static_cast<int>(y);
  const Spline across(static_cast<float>(x - i)), ahead(static_cast<float>(y - j));
  Value sum;
  for (int n = 0; n < 4; ++n) {
    const std::size_t row = static_cast<std::size_t>(j - 1 + n) * static_cast<std::size_t>(cells_);
    float height = 0.0f, slope = 0.0f, earlier = 0.0f, later = 0.0f;
    for (int m = 0; m < 4; ++m) {
      const std::size_t cell = row + static_cast<std::size_t>(i - 1 + m);
      const float here = before_[cell] + part * (after_[cell] - before_[cell]);
      height += across.value[m] * here;
      slope += across.slope[m] * here;
      earlier += across.value[m] * before_[cell];
      later += across.value[m] * after_[cell];
    }
    sum.height += ahead.value[n] * height;
    sum.slopeX += ahead.value[n] * slope;
    sum.slopeY += ahead.slope[n] * height;
    sum.rate += ahead.value[n] * (later - earlier);
  }
  const auto scale = static_cast<float>(perCell);
  sum.slopeX *= scale;
  sum.slopeY *= scale;
  sum.rate *= static_cast<float>(1.0 / (end_ - start_));
  return sum;
}

void RippleSheet::addTo(std::span<const glm::dvec2> points, double t, std::span<SurfaceSample> out,
                        const SampleOptions& options) const noexcept {
  if (!lives(t) || source_.wavelength < options.shortestWavelength) return;
  const glm::dvec2 corner = centre(t) - 0.5 * source_.side;
  const float part = partAt(t);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Value value = at(points[i] - corner, part);
    SurfaceSample& sample = out[i];
    sample.height += value.height;
    if (!options.derivatives && !options.orbitalVelocity) continue;
    const glm::dvec2 slope(value.slopeX, value.slopeY);
    sample.slope += slope;
    sample.verticalVelocity += value.rate - glm::dot(current_, slope);
    if (options.orbitalVelocity) sample.orbitalVelocity.z += value.rate;
  }
}

void RippleSheet::addTo(std::span<const double> x, std::span<const double> y, double t, double kept,
                        const Arrays& out) const noexcept {
  const auto carried = static_cast<float>(carriedPart(source_.wavelength, kept));
  if (!lives(t) || carried == 0.0f) return;
  const glm::dvec2 corner = centre(t) - 0.5 * source_.side;
  const float part = partAt(t);
  const glm::vec2 drift(current_);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Value value = at(glm::dvec2(x[i], y[i]) - corner, part);
    if (!out.height.empty()) out.height[i] += carried * value.height;
    if (!out.slopeX.empty()) out.slopeX[i] += carried * value.slopeX;
    if (!out.slopeY.empty()) out.slopeY[i] += carried * value.slopeY;
    if (out.rate.empty()) continue;
    out.rate[i] += carried * (value.rate - glm::dot(drift, glm::vec2(value.slopeX, value.slopeY)));
  }
}

RipplePool::RipplePool(const RippleSource& source, glm::dvec2 current)
    : source_(checked(source)), current_(current), cells_(cellsFor(source)) {}

void RipplePool::reset() {
  done_ = 0;
  before_.clear();
  after_.clear();
}

void RipplePool::advance(double t) {
  if (!(t > source_.time) || !(t < source_.end())) return reset();
  // The sheet reaches from step `wanted` to the next.
  const auto wanted = static_cast<long long>((t - source_.time) / step) + 1;
  if (wanted < done_) reset();
  if (before_.empty()) {
    const auto count = static_cast<std::size_t>(cells_) * static_cast<std::size_t>(cells_);
    before_.assign(count, 0.0f);
    after_.assign(count, 0.0f);
  }
  while (done_ < wanted) stepOnce();
}

// η⁺ = f (2η + (c dt/h)² ∇²η) − f² η⁻, f = e^(−γ dt), which damps all waves alike; ∇² over eight
// neighbours, for rings that are round.
void RipplePool::stepOnce() {
  const double cell = source_.side / cells_;
  const double reach = source_.wavelength / source_.period * step / cell;
  const auto pull = static_cast<float>(reach * reach / 6.0);
  const auto kept = static_cast<float>(std::exp(-RippleSource::decay * step));
  const double border = 0.15 * cells_;
  const auto side = static_cast<std::size_t>(cells_);
  std::vector<float> mask(side, 1.0f);  // what a row or column of the border leaves of a step
  for (std::size_t i = 0; i < side; ++i) {
    const double in = std::min(static_cast<double>(i), static_cast<double>(side - 1 - i)) / border;
    if (in < 1.0) mask[i] = static_cast<float>(1.0 - 0.25 * (1.0 - in) * (1.0 - in));
  }
  // The next step takes the place of the last but one, cell by cell.
  for (std::size_t j = 1; j + 1 < side; ++j) {
    const float* here = after_.data() + j * side;
    const float *south = here - side, *north = here + side;
    float* old = before_.data() + j * side;
    for (std::size_t i = 1; i + 1 < side; ++i) {
      const float sum = 4.0f * (here[i - 1] + here[i + 1] + south[i] + north[i]) + south[i - 1] +
                        south[i + 1] + north[i - 1] + north[i + 1] - 20.0f * here[i];
      old[i] = mask[i] * mask[j] * kept * (2.0f * here[i] + pull * sum - kept * old[i]);
    }
  }
  before_.swap(after_);
  ++done_;
  const double age = static_cast<double>(done_) * step;
  if (age < source_.duration) {
    // The source holds the water within a fifth of a wavelength; it starts gently.
    const double turns = age / source_.period, risen = std::min(turns, 1.0);
    const auto height = static_cast<float>(source_.height * risen * std::sin(2.0 * pi * turns));
    const double middle = 0.5 * (cells_ - 1), radius = 0.2 * source_.wavelength / cell;
    for (std::size_t j = 1; j + 1 < side; ++j) {
      for (std::size_t i = 1; i + 1 < side; ++i) {
        const double x = (static_cast<double>(i) - middle) / radius;
        const double y = (static_cast<double>(j) - middle) / radius;
        const double far = x * x + y * y;
        if (far > 9.0) continue;
        float& cellHeight = after_[j * side + i];
        cellHeight += static_cast<float>(std::exp(-far)) * (height - cellHeight);
      }
    }
  }
}

double RipplePool::energy() const {
  double sum = 0.0;
  for (const float height : after_) sum += static_cast<double>(height) * height;
  return sum;
}

std::shared_ptr<const RippleSheet> RipplePool::sheet() const {
  if (after_.empty()) return nullptr;
  const double end = source_.time + static_cast<double>(done_) * step;
  return std::make_shared<const RippleSheet>(source_, current_, cells_, before_, after_, end - step,
                                             end);
}

}  // namespace seaway
