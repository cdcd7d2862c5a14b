// What one octave adds to the sums, and regular waves as the simplest kind, once per instruction
// set. The same code serves points in lanes and octaves in lanes: `Read` says where a constant comes
// from, so both give the same bits.

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

}  // namespace HWY_NAMESPACE
}  // namespace seaway
HWY_AFTER_NAMESPACE();

#endif  // per-target include
