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

/// Four neighbours of a texture coordinate and how far it is from the first: in two rows, `across`
/// texels from the left one to the right.
struct Corners {
  VI low, high;  // the left ones
  VI across;
  bool areBeside;  // across is 1 for all
  Real2 part;
};

/// `place` in texels, (0, 0) the first texel's centre, held to the edge. Where there are not two
/// columns and rows, what lies before the first texel is read and does not count.
HWY_INLINE Corners clampedCorners(Real2 place, Real columns, Real rows, VI start) {
  const Real lastX = columns - 1.0f, lastY = rows - 1.0f;
  const Real x = clamp(place.x, 0.0f, lastX), y = clamp(place.y, 0.0f, lastY);
  const Real left = min(floor(x), lastX - 1.0f), low = min(floor(y), lastY - 1.0f);
  // Indices stay below 2²⁴: exact in float.
  const VI first = hn::Add(start, toInt(low * columns + left));
  return {first, hn::Add(first, toInt(columns)), setInt(1), true, {x - left, y - low}};
}

/// The same where the texture repeats; `side` a power of two.
HWY_INLINE Corners wrappedCorners(Real2 place, Real side, VI start) {
  const Real x0 = floor(place.x), y0 = floor(place.y);
  const VI last = hn::Sub(toInt(side), setInt(1)), one = setInt(1);
  const VI xi = toInt(x0), yi = toInt(y0);
  const VI left = hn::And(xi, last), right = hn::And(hn::Add(xi, one), last);
  const VI low = hn::Add(start, toInt(toReal(hn::And(yi, last)) * side));
  const VI high = hn::Add(start, toInt(toReal(hn::And(hn::Add(yi, one), last)) * side));
  return {hn::Add(low, left),
          hn::Add(high, left),
          hn::Sub(right, left),
          hn::AllTrue(Ints(), hn::Gt(right, left)),
          {place.x - x0, place.y - y0}};
}

/// What the texels at corners are, by rows.
struct CornerTexels {
  Pairs low, high;
};
template <class Texel>
HWY_INLINE CornerTexels gatherCorners(const Texel* texels, const Corners& c) {
  if (c.areBeside) return {gatherPairs(texels, c.low), gatherPairs(texels, c.high)};
  return {{wordsAt(texels, c.low), wordsAt(texels, hn::Add(c.low, c.across))},
          {wordsAt(texels, c.high), wordsAt(texels, hn::Add(c.high, c.across))}};
}

/// Between numbers at corners.
HWY_INLINE Real bilinear(const float* texels, const Corners& c) {
  const CornerTexels at = gatherCorners(texels, c);
  const auto real = [](VU word) HWY_ATTR { return Real(hn::BitCast(Floats(), word)); };
  return mix(mix(real(at.low.first), real(at.low.second), c.part.x),
             mix(real(at.high.first), real(at.high.second), c.part.x), c.part.y);
}

/// Sum of light kept as RGB9E5 words, mantissas times 2^(exponent − 24); green and blue are added
/// up 2⁹ and 2¹⁸ times too large, which is exact and spares shifting them.
struct SharedExponentSum {
  Real3 sum;

  HWY_INLINE SharedExponentSum() : sum(0.0f, 0.0f, 0.0f) {}
  HWY_INLINE void add(VU word, Real weight) {
    const VU exponent = hn::Add(hn::ShiftRight<27>(word), hn::Set(Words(), 127u - 24u));
    const Real scale = hn::BitCast(Floats(), hn::ShiftLeft<23>(exponent));
    const Real factor = weight * scale;
    const auto field = [&](std::uint32_t bits) HWY_ATTR {
      return toReal(hn::BitCast(Ints(), hn::And(word, hn::Set(Words(), bits))));
    };
    sum = sum + Real3(field(0x1FFu), field(0x1FFu << 9), field(0x1FFu << 18)) * factor;
  }
  HWY_INLINE Real3 light() const { return {sum.x, sum.y * 0x1.0p-9f, sum.z * 0x1.0p-18f}; }
};

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

/// Adds light between corners, times `weight`.
HWY_INLINE void addBilinear(const std::uint32_t* texels, const Corners& c, Real weight,
                            SharedExponentSum& sum) {
  const CornerTexels at = gatherCorners(texels, c);
  const Real high = c.part.y * weight, low = weight - high;
  const Real highRight = c.part.x * high, lowRight = c.part.x * low;
  sum.add(at.low.first, low - lowRight);
  sum.add(at.low.second, lowRight);
  sum.add(at.high.first, high - highRight);
  sum.add(at.high.second, highRight);
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
