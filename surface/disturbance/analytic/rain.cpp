#include "surface/disturbance/analytic/rain.h"

#include <algorithm>
#include <cmath>

#include "surface/constants.h"
#include "surface/field/lattice_hash.h"

namespace seaway {
namespace {

/// How often a slot's drop has fallen, and how far into the present fall it is, [0, 1).
struct Fall {
  std::uint32_t count;
  float part;
};

Fall fallAt(double t, float offset) {
  const double turns = t / Rain::lifetime;
  const double whole = std::floor(turns);
  const auto part = static_cast<float>(turns - whole) + offset;
  const auto count = cellBits(whole);
  return part < 1.0f ? Fall{count, part} : Fall{count + 1u, part - 1.0f};
}

float unit(std::uint32_t bits) { return static_cast<float>(bits & 0xFFFFu) * (1.0f / 65536.0f); }

}  // namespace

Rain Rain::ofRate(double rate, std::uint64_t seed) {
  const double part = std::clamp(rate / 50.0, 0.0, 1.0);
  Rain rain;
  rain.drops = mostDrops * std::sqrt(part);
  rain.seed = static_cast<std::uint32_t>(mixSeed(seed));
  return rain;
}

Rain::Drop Rain::drop(std::int64_t i, std::int64_t j, int slot, double t) const noexcept {
  const auto x = static_cast<std::uint32_t>(i), y = static_cast<std::uint32_t>(j);
  const auto number = static_cast<std::uint32_t>(slot);
  const float offset = unit(cornerHash(x, y, {seed, seed + 2u * number}));
  const Fall fall = fallAt(t, offset);
  const std::uint32_t place =
      cornerHash(x, y, {seed + fall.count * latticeSecondFactor, seed + 2u * number + 1u});
  // A ring fills half a cell at the most, its packet included.
  Drop drop;
  drop.x = unit(place) * static_cast<float>(cell);
  drop.y = unit(place >> 16) * static_cast<float>(cell);
  drop.age = fall.part * static_cast<float>(lifetime);
  drop.falls = static_cast<float>(number) + offset < static_cast<float>(drops);
  return drop;
}

// A packet of ripples that widens and dies away: h = H s(τ) (1 − τ/T)² (1 − u²)² cos(2π(r − cτ)/λ),
// u = (r − cτ)/width; s rises from 0 to 1 in the first tenth of T.
Rain::Ring Rain::ring(float r, float age) noexcept {
  constexpr auto turn = static_cast<float>(2.0 * pi / wavelength);
  constexpr auto perWidth = static_cast<float>(1.0 / halfWidth);
  constexpr auto pace = static_cast<float>(speed);
  const float behind = r - pace * age, u = behind * perWidth;
  const float inside = 1.0f - u * u;
  if (!(inside > 0.0f)) return {0.0f, 0.0f, 0.0f};
  constexpr auto perRise = static_cast<float>(10.0 / lifetime);
  const float left = 1.0f - age * static_cast<float>(1.0 / lifetime);
  const float risen = std::min(age * perRise, 1.0f);
  const float packet = inside * inside, wave = std::cos(turn * behind);
  const float begun = risen * risen * (3.0f - 2.0f * risen);
  const float strength = static_cast<float>(ringHeight) * left * left * begun;
  const float strengthRate =
      static_cast<float>(ringHeight) * left *
      (6.0f * risen * (1.0f - risen) * perRise * left - static_cast<float>(2.0 / lifetime) * begun);
  const float byBehind =
      strength * (-4.0f * u * perWidth * inside * wave - packet * turn * std::sin(turn * behind));
  return {strength * packet * wave, byBehind, strengthRate * packet * wave - pace * byBehind};
}

Rain::Value Rain::at(glm::dvec2 point, double t) const noexcept {
  Value sum;
  if (!falls(t) || !std::isfinite(point.x + point.y) || !std::isfinite(t)) return sum;
  // Of the four cells whose corner is nearest.
  const double x = point.x / cell - 0.5, y = point.y / cell - 0.5;
  const double left = std::floor(x), low = std::floor(y);
  const int slots = static_cast<int>(std::ceil(drops));
  for (int c = 0; c < 4; ++c) {
    const double i = left + (c & 1), j = low + (c >> 1);
    const auto inX = static_cast<float>(point.x - i * cell);
    const auto inY = static_cast<float>(point.y - j * cell);
    for (int slot = 0; slot < slots; ++slot) {
      const Drop fallen = drop(static_cast<std::int64_t>(i), static_cast<std::int64_t>(j), slot, t);
      if (!fallen.falls) continue;
      const float offX = inX - fallen.x, offY = inY - fallen.y;
      // Round at the middle, where a cone would have no slope.
      const float r = std::sqrt(offX * offX + offY * offY + 1e-4f);
      const Ring at = ring(r, fallen.age);
      const float perDistance = at.byDistance / r;
      sum.height += at.height;
      sum.slopeX += perDistance * offX;
      sum.slopeY += perDistance * offY;
      sum.rate += at.byTime;
    }
  }
  return sum;
}

}  // namespace seaway
