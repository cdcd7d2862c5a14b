// What a Perlin octave adds to the sums, once per instruction set.

#if defined(SEAWAY_FIELD_PERLIN_CONTRIBUTION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SEAWAY_FIELD_PERLIN_CONTRIBUTION_INL_H_
#undef SEAWAY_FIELD_PERLIN_CONTRIBUTION_INL_H_
#else
#define SEAWAY_FIELD_PERLIN_CONTRIBUTION_INL_H_
#endif

#include "surface/field/kernels/contributions-inl.h"

HWY_BEFORE_NAMESPACE();
namespace seaway {
namespace HWY_NAMESPACE {

/// Quintic fade and its slope at `rest` ∈ [−½, ½] from the middle of a cell.
struct Fade {
  VF weight, slope;
};

HWY_INLINE Fade FadeAt(VF rest) {
  const Floats f;
  // ½ + (15 s − 10 s³ + 3 s⁵)/16 with s = 2·rest; slope (15/8)(1 − s²)².
  constexpr float odd[] = {30.0f / 16.0f, -80.0f / 16.0f, 96.0f / 16.0f};
  const VF squared = hn::Mul(rest, rest);
  const VF edge = hn::NegMulAdd(squared, hn::Set(f, 4.0f), hn::Set(f, 1.0f));
  return {hn::MulAdd(rest, Polynomial(odd, squared), hn::Set(f, 0.5f)),
          hn::Mul(hn::Mul(edge, edge), hn::Set(f, 1.875f))};
}

/// A gradient, and its rate of change in time.
struct Gradient {
  VF x, y, xRate, yRate;
};

HWY_INLINE VF CentredByte(VU hash) {
  const Floats f;
  const VU byte = hn::And(hash, hn::Set(Words(), 0xFFu));
  return hn::Sub(hn::ConvertTo(f, hn::BitCast(Ints(), byte)), hn::Set(f, 127.5f));
}

template <class Read>
HWY_INLINE Gradient GradientAt(const PerlinBlock& block, Read read, VU before, VU after) {
  const VF x0 = CentredByte(before), y0 = CentredByte(hn::ShiftRight<8>(before));
  const VF x1 = CentredByte(after), y1 = CentredByte(hn::ShiftRight<8>(after));
  const VF w0 = read(block.weight[0]), w1 = read(block.weight[1]);
  const VF r0 = read(block.weightRate[0]), r1 = read(block.weightRate[1]);
  return {hn::MulAdd(x0, w0, hn::Mul(x1, w1)), hn::MulAdd(y0, w0, hn::Mul(y1, w1)),
          hn::MulAdd(x0, r0, hn::Mul(x1, r1)), hn::MulAdd(y0, r0, hn::Mul(y1, r1))};
}

/// Two corners blended along the first axis: the ramp, its derivative there, the gradient's second
/// component and the ramp's rate.
struct BlendedRow {
  VF ramp, rampSlope, gradientY, rate;
};

HWY_INLINE VF Mixed(VF a, VF b, VF weight) { return hn::MulAdd(hn::Sub(b, a), weight, a); }

HWY_INLINE BlendedRow RowOf(const Gradient& before, const Gradient& after, VF toBefore, VF toAfter,
                            VF dy, const Fade& fade) {
  const VF ramp0 = hn::MulAdd(before.x, toBefore, hn::Mul(before.y, dy));
  const VF ramp1 = hn::MulAdd(after.x, toAfter, hn::Mul(after.y, dy));
  const VF rate0 = hn::MulAdd(before.xRate, toBefore, hn::Mul(before.yRate, dy));
  const VF rate1 = hn::MulAdd(after.xRate, toAfter, hn::Mul(after.yRate, dy));
  return {Mixed(ramp0, ramp1, fade.weight),
          hn::MulAdd(hn::Sub(ramp1, ramp0), fade.slope, Mixed(before.x, after.x, fade.weight)),
          Mixed(before.y, after.y, fade.weight), Mixed(rate0, rate1, fade.weight)};
}

template <class Read>
HWY_INLINE Shape PerlinShape(const PerlinBlock& block, Read read, DoublePair x, DoublePair y) {
  const Floats f;
  const Words w;
  const Reduced first = ReduceAt(block.first, read, x, y);
  const Reduced second = ReduceAt(block.second, read, x, y);
  const VU column = hn::Mul(first.cell, hn::Set(w, latticeStrideX));
  const VU row = hn::Mul(second.cell, hn::Set(w, latticeStrideY));
  const VU left[2] = {hn::Add(column, read(block.seedX[0])), hn::Add(column, read(block.seedX[1]))};
  const VU lowest[2] = {hn::Add(row, read(block.seedY[0])), hn::Add(row, read(block.seedY[1]))};
  const VU stepX = hn::Set(w, latticeStrideX), stepY = hn::Set(w, latticeStrideY);
  const VU right[2] = {hn::Add(left[0], stepX), hn::Add(left[1], stepX)};
  const VU highest[2] = {hn::Add(lowest[0], stepY), hn::Add(lowest[1], stepY)};
  const VF half = hn::Set(f, 0.5f);
  const VF dx0 = hn::Add(first.rest, half), dx1 = hn::Sub(first.rest, half);
  const VF dy0 = hn::Add(second.rest, half), dy1 = hn::Sub(second.rest, half);
  const Fade fadeX = FadeAt(first.rest);
  const BlendedRow lower =
      RowOf(GradientAt(block, read, Mix(left[0], lowest[0]), Mix(left[1], lowest[1])),
            GradientAt(block, read, Mix(right[0], lowest[0]), Mix(right[1], lowest[1])), dx0, dx1,
            dy0, fadeX);
  const BlendedRow upper =
      RowOf(GradientAt(block, read, Mix(left[0], highest[0]), Mix(left[1], highest[1])),
            GradientAt(block, read, Mix(right[0], highest[0]), Mix(right[1], highest[1])), dx0, dx1,
            dy1, fadeX);
  const Fade fadeY = FadeAt(second.rest);
  return {Mixed(lower.ramp, upper.ramp, fadeY.weight), Mixed(lower.rate, upper.rate, fadeY.weight),
          Mixed(lower.rampSlope, upper.rampSlope, fadeY.weight),
          hn::MulAdd(hn::Sub(upper.ramp, lower.ramp), fadeY.slope,
                     Mixed(lower.gradientY, upper.gradientY, fadeY.weight))};
}

}  // namespace HWY_NAMESPACE
}  // namespace seaway
HWY_AFTER_NAMESPACE();

#endif  // per-target include
