// Numbers that differ between pixels, a vector of them at a time: what sea_shading.glsl.h calls
// Real, Real2 and Real3. Once per instruction set (Highway's per-target include).

#if defined(SEAWAY_RENDER_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SEAWAY_RENDER_LANES_INL_H_
#undef SEAWAY_RENDER_LANES_INL_H_
#else
#define SEAWAY_RENDER_LANES_INL_H_
#endif

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "hwy/contrib/math/math-inl.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace seaway::render {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Ints = hn::RebindToSigned<Floats>;
using Words = hn::RebindToUnsigned<Floats>;
using VF = hn::Vec<Floats>;
using VI = hn::Vec<Ints>;
using VU = hn::Vec<Words>;

inline std::size_t laneCount() { return hn::Lanes(Floats()); }

struct Mask {
  hn::Mask<Floats> m;
};
HWY_INLINE Mask operator&&(Mask a, Mask b) { return {hn::And(a.m, b.m)}; }
HWY_INLINE Mask operator||(Mask a, Mask b) { return {hn::Or(a.m, b.m)}; }
HWY_INLINE bool anyOf(Mask a) { return !hn::AllFalse(Floats(), a.m); }

struct Real {
  VF v;
  Real() = default;
  HWY_INLINE Real(VF value) : v(value) {}
  HWY_INLINE Real(float value) : v(hn::Set(Floats(), value)) {}
};
HWY_INLINE Real operator+(Real a, Real b) { return hn::Add(a.v, b.v); }
HWY_INLINE Real operator-(Real a, Real b) { return hn::Sub(a.v, b.v); }
HWY_INLINE Real operator*(Real a, Real b) { return hn::Mul(a.v, b.v); }
HWY_INLINE Real operator-(Real a) { return hn::Neg(a.v); }
HWY_INLINE Mask operator<(Real a, Real b) { return {hn::Lt(a.v, b.v)}; }
HWY_INLINE Mask operator>(Real a, Real b) { return {hn::Gt(a.v, b.v)}; }
HWY_INLINE Mask operator>=(Real a, Real b) { return {hn::Ge(a.v, b.v)}; }
HWY_INLINE Real min(Real a, Real b) { return hn::Min(a.v, b.v); }
HWY_INLINE Real max(Real a, Real b) { return hn::Max(a.v, b.v); }
HWY_INLINE Real abs(Real a) { return hn::Abs(a.v); }
HWY_INLINE Real floor(Real a) { return hn::Floor(a.v); }
HWY_INLINE Real exactQuotient(Real a, Real b) { return hn::Div(a.v, b.v); }
/// By one Newton step on the processor's estimate: 2⁻²² or better, several times as fast as the
/// exact quotient. Not for denominators of 0.
HWY_INLINE Real reciprocal(Real a) {
  const Real estimate = hn::ApproximateReciprocal(a.v);
  return estimate * (Real(2.0f) - a * estimate);
}
HWY_INLINE Real operator/(Real a, Real b) { return a * reciprocal(b); }
/// One Newton step on the processor's estimate: 2⁻²² or better.
HWY_INLINE Real inversesqrt(Real a) {
  const VF estimate = hn::ApproximateReciprocalSqrt(a.v);
  const Real half = Real(0.5f) * a;
  return Real(estimate) * (Real(1.5f) - half * Real(estimate) * Real(estimate));
}
/// ≥ 0; likewise.
HWY_INLINE Real sqrt(Real a) { return a * inversesqrt(max(a, 1e-30f)); }
/// Relative error below 2e-6; from e⁻⁸⁷ on, 0 below nothing.
HWY_INLINE Real exp(Real a) {
  const Real turns = max(a * 1.44269504f, -126.0f);
  const Real whole = hn::Round(turns.v);
  const Real rest = (turns - whole) * 0.69314718f;
  Real sum = Real(1.0f / 120.0f);
  for (const float term : {1.0f / 24.0f, 1.0f / 6.0f, 0.5f, 1.0f, 1.0f}) sum = sum * rest + term;
  const VI exponent =
      hn::ShiftLeft<23>(hn::Add(hn::ConvertTo(Ints(), whole.v), hn::Set(Ints(), 127)));
  return sum * Real(hn::BitCast(Floats(), exponent));
}
/// Error below 0.005: for mip levels.
HWY_INLINE Real log2(Real a) {
  const VI bits = hn::BitCast(Ints(), a.v);
  const Real exponent =
      hn::ConvertTo(Floats(), hn::Sub(hn::ShiftRight<23>(bits), hn::Set(Ints(), 127)));
  const Real mantissa = hn::BitCast(
      Floats(), hn::Or(hn::And(bits, hn::Set(Ints(), 0x7FFFFF)), hn::Set(Ints(), 0x3F800000)));
  // Quadratic in the mantissa, exact at 1 and 2.
  const Real f = mantissa - 1.0f;
  return exponent + f * (Real(1.3465f) - Real(0.3465f) * f);
}
HWY_INLINE Real exactLog2(Real a) { return hn::Log2(Floats(), a.v); }
HWY_INLINE Real clamp(Real a, Real low, Real high) { return min(max(a, low), high); }
HWY_INLINE Real mix(Real a, Real b, Real t) { return a + t * (b - a); }
HWY_INLINE Real choose(Mask m, Real a, Real b) { return hn::IfThenElse(m.m, a.v, b.v); }
HWY_INLINE Real smoothstep(Real low, Real high, Real x) {
  const Real f = clamp((x - low) / (high - low), 0.0f, 1.0f);
  return f * f * (Real(3.0f) - Real(2.0f) * f);
}

struct Real2 {
  Real x, y;
  Real2() = default;
  HWY_INLINE Real2(Real first, Real second) : x(first), y(second) {}
};
HWY_INLINE Real2 operator+(Real2 a, Real2 b) { return {a.x + b.x, a.y + b.y}; }
HWY_INLINE Real2 operator-(Real2 a, Real2 b) { return {a.x - b.x, a.y - b.y}; }
HWY_INLINE Real2 operator*(Real2 a, Real b) { return {a.x * b, a.y * b}; }
HWY_INLINE Real2 operator*(Real a, Real2 b) { return b * a; }
HWY_INLINE Real2 operator/(Real2 a, Real b) { return a * reciprocal(b); }
HWY_INLINE Real dot(Real2 a, Real2 b) { return a.x * b.x + a.y * b.y; }

struct Real3 {
  Real x, y, z;
  Real3() = default;
  HWY_INLINE Real3(Real first, Real second, Real third) : x(first), y(second), z(third) {}
  HWY_INLINE Real3(const glm::vec3& same) : x(same.x), y(same.y), z(same.z) {}
};
HWY_INLINE Real3 operator+(Real3 a, Real3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
HWY_INLINE Real3 operator+(Real3 a, Real b) { return {a.x + b, a.y + b, a.z + b}; }
HWY_INLINE Real3 operator-(Real3 a, Real3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
HWY_INLINE Real3 operator-(Real3 a) { return {-a.x, -a.y, -a.z}; }
HWY_INLINE Real3 operator*(Real3 a, Real3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
HWY_INLINE Real3 operator*(Real3 a, Real b) { return {a.x * b, a.y * b, a.z * b}; }
HWY_INLINE Real3 operator*(Real a, Real3 b) { return b * a; }
HWY_INLINE Real3 operator/(Real3 a, Real3 b) { return {a.x / b.x, a.y / b.y, a.z / b.z}; }
HWY_INLINE Real3 operator/(Real3 a, Real b) { return a * reciprocal(b); }
HWY_INLINE Real dot(Real3 a, Real3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
HWY_INLINE Real3 mix(Real3 a, Real3 b, Real t) { return a + (b - a) * t; }
HWY_INLINE Real3 mix(Real3 a, Real3 b, Real3 t) { return a + (b - a) * t; }
HWY_INLINE Real3 clamp(Real3 a, Real low, Real high) {
  return {clamp(a.x, low, high), clamp(a.y, low, high), clamp(a.z, low, high)};
}
HWY_INLINE Real3 exp(Real3 a) { return {exp(a.x), exp(a.y), exp(a.z)}; }
HWY_INLINE Real3 choose(Mask m, Real3 a, Real3 b) {
  return {choose(m, a.x, b.x), choose(m, a.y, b.y), choose(m, a.z, b.z)};
}
HWY_INLINE Real inversesqrtOfSquare(Real3 a) { return inversesqrt(max(dot(a, a), 1e-20f)); }

/// Towards zero, of numbers within ±2³¹: without what Highway's conversion does about others, which
/// takes as long again.
HWY_INLINE VI toInt(Real a) {
#if HWY_TARGET == HWY_AVX3
  return VI{_mm512_maskz_cvttps_epi32(0xFFFF, a.v.raw)};  // unmasked, GCC 12 warns of itself
#elif HWY_TARGET == HWY_AVX2
  return VI{_mm256_cvttps_epi32(a.v.raw)};
#else
  return hn::ConvertTo(Ints(), a.v);
#endif
}
HWY_INLINE Real toReal(VI a) { return hn::ConvertTo(Floats(), a); }
HWY_INLINE VI setInt(int value) { return hn::Set(Ints(), value); }
HWY_INLINE VU gather(const std::uint32_t* from, VI at) {
  return hn::GatherIndex(Words(), from, at);
}
HWY_INLINE Real gather(const float* from, VI at) { return hn::GatherIndex(Floats(), from, at); }
HWY_INLINE VU wordsAt(const std::uint32_t* from, VI at) { return gather(from, at); }
HWY_INLINE VU wordsAt(const float* from, VI at) { return hn::BitCast(Words(), gather(from, at).v); }
/// Words and those after them: half as long as two gathers where words are loaded in pairs.
struct Pairs {
  VU first, second;
};
template <class Texel>
HWY_INLINE Pairs gatherPairs(const Texel* from, VI at) {
#if HWY_TARGET == HWY_AVX3
  __m256i halves[4];
  for (int k = 0; k < 4; ++k) {
    const __m128i four = k == 0   ? _mm512_castsi512_si128(at.raw)
                         : k == 1 ? _mm512_extracti32x4_epi32(at.raw, 1)
                         : k == 2 ? _mm512_extracti32x4_epi32(at.raw, 2)
                                  : _mm512_extracti32x4_epi32(at.raw, 3);
    const auto load = [&](long long two) HWY_ATTR {
      const auto pair = [&](long long i) HWY_ATTR {
        return _mm_loadl_epi64(reinterpret_cast<const __m128i*>(from + i));
      };
      return _mm_unpacklo_epi64(pair(static_cast<std::int32_t>(two)), pair(two >> 32));
    };
    halves[k] = _mm256_inserti128_si256(_mm256_castsi128_si256(load(_mm_cvtsi128_si64(four))),
                                        load(_mm_extract_epi64(four, 1)), 1);
  }
  const auto joined = [](__m256i low, __m256i high) HWY_ATTR {
    return VU{_mm512_inserti64x4(_mm512_castsi256_si512(low), high, 1)};
  };
  const VU low = joined(halves[0], halves[1]), high = joined(halves[2], halves[3]);
  return {hn::ConcatEven(Words(), high, low), hn::ConcatOdd(Words(), high, low)};
#else
  return {wordsAt(from, at), wordsAt(from, hn::Add(at, setInt(1)))};
#endif
}
/// An unsigned integer a pixel.
struct Word {
  VU v;
  Word() = default;
  HWY_INLINE Word(VU value) : v(value) {}
};
HWY_INLINE Word operator+(Word a, Word b) { return hn::Add(a.v, b.v); }
HWY_INLINE Word operator*(Word a, Word b) { return hn::Mul(a.v, b.v); }
HWY_INLINE Word operator^(Word a, Word b) { return hn::Xor(a.v, b.v); }
HWY_INLINE Word operator&(Word a, Word b) { return hn::And(a.v, b.v); }
HWY_INLINE Word word(std::uint32_t same) { return hn::Set(Words(), same); }
HWY_INLINE Word shiftedDown(Word a, int bits) { return hn::ShiftRightSame(a.v, bits); }
/// Of whole numbers within ±2²⁴, as two's complement.
HWY_INLINE Word wordOf(Real a) { return hn::BitCast(Words(), toInt(a)); }
/// Below 2³¹.
HWY_INLINE Real realOf(Word a) { return toReal(hn::BitCast(Ints(), a.v)); }
/// (cos 2πt, sin 2πt), within 1e-6.
HWY_INLINE Real2 cosineAndSine(Real turns) {
  const Real t = turns - Real(hn::Round(turns.v)), q = t * t;
  Real s = Real(3.058325f), c = Real(-0.397413859f);
  for (const float term : {-9.53079904f, 16.7609745f, -16.2086703f, 6.2831826f}) s = s * q + term;
  for (const float term : {1.58899844f, -3.65806692f, 5.11148042f, -3.73918126f, 0.999999493f}) {
    c = c * q + term;
  }
  return {(Real(1.0f) - Real(16.0f) * q) * c, t * (Real(1.0f) - Real(4.0f) * q) * s};
}
/// Bits [shift, shift + count) of a word as a number.
template <int kShift, int kCount>
HWY_INLINE Real bitField(VU word) {
  VU bits = hn::ShiftRight<kShift>(word);
  if constexpr (kShift + kCount < 32) bits = hn::And(bits, hn::Set(Words(), (1u << kCount) - 1u));
  return toReal(hn::BitCast(Ints(), bits));
}

}  // namespace HWY_NAMESPACE
}  // namespace seaway::render
HWY_AFTER_NAMESPACE();

#endif
