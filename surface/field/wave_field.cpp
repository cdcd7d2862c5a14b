#include "surface/field/wave_field.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <sstream>

#include "surface/field/tile.h"
#include "surface/input_error.h"

namespace seaway {
namespace {

[[noreturn]] void reject(std::size_t index, const char* what, double value, const char* allowed) {
  std::ostringstream message;
  message << "octave " << index + 1 << ": " << what << ' ' << value << " is not allowed; must be "
          << allowed;
  throw InputError(message.str());
}

bool positive(double value) { return std::isfinite(value) && value > 0.0; }

void check(const Octave& octave, std::size_t i) {
  if (!(std::isfinite(octave.standardDeviation) && octave.standardDeviation >= 0.0)) {
    reject(i, "standard deviation", octave.standardDeviation, ">= 0 m");
  }
  if (!std::isfinite(octave.toward)) reject(i, "direction", octave.toward, "finite");
  if (octave.kind == OctaveKind::perlin) {
    if (!positive(octave.latticeSize)) reject(i, "lattice size", octave.latticeSize, "> 0 m");
    if (!positive(octave.boilTime)) reject(i, "boil time", octave.boilTime, "> 0 s");
    if (!std::isfinite(octave.driftSpeed)) reject(i, "drift speed", octave.driftSpeed, "finite");
    return;
  }
  if (!positive(octave.waveNumber)) reject(i, "wave number", octave.waveNumber, "> 0 rad/m");
  if (!std::isfinite(octave.phase)) reject(i, "phase", octave.phase, "finite");
  if (octave.kind == OctaveKind::regular) return;
  if (!positive(octave.lengthAlong)) reject(i, "group length", octave.lengthAlong, "> 0 m");
  if (!positive(octave.lengthAcross)) reject(i, "crest length", octave.lengthAcross, "> 0 m");
}

void check(const std::vector<Octave>& octaves, const WaveFieldSettings& settings) {
  for (std::size_t i = 0; i < octaves.size(); ++i) check(octaves[i], i);
  if (!(settings.depth > 0.0)) throw InputError("depth must be > 0 m");
  if (!std::isfinite(settings.current.x) || !std::isfinite(settings.current.y)) {
    throw InputError("current must be finite");
  }
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Rounding of a kernel's float arithmetic relative to an octave's standard deviation: fractions of
/// cells and turns carry 2⁻²⁵ and cost up to 2π per turn; polynomials err by 5e-7; sums add a few
/// roundings of the peak. Measured largest: tests/surface/field_kernels_test.cpp.
constexpr double kernelRounding = 4e-6;

/// Writes samples of points that are all served: `blank` with the tile's heights and derivatives.
void finishServed(const WaveField& field, std::span<const glm::dvec2> points,
                  const SurfaceSample& blank, Quantities what, const Tile& tile,
                  std::span<SurfaceSample> out) noexcept {
  const bool derivatives = what != Quantities::height;
  const float* height = tile.sum(0);
  const float* slopeX = derivatives ? tile.sum(1) : nullptr;
  const float* slopeY = derivatives ? tile.sum(2) : nullptr;
  const float* rate = derivatives ? tile.sum(3) : nullptr;
  for (std::size_t p = 0; p < points.size(); ++p) {
    SurfaceSample& sample = out[p];
    sample = blank;
    sample.height = height[p];
    if (derivatives) {
      sample.slope = {slopeX[p], slopeY[p]};
      sample.verticalVelocity = rate[p];
    }
    sample.bound = field.bound(glm::length(points[p]));
  }
}

}  // namespace

WaveField::WaveField(std::vector<Octave> octaves, const WaveFieldSettings& settings)
    : settings_(settings) {
  check(octaves, settings_);
  // Each octave keeps the lattice of its place in the given order, however its rank changes. Still
  // octaves would cost time for nothing.
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < octaves.size(); ++i) {
    if (octaves[i].standardDeviation > 0.0) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return octaves[a].standardDeviation > octaves[b].standardDeviation;
  });

  double peaks = 0.0;
  keptByKind_.push_back({});
  for (const std::size_t i : order) {
    const Octave& octave = octaves[i];
    octaves_.push_back(octave);
    KeptOctaves kept = keptByKind_.back();
    double peakFactor = PerlinOctave::peakFactor();
    if (octave.kind == OctaveKind::perlin) {
      perlins_.emplace_back(octave, settings_.seed, i, settings_.current);
      boundPerMetre_ += perlins_.back().roundingBound(1.0);
      ++kept.perlins;
    } else {
      const bool regular = octave.kind == OctaveKind::regular;
      auto& list = regular ? regulars_ : groups_;
      list.emplace_back(octave, settings_.seed, i, settings_.current, settings_.depth);
      boundPerMetre_ += list.back().roundingBound(1.0);
      peakFactor = list.back().peakFactor();
      ++(regular ? kept.regulars : kept.groups);
    }
    keptByKind_.push_back(kept);
    peaks += octave.standardDeviation * peakFactor;
    floatBound_ += kernelRounding * octave.standardDeviation;
  }

  leftOut_.assign(octaves_.size() + 1, 0.0);
  double variance = 0.0;
  for (std::size_t i = octaves_.size(); i-- > 0;) {
    variance += octaves_[i].standardDeviation * octaves_[i].standardDeviation;
    leftOut_[i] = std::sqrt(variance);
  }
  // Regular waves are no Gaussian sea: a focused group reaches the sum of its amplitudes.
  heightBound_ = regulars_.empty() ? std::min(5.5 * standardDeviation(), peaks) : peaks;
}

std::size_t WaveField::octavesFor(double tolerance) const {
  std::size_t kept = 0;
  while (leftOut_[kept] > tolerance) ++kept;
  return kept;
}

WaveField::Selection WaveField::select(const SampleOptions& options) const noexcept {
  const std::size_t count =
      options.tolerance > 0.0 ? octavesFor(options.tolerance) : octaves_.size();
  const Quantities what = options.orbitalVelocity ? Quantities::orbital
                          : options.derivatives   ? Quantities::surface
                                                  : Quantities::height;
  Selection selection{keptByKind_[count], leftOut_[count], SampleStatus::ok, what};
  if (options.shortestWavelength > 0.0) {
    selection.kept.shortestWavelength = static_cast<float>(options.shortestWavelength);
    double variance = leftOut_[count] * leftOut_[count];
    for (std::size_t i = 0; i < count; ++i) {
      const bool kept =
          static_cast<float>(dominantWavelength(octaves_[i])) >= selection.kept.shortestWavelength;
      if (!kept) variance += octaves_[i].standardDeviation * octaves_[i].standardDeviation;
    }
    selection.error = std::sqrt(variance);
  }
  if (selection.error > 0.0) selection.status |= SampleStatus::truncated;
  if (what == Quantities::orbital && selection.kept.perlins > 0) {
    selection.status |= SampleStatus::noKinematics;
  }
  return selection;
}

double WaveField::bound(double reach) const noexcept {
  return floatBound_ + boundPerMetre_ * (1.0 + reach);
}

SurfaceSample WaveField::blank(glm::dvec2 point, double t,
                               const Selection& selection) const noexcept {
  SurfaceSample sample;
  if (serves(point, t)) {
    sample.error = selection.error;
    sample.status = selection.status;
    if (selection.what == Quantities::height) {
      sample.slope.x = sample.slope.y = sample.verticalVelocity = nan;
    }
    return sample;
  }
  sample.height = sample.slope.x = sample.slope.y = sample.verticalVelocity = nan;
  sample.error = sample.bound = nan;
  const bool finite = std::isfinite(t) && std::isfinite(point.x) && std::isfinite(point.y);
  sample.status = finite ? SampleStatus::outOfRange : SampleStatus::notFinite;
  return sample;
}

void WaveField::finish(std::span<const glm::dvec2> points, double t, const Selection& selection,
                       const Tile& tile, std::span<SurfaceSample> out) const noexcept {
  if (tile.allServed() && serves({0.0, 0.0}, t) && selection.what != Quantities::orbital) {
    finishServed(*this, points, blank({0.0, 0.0}, t, selection), selection.what, tile, out);
    return;
  }
  for (std::size_t p = 0; p < points.size(); ++p) {
    SurfaceSample sample = blank(points[p], t, selection);
    if (!std::isnan(sample.height)) {
      tile.store(p, settings_.current, sample);
      sample.bound = bound(glm::length(points[p]));
    }
    out[p] = sample;
  }
}

void WaveField::sample(std::span<const glm::dvec2> points, double t, std::span<SurfaceSample> out,
                       const SampleOptions& options) const noexcept {
  const Selection selection = select(options);
  const std::size_t sections = serves({0.0, 0.0}, t) ? FieldSection::count(lists()) : 0;
  FieldSection section;
  if (sections > 0) section.prepare(lists(), 0, t);
  Tile tile(selection.what);
  for (std::size_t first = 0; first < points.size(); first += pointsPerTile) {
    const std::size_t count = std::min(pointsPerTile, points.size() - first);
    tile.load(points.subspan(first, count));
    for (std::size_t s = 0; s < sections; ++s) {
      if (sections > 1) section.prepare(lists(), s, t);
      section.addBatch(selection.kept, tile.x(), tile.y(), count, tile.sums());
    }
    finish(points.subspan(first, count), t, selection, tile, out.subspan(first, count));
  }
}

FieldAtTime WaveField::at(double t) const { return FieldAtTime(*this, t); }

void WaveField::sampleReference(std::span<const glm::dvec2> points, double t,
                                std::span<SurfaceSample> out,
                                const SampleOptions& options) const noexcept {
  const Selection selection = select(options);
  for (std::size_t p = 0; p < points.size(); ++p) {
    out[p] = blank(points[p], t, selection);
    const bool defined = options.orbitalVelocity && !std::isnan(out[p].height) &&
                         !has(out[p].status, SampleStatus::noKinematics);
    if (defined) out[p].orbitalVelocity = glm::dvec3(0.0);
  }
  if (!serves({0.0, 0.0}, t)) return;
  const auto add = [&](const auto& octave, glm::dvec2 orbitalPerHeight) {
    if (static_cast<float>(octave.wavelength()) < selection.kept.shortestWavelength) return;
    const auto time = octave.at(t);
    for (std::size_t p = 0; p < points.size(); ++p) {
      SurfaceSample& sample = out[p];
      if (std::isnan(sample.height)) continue;
      const OctaveSample part = octave.sample(points[p], time);
      sample.height += part.height;
      sample.slope += part.slope;
      sample.verticalVelocity += part.verticalVelocity;
      sample.bound += octave.roundingBound(glm::length(points[p]));
      sample.orbitalVelocity +=
          glm::dvec3(orbitalPerHeight * part.height,
                     part.verticalVelocity + glm::dot(settings_.current, part.slope));
    }
  };
  const KeptOctaves& kept = selection.kept;
  for (std::size_t i = 0; i < kept.groups; ++i) {
    add(groups_[i], groups_[i].orbitalVelocityPerHeight());
  }
  for (std::size_t i = 0; i < kept.perlins; ++i) add(perlins_[i], glm::dvec2(nan));
  for (std::size_t i = 0; i < kept.regulars; ++i) {
    add(regulars_[i], regulars_[i].orbitalVelocityPerHeight());
  }
}

std::size_t WaveField::memoryBytes() const {
  return octaves_.size() * (sizeof(Octave) + sizeof(double) + sizeof(KeptOctaves)) +
         (groups_.size() + regulars_.size()) * sizeof(GroupOctave) +
         perlins_.size() * sizeof(PerlinOctave);
}

}  // namespace seaway
