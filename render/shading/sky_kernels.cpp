#include "render/shading/sky_kernels.h"

#include "render/shading/sky_dome.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shading/sky_kernels.cpp"
#include "hwy/foreach_target.h"
#include "render/shading/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace seaway::render {
namespace HWY_NAMESPACE {
namespace {

constexpr float pi = 3.14159265f;
constexpr float asymmetry = 0.76f;  // of the aerosol's phase function
constexpr glm::vec3 solar(20.0f, 19.6f, 18.6f);
// Zenith optical depths at 650, 550, 440 nm.
constexpr glm::vec3 rayleigh(0.046f, 0.108f, 0.262f), aerosol(0.050f, 0.055f, 0.060f);
// Twilight: the blue of high air by ozone, greyer through the haze of the horizon, and the warm
// arch where the sun went down.
constexpr glm::vec3 twilightBlue(0.040f, 0.098f, 0.225f), twilightGrey(0.085f, 0.105f, 0.135f),
    twilightArch(0.66f, 0.31f, 0.095f);

/// Path through the air in zenith paths; 33 at the horizon.
HWY_INLINE Real airMass(Real sineOfElevation) {
  const Real s = max(sineOfElevation, 0.0f);
  return Real(1.0f) / (s + Real(0.03f) * exp(Real(-9.0f) * s));
}

HWY_INLINE Real3 sunlight(Real3 sun) {
  return Real3(solar) * exp(-Real3(rayleigh + aerosol) * airMass(sun.z)) *
         smoothstep(-0.01f, 0.01f, sun.z);
}

/// What is left of scattered light after sunset.
HWY_INLINE Real daylight(Real3 sun) { return exp(Real(30.0f) * min(sun.z + 0.01f, 0.0f)); }

/// Part of the sky that is twilight's: once the sun's rays no longer reach the air below, single
/// scattering in a plane layer says nothing.
HWY_INLINE Real duskPart(Real3 sun) { return Real(1.0f) - smoothstep(-0.09f, 0.11f, sun.z); }
/// The arch fades before the blue does.
HWY_INLINE Real archPart(Real3 sun) { return exp(Real(7.0f) * min(sun.z, 0.0f)); }

/// Horizontal unit vector, shorter towards the vertical: levelDirection of sea_shading.glsl.h.
HWY_INLINE Real2 levelled(Real3 direction) {
  const Real2 level(direction.x, direction.y);
  return level * inversesqrt(max(dot(level, level), Real(0.04f) * dot(direction, direction)));
}

HWY_INLINE Real3 twilight(Real3 direction, Real3 sun) {
  const Real up = max(direction.z, 0.0f);
  const Real side = Real(0.5f) + Real(0.5f) * dot(levelled(direction), Real2(sun.x, sun.y));
  const Real strength = duskPart(sun) * daylight(sun);
  const Real blue = (Real(0.30f) + Real(0.70f) * exp(Real(-2.2f) * up)) *
                    (Real(0.5f) + Real(0.5f) * side) * strength;
  const Real arch = side * side * side * archPart(sun) * strength;
  // Orange below, yellow and then pale above: red falls off first.
  const Real3 fall(exp(Real(-9.5f) * up), exp(Real(-7.0f) * up), exp(Real(-5.0f) * up));
  const Real3 dome = mix(Real3(twilightBlue), Real3(twilightGrey), exp(Real(-9.0f) * up));
  return dome * blue + Real3(twilightArch) * fall * arch;
}

/// Radiance at an elevation but for the phase functions: weights of the two, and what has none.
struct Scattered {
  Real3 rayleighWeight, aerosolWeight, often;
};

HWY_INLINE Scattered scattered(Real sineOfElevation, Real3 sun) {
  const Real seen = airMass(sineOfElevation), lit = airMass(sun.z);
  const Real3 depth(rayleigh + aerosol);
  // Integral of exp(−t lit) exp(−(depth − t) seen) over the layer, stable where both are equal.
  const Real3 x = depth * (seen - lit);
  const auto stable = [](Real value) {
    const Mask small = abs(value) < 1e-3f;
    const Real safe = choose(small, 1.0f, value);
    return choose(small, 1.0f, (Real(1.0f) - exp(-safe)) / safe);
  };
  const Real3 shape(stable(x.x), stable(x.y), stable(x.z));
  const Real day = daylight(sun) * (Real(1.0f) - duskPart(sun));
  const Real3 once = Real3(solar) * exp(-depth * lit) * shape * (seen * day);
  const Real3 one(1.0f, 1.0f, 1.0f);
  const Real3 often = Real3(solar) * Real(0.055f) *
                      (one - exp(-Real3(rayleigh + 0.6f * aerosol) * seen)) *
                      exp(-depth * (Real(0.14f) * lit)) * day;
  return {once * Real3(rayleigh * (3.0f / (16.0f * pi))),
          once * Real3(aerosol * (0.65f * (1.0f - asymmetry * asymmetry) / (4.0f * pi))), often};
}

HWY_INLINE Real3 clearSky(Real3 direction, Real3 sun) {
  const Scattered parts = scattered(direction.z, sun);
  const Real cosine = dot(direction, sun);
  const Real base =
      max(Real(1.0f + asymmetry * asymmetry) - Real(2.0f * asymmetry) * cosine, 1e-3f);
  return parts.often + parts.rayleighWeight * (Real(1.0f) + cosine * cosine) +
         parts.aerosolWeight * (Real(1.0f) / (base * sqrt(base))) + twilight(direction, sun);
}

HWY_INLINE Real scrambled(VI x, VI y) {
  const Words w;
  VU h = hn::Xor(hn::Mul(hn::BitCast(w, x), hn::Set(w, 0x9E3779B1u)),
                 hn::Mul(hn::BitCast(w, y), hn::Set(w, 0x85EBCA77u)));
  h = hn::Mul(hn::Xor(h, hn::ShiftRight<15>(h)), hn::Set(w, 0x2C1B3C6Du));
  h = hn::Mul(hn::Xor(h, hn::ShiftRight<13>(h)), hn::Set(w, 0x297A2D39u));
  h = hn::Xor(h, hn::ShiftRight<16>(h));
  return toReal(hn::BitCast(Ints(), hn::ShiftRight<8>(h))) * Real(0x1p-24f);
}

HWY_INLINE Real valueNoise(Real2 p) {
  const Real2 cell(floor(p.x), floor(p.y));
  Real2 f = p - cell;
  f = {f.x * f.x * (Real(3.0f) - Real(2.0f) * f.x), f.y * f.y * (Real(3.0f) - Real(2.0f) * f.y)};
  const VI x = toInt(cell.x), y = toInt(cell.y), one = setInt(1);
  const VI x1 = hn::Add(x, one), y1 = hn::Add(y, one);
  return mix(mix(scrambled(x, y), scrambled(x1, y), f.x),
             mix(scrambled(x, y1), scrambled(x1, y1), f.x), f.y);
}

HWY_INLINE Real clouds(Real2 p) {
  const auto shifted = [&](float by) { return valueNoise({p.x * 0.7f + by, p.y * 0.7f + by}); };
  p = p + Real2(shifted(11.0f), shifted(-5.0f)) * 0.35f;
  Real sum = 0.0f;
  float amplitude = 0.5f;
  for (int i = 0; i < 5; ++i) {
    sum = sum + Real(amplitude) * valueNoise(p);
    p = Real2(Real(1.55f) * p.x - Real(1.25f) * p.y + 3.7f,
              Real(1.25f) * p.x + Real(1.55f) * p.y + 3.7f);
    amplitude *= 0.5f;
  }
  return sum;
}

/// Below the horizon it goes on as at the horizon.
HWY_INLINE Real3 skyWithClouds(Real3 direction, Real3 sun) {
  const Real3 clear = clearSky(direction, sun);
  const Real up = max(direction.z, 0.0f);
  const Real2 overhead = Real2(direction.x, direction.y) / (up + 0.10f);
  // Long streaks: high thin cloud drawn out by the wind aloft.
  const Real streaks = clouds({Real(0.55f) * overhead.x + 2.3f, Real(1.5f) * overhead.y + 2.3f});
  const Real cover =
      Real(0.75f) * smoothstep(0.47f, 0.85f, streaks) * smoothstep(0.015f, 0.22f, up);
  Real forward = max(dot(direction, sun), 0.0f);
  for (int i = 0; i < 3; ++i) forward = forward * forward;
  const Real3 lit = sunlight(sun) * (Real(0.075f) + Real(0.11f) * forward) +
                    clearSky(Real3(glm::vec3(0.0f, 0.0f, 1.0f)), sun) * Real(0.6f) +
                    clear * Real(0.35f);
  return mix(clear, lit, cover);
}

void SkyRow(const SkyLights& lights, int row, int side, float* rgb) {
  const Floats f;
  const std::size_t lanes = hn::Lanes(f);
  const Real y = 2.0f * (row + 0.5f) / side - 1.0f;
  for (int first = 0; first < side; first += static_cast<int>(lanes)) {
    const Real x = (Real(hn::Iota(f, first + 0.5f)) * Real(2.0f / side)) - 1.0f;
    const Real squared = x * x + y * y, s = min(squared, 1.0f);
    const Real inside = inversesqrt(max(squared, 1.0f));
    const Real scale = Real(2.0f) / (Real(1.0f) + s);
    const Real3 direction(x * inside * scale, y * inside * scale,
                          (Real(1.0f) - s) / (Real(1.0f) + s));
    Real3 colour = skyWithClouds(direction, Real3(lights.sun)) + Real3(nightSky);
    if (lights.moonPart > 0.0f) {
      colour = colour + skyWithClouds(direction, Real3(lights.moon)) * Real(lights.moonPart);
    }
    hn::StoreInterleaved3(colour.x.v, colour.y.v, colour.z.v, f, rgb + 3 * first);
  }
}

glm::vec3 firstLane(Real3 value) {
  return {hn::GetLane(value.x.v), hn::GetLane(value.y.v), hn::GetLane(value.z.v)};
}

glm::vec3 SunIrradiance(glm::vec3 sun) { return firstLane(sunlight(Real3(sun))); }

HorizonLight Horizon(glm::vec3 direction) {
  const Real3 sun(direction);
  const Scattered parts = scattered(0.0f, sun);
  const glm::vec3 grey =
      0.5f * twilightGrey * firstLane(Real3(glm::vec3(1.0f)) * duskPart(sun) * daylight(sun));
  const glm::vec3 arch = twilightArch * firstLane(Real3(glm::vec3(1.0f)) * duskPart(sun) *
                                                  daylight(sun) * archPart(sun));
  return {firstLane(parts.rayleighWeight),
          firstLane(parts.aerosolWeight),
          firstLane(parts.often) + grey,
          grey,
          arch,
          asymmetry};
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace seaway::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace seaway::render {

HWY_EXPORT(SkyRow);
HWY_EXPORT(SunIrradiance);
HWY_EXPORT(Horizon);

void drawSkyRow(const SkyLights& lights, int row, int side, float* rgb) {
  HWY_DYNAMIC_DISPATCH(SkyRow)(lights, row, side, rgb);
}
glm::vec3 sunIrradiance(glm::vec3 sunDirection) {
  return HWY_DYNAMIC_DISPATCH(SunIrradiance)(sunDirection);
}
HorizonLight horizonLight(glm::vec3 sunDirection) {
  return HWY_DYNAMIC_DISPATCH(Horizon)(sunDirection);
}

}  // namespace seaway::render
#endif
