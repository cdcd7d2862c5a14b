#include "surface/field/wave_field.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <sstream>

#include "surface/input_error.h"

namespace seaway {
namespace {

[[noreturn]] void reject(std::size_t index, const char* what, double value, const char* allowed) {
  std::ostringstream message;
  message << "octave " << index + 1 << ": " << what << ' ' << value << " is not allowed; must be "
          << allowed;
  throw InputError(message.str());
}

void check(const std::vector<Octave>& octaves, const WaveFieldSettings& settings) {
  for (std::size_t i = 0; i < octaves.size(); ++i) {
    const Octave& octave = octaves[i];
    const auto positive = [](double x) { return std::isfinite(x) && x > 0.0; };
    if (!(std::isfinite(octave.standardDeviation) && octave.standardDeviation >= 0.0)) {
      reject(i, "standard deviation", octave.standardDeviation, ">= 0 m");
    }
    if (!positive(octave.latticeSize)) reject(i, "lattice size", octave.latticeSize, "> 0 m");
    if (!positive(octave.boilTime)) reject(i, "boil time", octave.boilTime, "> 0 s");
    if (!std::isfinite(octave.toward)) reject(i, "direction", octave.toward, "finite");
    if (!std::isfinite(octave.driftSpeed)) reject(i, "drift speed", octave.driftSpeed, "finite");
  }
  if (!(settings.depth > 0.0)) throw InputError("depth must be > 0 m");
  if (!std::isfinite(settings.current.x) || !std::isfinite(settings.current.y)) {
    throw InputError("current must be finite");
  }
}

SurfaceSample invalid(SampleStatus status) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  return {nan, {nan, nan}, nan, nan, nan, status};
}

bool isFinite(glm::dvec2 point) { return std::isfinite(point.x) && std::isfinite(point.y); }

}  // namespace

WaveField::WaveField(std::vector<Octave> octaves, const WaveFieldSettings& settings)
    : octaves_(std::move(octaves)), settings_(settings) {
  check(octaves_, settings_);
  // Still octaves would cost time for nothing.
  std::erase_if(octaves_, [](const Octave& octave) { return octave.standardDeviation == 0.0; });

  // Each octave keeps the lattice of its place in the given order, however its rank changes.
  std::vector<std::size_t> order(octaves_.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return octaves_[a].standardDeviation > octaves_[b].standardDeviation;
  });
  std::vector<Octave> sorted;
  for (const std::size_t i : order) {
    sorted.push_back(octaves_[i]);
    evaluators_.emplace_back(octaves_[i], settings_.seed, i, settings_.current);
  }
  octaves_ = std::move(sorted);

  leftOut_.assign(octaves_.size() + 1, 0.0);
  double variance = 0.0, peaks = 0.0;
  for (std::size_t i = octaves_.size(); i-- > 0;) {
    variance += octaves_[i].standardDeviation * octaves_[i].standardDeviation;
    peaks += octaves_[i].standardDeviation * PerlinOctave::peakFactor();
    leftOut_[i] = std::sqrt(variance);
  }
  heightBound_ = std::min(5.5 * standardDeviation(), peaks);
}

std::size_t WaveField::octavesFor(double tolerance) const {
  std::size_t kept = 0;
  while (leftOut_[kept] > tolerance) ++kept;
  return kept;
}

void WaveField::sample(std::span<const glm::dvec2> points, double t, std::span<SurfaceSample> out,
                       const SampleOptions& options) const noexcept {
  const bool exact = !(options.tolerance > 0.0);
  const std::size_t kept = exact ? octaves_.size() : octavesFor(options.tolerance);
  const bool timeIsFinite = std::isfinite(t);
  for (std::size_t p = 0; p < points.size(); ++p) {
    const bool valid = timeIsFinite && isFinite(points[p]);
    out[p] = valid ? SurfaceSample{} : invalid(SampleStatus::notFinite);
    if (!valid) continue;
    out[p].error = leftOut_[kept];
    if (kept < octaves_.size()) out[p].status |= SampleStatus::truncated;
  }
  if (!timeIsFinite) return;

  for (std::size_t i = 0; i < kept; ++i) {
    const PerlinOctave& octave = evaluators_[i];
    const PerlinOctave::AtTime time = octave.at(t);
    for (std::size_t p = 0; p < points.size(); ++p) {
      SurfaceSample& sample = out[p];
      if (has(sample.status, SampleStatus::notFinite)) continue;
      const OctaveSample part = octave.sample(points[p], time);
      sample.height += part.height;
      sample.slope += part.slope;
      sample.verticalVelocity += part.verticalVelocity;
      sample.bound += octave.roundingBound(glm::length(points[p]), t);
    }
  }
}

std::size_t WaveField::memoryBytes() const {
  return octaves_.size() * (sizeof(Octave) + sizeof(PerlinOctave) + sizeof(double));
}

}  // namespace seaway
