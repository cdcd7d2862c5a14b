// Arithmetic that the field's kernels share, once per instruction set (Highway's per-target
// include).

#if defined(SEAWAY_FIELD_KERNEL_MATH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SEAWAY_FIELD_KERNEL_MATH_INL_H_
#undef SEAWAY_FIELD_KERNEL_MATH_INL_H_
#else
#define SEAWAY_FIELD_KERNEL_MATH_INL_H_
#endif

#include <cstdint>

#include "hwy/highway.h"
#include "surface/field/lattice_hash.h"

HWY_BEFORE_NAMESPACE();
namespace seaway {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Ints = hn::RebindToSigned<Floats>;
using Words = hn::RebindToUnsigned<Floats>;
using Doubles = hn::ScalableTag<double>;
using VF = hn::Vec<Floats>;
using VU = hn::Vec<Words>;
using VD = hn::Vec<Doubles>;

/// As many doubles as there are float lanes.
struct DoublePair {
  VD low, high;
};

HWY_INLINE DoublePair LoadPair(const double* from) {
  const Doubles d;
  return {hn::Load(d, from), hn::Load(d, from + hn::Lanes(d))};
}

HWY_INLINE DoublePair SetPair(double value) {
  const Doubles d;
  return {hn::Set(d, value), hn::Set(d, value)};
}

/// a x + b y + c, fused.
HWY_INLINE DoublePair Linear(DoublePair a, DoublePair x, DoublePair b, DoublePair y, DoublePair c) {
  return {hn::MulAdd(x.low, a.low, hn::MulAdd(y.low, b.low, c.low)),
          hn::MulAdd(x.high, a.high, hn::MulAdd(y.high, b.high, c.high))};
}

/// A coordinate's nearest integer, modulo 2³², and what is left of it, [−½, ½].
struct Reduced {
  VU cell;
  VF rest;
};

/// Adding 1.5·2⁵² leaves the nearest integer in the low bits of the mantissa: exact up to 2⁵¹.
HWY_INLINE Reduced Reduce(DoublePair value) {
  const Doubles d;
  const Floats f;
  const Words w;
  const hn::Half<Floats> half;
  const VD magic = hn::Set(d, 6755399441055744.0);
  const VD low = hn::Add(value.low, magic), high = hn::Add(value.high, magic);
  const VD restLow = hn::Sub(value.low, hn::Sub(low, magic));
  const VD restHigh = hn::Sub(value.high, hn::Sub(high, magic));
  return {hn::ConcatEven(w, hn::BitCast(w, high), hn::BitCast(w, low)),
          hn::Combine(f, hn::DemoteTo(half, restHigh), hn::DemoteTo(half, restLow))};
}

/// `cornerHash` on premultiplied, seeded coordinates.
HWY_INLINE VU Mix(VU x, VU y) {
  const Words w;
  VU h = hn::Mul(hn::Xor(x, y), hn::Set(w, latticeFirstFactor));
  h = hn::Xor(h, hn::ShiftRight<15>(h));
  h = hn::Mul(h, hn::Set(w, latticeSecondFactor));
  return hn::Xor(h, hn::ShiftRight<16>(h));
}

/// Differences of neighbouring bytes (each at most 30), even minus odd, in 16-bit lanes.
HWY_INLINE VU PairDifferences(VU bytes) {
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_AVX3_DL
  return VU{_mm512_maddubs_epi16(bytes.raw, _mm512_set1_epi16(static_cast<short>(0xFF01)))};
#elif HWY_TARGET == HWY_AVX2
  return VU{_mm256_maddubs_epi16(bytes.raw, _mm256_set1_epi16(static_cast<short>(0xFF01)))};
#else
  const Words w;
  const hn::Repartition<std::uint16_t, Words> halves;
  const auto both = hn::BitCast(halves, bytes);
  const auto even = hn::And(both, hn::Set(halves, std::uint16_t{0xFF}));
  return hn::BitCast(w, hn::Sub(even, hn::ShiftRight<8>(both)));
#endif
}

/// The two envelope values of a corner, packed in 16 bits each: see GroupOctave.
HWY_INLINE VU PackedCorner(VU hash) {
  const VU nibbles = hn::Set(Words(), 0x0F0F0F0Fu);
  return PairDifferences(
      hn::Add(hn::And(hash, nibbles), hn::And(hn::ShiftRight<4>(hash), nibbles)));
}

/// The same times 2¹⁶, as floats.
struct Corner {
  VF a, b;
};

HWY_INLINE Corner Unpacked(VU corner) {
  const Words w;
  const Ints i;
  const Floats f;
  return {hn::ConvertTo(f, hn::BitCast(i, hn::ShiftLeft<16>(corner))),
          hn::ConvertTo(f, hn::BitCast(i, hn::And(corner, hn::Set(w, 0xFFFF0000u))))};
}

/// c[0] + c[1] x + …, Horner.
template <int N>
HWY_INLINE VF Polynomial(const float (&c)[N], VF x) {
  const Floats f;
  VF sum = hn::Set(f, c[N - 1]);
  for (int n = N - 2; n >= 0; --n) sum = hn::MulAdd(sum, x, hn::Set(f, c[n]));
  return sum;
}

/// Weights of a cell's two corners at `rest` ∈ [−½, ½] from its middle, cos θ and sin θ with
/// θ = ½π·fade, and θ's rate over its largest, (15/16)π per cell.
struct Blend {
  VF before, after, rate;
};

HWY_INLINE Blend BlendAt(VF rest) {
  const Floats f;
  // θ − π/4 = π/4 (15 s − 10 s³ + 3 s⁵)/8 with s = 2·rest.
  constexpr float quarter = 0.785398163f / 8.0f;
  constexpr float angle[] = {30.0f * quarter, -80.0f * quarter, 96.0f * quarter};
  // Minimax on |θ| ≤ π/4: sin θ/(√2 θ) to 4e-7 of sin θ, cos θ/√2 to 2e-8.
  constexpr float sine[] = {0.707103244f, -0.117805135f, 0.00574280867f};
  constexpr float cosine[] = {0.707106762f, -0.353552377f, 0.029454552f, -0.000960668804f};
  const VF squared = hn::Mul(rest, rest);
  const VF theta = hn::Mul(rest, Polynomial(angle, squared));
  const VF theta2 = hn::Mul(theta, theta);
  const VF odd = hn::Mul(theta, Polynomial(sine, theta2));
  const VF even = Polynomial(cosine, theta2);
  const VF edge = hn::NegMulAdd(squared, hn::Set(f, 4.0f), hn::Set(f, 1.0f));
  return {hn::Sub(even, odd), hn::Add(even, odd), hn::Mul(edge, edge)};
}

struct SinCos {
  VF sine, cosine;
};

/// sin 2πp and cos 2πp, p ∈ [−½, ½] turns, to 1e-7 and 5e-7: minimax factors beside the exact
/// zeros.
HWY_INLINE SinCos SinCosTurns(VF turns) {
  const Floats f;
  constexpr float sine[] = {6.2831826f, -16.2086703f, 16.7609745f, -9.53079904f, 3.058325f};
  constexpr float cosine[] = {0.999999493f, -3.73918126f, 5.11148042f,
                              -3.65806692f, 1.58899844f,  -0.397413859f};
  const VF q = hn::Mul(turns, turns);
  const VF zeroAtHalf = hn::NegMulAdd(q, hn::Set(f, 4.0f), hn::Set(f, 1.0f));
  const VF zeroAtQuarter = hn::NegMulAdd(q, hn::Set(f, 16.0f), hn::Set(f, 1.0f));
  return {hn::Mul(hn::Mul(turns, zeroAtHalf), Polynomial(sine, q)),
          hn::Mul(zeroAtQuarter, Polynomial(cosine, q))};
}

}  // namespace HWY_NAMESPACE
}  // namespace seaway
HWY_AFTER_NAMESPACE();

#endif  // per-target include
