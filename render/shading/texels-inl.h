// Lookups of tables and mip chains for a vector of pixels: what textures do for GLSL. Once per
// instruction set (Highway's per-target include).

#if defined(SEAWAY_RENDER_TEXELS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SEAWAY_RENDER_TEXELS_INL_H_
#undef SEAWAY_RENDER_TEXELS_INL_H_
#else
#define SEAWAY_RENDER_TEXELS_INL_H_
#endif

#include <cstdint>

#include "render/shading/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace seaway::render {
namespace HWY_NAMESPACE {

/// Four neighbours of a texture coordinate and how far it is from the first.
struct Corners {
  VI at[4];
  Real2 part;
};

/// `place` in texels, (0, 0) the first texel's centre; indices clamped to the edge.
HWY_INLINE Corners clampedCorners(Real2 place, Real columns, Real rows, VI start) {
  const Real x0 = clamp(floor(place.x), 0.0f, columns - 1.0f);
  const Real y0 = clamp(floor(place.y), 0.0f, rows - 1.0f);
  const Real x1 = min(x0 + 1.0f, columns - 1.0f), y1 = min(y0 + 1.0f, rows - 1.0f);
  // Indices stay below 2²⁴: exact in float.
  const VI low = hn::Add(start, toInt(y0 * columns)), high = hn::Add(start, toInt(y1 * columns));
  const VI left = toInt(x0), right = toInt(x1);
  return {{hn::Add(low, left), hn::Add(low, right), hn::Add(high, left), hn::Add(high, right)},
          {clamp(place.x - x0, 0.0f, 1.0f), clamp(place.y - y0, 0.0f, 1.0f)}};
}

/// The same where the texture repeats; `side` a power of two.
HWY_INLINE Corners wrappedCorners(Real2 place, Real side, VI start) {
  const Real x0 = floor(place.x), y0 = floor(place.y);
  const VI last = hn::Sub(toInt(side), setInt(1)), one = setInt(1);
  const VI xi = toInt(x0), yi = toInt(y0);
  const VI left = hn::And(xi, last), right = hn::And(hn::Add(xi, one), last);
  const VI low = hn::Add(start, toInt(toReal(hn::And(yi, last)) * side));
  const VI high = hn::Add(start, toInt(toReal(hn::And(hn::Add(yi, one), last)) * side));
  return {{hn::Add(low, left), hn::Add(low, right), hn::Add(high, left), hn::Add(high, right)},
          {place.x - x0, place.y - y0}};
}

HWY_INLINE Real3 sharedExponentLight(VU word) {
  // RGB9E5: mantissas times 2^(exponent − 24).
  const VU exponent = hn::Add(hn::ShiftRight<27>(word), hn::Set(Words(), 127u - 24u));
  const Real scale = hn::BitCast(Floats(), hn::ShiftLeft<23>(exponent));
  return Real3(bitField<0, 9>(word), bitField<9, 9>(word), bitField<18, 9>(word)) * scale;
}

/// The reverse, rounded; 2⁻²⁴ of red for no light at all.
HWY_INLINE VU sharedExponentWord(Real3 light) {
  const Words w;
  const Real most = max(max(light.x, light.y), light.z);
  // A little more than the largest, so that it is not rounded up to 512.
  const VU above = hn::BitCast(w, min(max(most * 1.001f, 1.6e-5f), 65000.0f).v);
  const VU exponent = hn::Sub(hn::ShiftRight<23>(above), hn::Set(w, 111u));
  const VU inverse = hn::ShiftLeft<23>(hn::Sub(hn::Set(w, 127u + 24u), exponent));
  const Real scale = hn::BitCast(Floats(), inverse);
  const auto mantissa = [&](Real part) HWY_ATTR {
    return hn::BitCast(w, toInt(clamp(part * scale + 0.5f, 0.0f, 511.0f)));
  };
  const VU word = hn::Or(hn::Or(mantissa(light.x), hn::ShiftLeft<9>(mantissa(light.y))),
                         hn::Or(hn::ShiftLeft<18>(mantissa(light.z)), hn::ShiftLeft<27>(exponent)));
  return hn::Max(word, hn::Set(w, 1u));
}

HWY_INLINE Real2 rippleTexel(VU word) {
  const VI bits = hn::BitCast(Ints(), word);
  return {toReal(hn::ShiftRight<16>(hn::ShiftLeft<16>(bits))), toReal(hn::ShiftRight<16>(bits))};
}

template <class Decode>
HWY_INLINE Real3 bilinear(const std::uint32_t* texels, const Corners& c, Decode decode) {
  return mix(mix(decode(gather(texels, c.at[0])), decode(gather(texels, c.at[1])), c.part.x),
             mix(decode(gather(texels, c.at[2])), decode(gather(texels, c.at[3])), c.part.x),
             c.part.y);
}

/// First texel and side of a level, `level` whole.
struct Level {
  VI start;
  Real side;
};
HWY_INLINE Level levelOf(int side, Real level) {
  const Floats f;
  // Neighbours mostly share a level: then nothing waits for what follows.
  const float first = hn::GetLane(level.v);
  if (!anyOf(abs(level - first) > 0.0f)) {
    const int here = side >> static_cast<int>(first);
    return {setInt((side * side - here * here) / 3 * 4), static_cast<float>(here)};
  }
  const VI exponent = hn::Sub(setInt(127), toInt(level));
  const Real part = hn::BitCast(f, hn::ShiftLeft<23>(exponent));  // 2^−level
  const Real here = part * Real(static_cast<float>(side));
  // (side² − here²) · 4/3 is whole: rounding repairs the third.
  const Real start = (Real(static_cast<float>(side * side)) - here * here) * Real(4.0f / 3.0f);
  return {toInt(floor(start + 0.5f)), here};
}

}  // namespace HWY_NAMESPACE
}  // namespace seaway::render
HWY_AFTER_NAMESPACE();

#endif
