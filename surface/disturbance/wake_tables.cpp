#include "surface/disturbance/wake_tables.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>
#include <utility>

#include "surface/constants.h"
#include "surface/dispersion.h"
#include "surface/input_error.h"

namespace seaway {
namespace {

/// 0 for x ≤ 0, 1 for x ≥ 1, two continuous derivatives.
double smoothStep(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * x * (x * (6.0 * x - 15.0) + 10.0);
}

/// The step from 0 at wavelength `none` to 1 at wavelength `all`.
double step(double wavelength, double none, double all) {
  return smoothStep(std::log(wavelength / none) / std::log(all / none));
}

/// Cosine and sine in float of a rotation that keeps lengths: the smaller follows from the larger,
/// as rounded. Each rounded by itself would change an amplitude by up to 6e-8 at every turn, always
/// the same way. Where that would turn the angle by more than 1e-5 of it (very small ones) they
/// are.
std::pair<float, float> rotation(double angle) {
  const float c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
  const bool cosineIsLarger = std::abs(c) > std::abs(s);
  const double larger = cosineIsLarger ? c : s, smaller = cosineIsLarger ? s : c;
  const double kept = std::copysign(std::sqrt(std::max(0.0, 1.0 - larger * larger)), smaller);
  if (std::abs(kept - smaller) > 1e-5 * std::abs(smaller)) return {c, s};
  return cosineIsLarger ? std::pair(c, static_cast<float>(kept))
                        : std::pair(static_cast<float>(kept), s);
}

bool powerOfTwo(int value) {
  return value > 0 && std::has_single_bit(static_cast<unsigned>(value));
}

}  // namespace

double WavelengthBand::weight(double k) const {
  if (!(k > 0.0)) return 0.0;
  const double wavelength = 2.0 * pi / k;
  double weight = step(wavelength, shortNone, shortAll);
  if (std::isfinite(longNone)) weight *= 1.0 - step(wavelength, longAll, longNone);
  return weight;
}

bool WakeWindowSettings::operator==(const WakeWindowSettings& other) const {
  return cellSize == other.cellSize && cells == other.cells && modes == other.modes &&
         depth == other.depth && absorption == other.absorption &&
         band.shortNone == other.band.shortNone && band.shortAll == other.band.shortAll &&
         band.longAll == other.band.longAll && band.longNone == other.band.longNone;
}

void check(const WakeWindowSettings& settings) {
  const WavelengthBand& band = settings.band;
  if (!(settings.cellSize > 0.0) || !std::isfinite(settings.size())) {
    throw InputError("a wake window's cells must be > 0 m");
  }
  if (!powerOfTwo(settings.cells) || !powerOfTwo(settings.modes) || settings.modes < 32 ||
      settings.modes > settings.cells || settings.cells > 8192) {
    throw InputError(
        "a wake window's cells and modes must be powers of two, 32 <= modes <= cells <= 8192");
  }
  if (!(settings.depth > 0.0)) throw InputError("a wake window's depth must be > 0 m");
  if (!(settings.absorption >= 0.0))
    throw InputError("a wake window's absorption must be >= 0 1/s");
  if (!(band.shortNone >= settings.wavelengthLimit() * (1.0 - 1e-9)) ||
      !(band.shortAll > band.shortNone) || !(band.longAll >= band.shortAll) ||
      (std::isfinite(band.longNone) && !(band.longNone > band.longAll))) {
    throw InputError("a wake window's wavelengths must rise, from what its modes can carry");
  }
}

WakeTables::WakeTables(const WakeWindowSettings& s, double step)
    : settings(s),
      dt(step),
      halfTurn(s.modes, static_cast<std::size_t>(s.modes) / 2 + 1),
      cosine(halfTurn),
      sine(halfTurn),
      gain(halfTurn),
      share(halfTurn),
      omega(halfTurn),
      gravityOverOmega(halfTurn),
      prefilter(halfTurn.stride) {
  const int half = s.modes / 2;
  const double spacing = 2.0 * pi / s.size();
  for (int c = 0; c < s.modes; ++c) {
    prefilter[c] = static_cast<float>(3.0 / (2.0 + std::cos(spacing * (c - half) * s.cellSize)));
  }
  for (int r = 0; r <= half; ++r) {
    int first = s.modes, last = -1;
    for (int c = 1; c < s.modes && r < half; ++c) {
      const double k = spacing * std::hypot(c - half, r);
      if (k == 0.0 || 2.0 * pi / k <= s.band.shortNone) continue;
      first = std::min(first, c), last = c;
      const double frequency = angularFrequency(k, s.depth);
      halfTurn.row(r)[c] = static_cast<float>(0.5 * frequency * dt);
      std::tie(cosine.row(r)[c], sine.row(r)[c]) = rotation(0.5 * frequency * dt);
      const double part = s.band.weight(k) / (s.size() * s.size());
      share.row(r)[c] = static_cast<float>(part);
      gain.row(r)[c] = static_cast<float>(part * frequency * dt);
      omega.row(r)[c] = static_cast<float>(frequency);
      gravityOverOmega.row(r)[c] = static_cast<float>(standardGravity / frequency);
    }
    begin.push_back(last < 0 ? 0 : std::min(first, s.modes - last));
    end.push_back(last < 0 ? 0 : s.modes - begin.back() + 1);
  }
}

std::size_t WakeTables::memoryBytes() const { return 7 * cosine.values.size() * sizeof(float); }

}  // namespace seaway
