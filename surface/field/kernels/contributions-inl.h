// What one octave of each kind adds to the sums, once per instruction set. The same code serves
// points in lanes and octaves in lanes: `Read` says where a constant comes from, so both give the
// same bits.

#if defined(SEAWAY_FIELD_CONTRIBUTIONS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SEAWAY_FIELD_CONTRIBUTIONS_INL_H_
#undef SEAWAY_FIELD_CONTRIBUTIONS_INL_H_
#else
#define SEAWAY_FIELD_CONTRIBUTIONS_INL_H_
#endif

#include "surface/field/kernels/field_blocks.h"
#include "surface/field/kernels/kernel_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace seaway {
namespace HWY_NAMESPACE {

/// Points in lanes: one octave's constants in every lane.
struct ReadBroadcast {
  std::size_t octave;
  HWY_INLINE VF operator()(const float* values) const { return hn::Set(Floats(), values[octave]); }
  HWY_INLINE VU operator()(const std::uint32_t* values) const {
    return hn::Set(Words(), values[octave]);
  }
  HWY_INLINE DoublePair operator()(const double* values) const { return SetPair(values[octave]); }
};

/// Octaves in lanes.
struct ReadLanes {
  std::size_t first;
  HWY_INLINE VF operator()(const float* values) const { return hn::Load(Floats(), values + first); }
  HWY_INLINE VU operator()(const std::uint32_t* values) const {
    return hn::Load(Words(), values + first);
  }
  HWY_INLINE DoublePair operator()(const double* values) const { return LoadPair(values + first); }
};

struct Contribution {
  VF height, slopeX, slopeY, rate, orbitalX, orbitalY;
};

template <bool kOrbital>
HWY_INLINE Contribution Plus(const Contribution& a, const Contribution& b) {
  Contribution sum = a;
  sum.height = hn::Add(a.height, b.height);
  sum.slopeX = hn::Add(a.slopeX, b.slopeX);
  sum.slopeY = hn::Add(a.slopeY, b.slopeY);
  sum.rate = hn::Add(a.rate, b.rate);
  if constexpr (kOrbital) {
    sum.orbitalX = hn::Add(a.orbitalX, b.orbitalX);
    sum.orbitalY = hn::Add(a.orbitalY, b.orbitalY);
  }
  return sum;
}

HWY_INLINE Contribution Nothing() {
  const VF zero = hn::Zero(Floats());
  return {zero, zero, zero, zero, zero, zero};
}

template <class Read>
HWY_INLINE Reduced ReduceAt(const Coordinates& coordinates, Read read, DoublePair x, DoublePair y) {
  return Reduce(Linear(read(coordinates.x), x, read(coordinates.y), y, read(coordinates.offset)));
}

/// Three derivatives weighted by their factors.
template <class Read>
HWY_INLINE VF Weighted(const float (&factors)[3][octavesPerBlock], Read read, VF first, VF second,
                       VF third) {
  return hn::MulAdd(first, read(factors[0]),
                    hn::MulAdd(second, read(factors[1]), hn::Mul(third, read(factors[2]))));
}

template <bool kOrbital, class Block, class Read>
HWY_INLINE void AddOrbital(const Block& block, Read read, VF value, Contribution& result) {
  if constexpr (kOrbital) {
    result.orbitalX = hn::Mul(value, read(block.orbitalX));
    result.orbitalY = hn::Mul(value, read(block.orbitalY));
  } else {
    result.orbitalX = result.orbitalY = hn::Zero(Floats());
  }
}

/// One column of corners, carried: value, derivative across, and derivative by phase.
struct Column {
  VF value, across, byPhase;
};

HWY_INLINE Column CarriedColumn(VU x, VU yBefore, VU yAfter, const Blend& across,
                                const SinCos& carrier) {
  const Corner c0 = GroupCorner(Mix(x, yBefore));
  const VF value0 = hn::MulAdd(c0.b, carrier.sine, hn::Mul(c0.a, carrier.cosine));
  const VF phase0 = hn::NegMulAdd(c0.a, carrier.sine, hn::Mul(c0.b, carrier.cosine));
  const Corner c1 = GroupCorner(Mix(x, yAfter));
  const VF value1 = hn::MulAdd(c1.b, carrier.sine, hn::Mul(c1.a, carrier.cosine));
  const VF phase1 = hn::NegMulAdd(c1.a, carrier.sine, hn::Mul(c1.b, carrier.cosine));
  return {hn::MulAdd(across.after, value1, hn::Mul(across.before, value0)),
          hn::NegMulAdd(across.after, value0, hn::Mul(across.before, value1)),
          hn::MulAdd(across.after, phase1, hn::Mul(across.before, phase0))};
}

template <bool kOrbital, class Read>
HWY_INLINE Contribution GroupContribution(const GroupBlock& block, Read read, DoublePair x,
                                          DoublePair y) {
  const Words w;
  const Reduced along = ReduceAt(block.along, read, x, y);
  const Reduced across = ReduceAt(block.across, read, x, y);
  const SinCos carrier = SinCosTurns(ReduceAt(block.turns, read, x, y).rest);
  const Blend blendAcross = BlendAt(across.rest);
  const VU yBefore = hn::Add(hn::Mul(across.cell, hn::Set(w, latticeStrideY)), read(block.seedY));
  const VU yAfter = hn::Add(yBefore, hn::Set(w, latticeStrideY));
  const VU xBefore = hn::Add(hn::Mul(along.cell, hn::Set(w, latticeStrideX)), read(block.seedX));
  const VU xAfter = hn::Add(xBefore, hn::Set(w, latticeStrideX));
  const Column before = CarriedColumn(xBefore, yBefore, yAfter, blendAcross, carrier);
  const Column after = CarriedColumn(xAfter, yBefore, yAfter, blendAcross, carrier);
  const Blend blend = BlendAt(along.rest);
  const VF value = hn::MulAdd(blend.after, after.value, hn::Mul(blend.before, before.value));
  const VF byPhase = hn::MulAdd(blend.after, after.byPhase, hn::Mul(blend.before, before.byPhase));
  const VF byAlong = hn::Mul(
      hn::NegMulAdd(blend.after, before.value, hn::Mul(blend.before, after.value)), blend.rate);
  const VF byAcross = hn::Mul(
      hn::MulAdd(blend.after, after.across, hn::Mul(blend.before, before.across)), blendAcross.rate);
  Contribution result;
  result.height = hn::Mul(value, read(block.factors.height));
  result.slopeX = Weighted(block.factors.slopeX, read, byPhase, byAlong, byAcross);
  result.slopeY = Weighted(block.factors.slopeY, read, byPhase, byAlong, byAcross);
  result.rate = Weighted(block.factors.rate, read, byPhase, byAlong, byAcross);
  AddOrbital<kOrbital>(block, read, value, result);
  return result;
}

template <bool kOrbital, class Read>
HWY_INLINE Contribution RegularContribution(const RegularBlock& block, Read read, DoublePair x,
                                            DoublePair y) {
  const Floats f;
  const SinCos carrier = SinCosTurns(ReduceAt(block.turns, read, x, y).rest);
  const VF byPhase = hn::Sub(hn::Zero(f), carrier.sine);
  Contribution result;
  result.height = hn::Mul(carrier.cosine, read(block.factors.height));
  result.slopeX = hn::Mul(byPhase, read(block.factors.slopeX[0]));
  result.slopeY = hn::Mul(byPhase, read(block.factors.slopeY[0]));
  result.rate = hn::Mul(byPhase, read(block.factors.rate[0]));
  AddOrbital<kOrbital>(block, read, carrier.cosine, result);
  return result;
}

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
HWY_INLINE Contribution PerlinContribution(const PerlinBlock& block, Read read, DoublePair x,
                                           DoublePair y) {
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
  const BlendedRow lower = RowOf(
      GradientAt(block, read, Mix(left[0], lowest[0]), Mix(left[1], lowest[1])),
      GradientAt(block, read, Mix(right[0], lowest[0]), Mix(right[1], lowest[1])), dx0, dx1, dy0,
      fadeX);
  const BlendedRow upper = RowOf(
      GradientAt(block, read, Mix(left[0], highest[0]), Mix(left[1], highest[1])),
      GradientAt(block, read, Mix(right[0], highest[0]), Mix(right[1], highest[1])), dx0, dx1, dy1,
      fadeX);
  const Fade fadeY = FadeAt(second.rest);
  const VF value = Mixed(lower.ramp, upper.ramp, fadeY.weight);
  const VF byFirst = Mixed(lower.rampSlope, upper.rampSlope, fadeY.weight);
  const VF bySecond = hn::MulAdd(hn::Sub(upper.ramp, lower.ramp), fadeY.slope,
                                 Mixed(lower.gradientY, upper.gradientY, fadeY.weight));
  const VF byTime = Mixed(lower.rate, upper.rate, fadeY.weight);
  Contribution result;
  result.height = hn::Mul(value, read(block.factors.height));
  result.slopeX = hn::MulAdd(byFirst, read(block.factors.slopeX[1]),
                             hn::Mul(bySecond, read(block.factors.slopeX[2])));
  result.slopeY = hn::MulAdd(byFirst, read(block.factors.slopeY[1]),
                             hn::Mul(bySecond, read(block.factors.slopeY[2])));
  result.rate = Weighted(block.factors.rate, read, byTime, byFirst, bySecond);
  result.orbitalX = result.orbitalY = hn::Zero(f);
  return result;
}

}  // namespace HWY_NAMESPACE
}  // namespace seaway
HWY_AFTER_NAMESPACE();

#endif  // per-target include
