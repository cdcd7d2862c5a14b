// What one octave adds to the sums, and regular waves as the simplest kind, once per instruction
// set. The same code serves points in lanes and octaves in lanes: `Read` says where a constant
// comes from, so both give the same bits.

#if defined(SEAWAY_FIELD_CONTRIBUTIONS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SEAWAY_FIELD_CONTRIBUTIONS_INL_H_
#undef SEAWAY_FIELD_CONTRIBUTIONS_INL_H_
#else
#define SEAWAY_FIELD_CONTRIBUTIONS_INL_H_
#endif

#include <limits>

#include "hwy/contrib/math/math-inl.h"
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

/// One vector for each of the sums of `Quantities`.
template <std::size_t N>
struct Sums {
  VF of[N];
};

template <std::size_t N>
HWY_INLINE Sums<N> Plus(const Sums<N>& a, const Sums<N>& b) {
  Sums<N> sum;
  for (std::size_t n = 0; n < N; ++n) sum.of[n] = hn::Add(a.of[n], b.of[n]);
  return sum;
}

template <std::size_t N>
HWY_INLINE Sums<N> Nothing() {
  Sums<N> sum;
  for (std::size_t n = 0; n < N; ++n) sum.of[n] = hn::Zero(Floats());
  return sum;
}

/// An octave at a point before its factors: value, and derivatives by phase (Perlin: by time), by
/// the first and by the second lattice coordinate. What a kernel does not use is never computed.
struct Shape {
  VF value, byPhase, byFirst, bySecond;
};

/// Which derivatives a kind's slopes and rates are made of.
struct GroupKind {
  static constexpr bool slopesByPhase = true, lattice = true;
};
struct RegularKind {
  static constexpr bool slopesByPhase = true, lattice = false;
};
struct PerlinKind {
  static constexpr bool slopesByPhase = false, lattice = true;
};

template <class Read>
HWY_INLINE Reduced ReduceAt(const Coordinates& coordinates, Read read, DoublePair x, DoublePair y) {
  return Reduce(Linear(read(coordinates.x), x, read(coordinates.y), y, read(coordinates.offset)));
}

/// Derivatives weighted by their factors.
template <bool kByPhase, bool kLattice, class Read>
HWY_INLINE VF Weighted(const float (&factors)[3][octavesPerBlock], Read read, const Shape& shape) {
  if constexpr (!kLattice) {
    return hn::Mul(shape.byPhase, read(factors[0]));
  } else {
    const VF lattice = hn::Mul(shape.bySecond, read(factors[2]));
    const VF both = hn::MulAdd(shape.byFirst, read(factors[1]), lattice);
    if constexpr (kByPhase) return hn::MulAdd(shape.byPhase, read(factors[0]), both);
    return both;
  }
}

/// Height, slope, rate and orbital velocity at the surface.
template <Quantities kWhat, class Kind, class Block, class Read>
HWY_INLINE Sums<sumsOf(kWhat)> AtSurface(const Block& block, Read read, const Shape& shape) {
  Sums<sumsOf(kWhat)> result;
  const DerivativeFactors& factors = block.factors;
  result.of[0] = hn::Mul(shape.value, read(factors.height));
  if constexpr (kWhat != Quantities::height) {
    result.of[1] = Weighted<Kind::slopesByPhase, Kind::lattice>(factors.slopeX, read, shape);
    result.of[2] = Weighted<Kind::slopesByPhase, Kind::lattice>(factors.slopeY, read, shape);
    result.of[3] = Weighted<true, Kind::lattice>(factors.rate, read, shape);
  }
  if constexpr (kWhat == Quantities::orbital) {
    result.of[4] = hn::Mul(result.of[0], read(block.motion.alongX));
    result.of[5] = hn::Mul(result.of[0], read(block.motion.alongY));
  }
  return result;
}

/// Decay from the surface to stretched height z' of horizontal velocity and pressure, and of
/// vertical velocity: cosh k(z' + d)/cosh kd and sinh k(z' + d)/sinh kd, from exponentials of
/// negative numbers.
struct Decay {
  VF horizontal, vertical;
};

template <class Read>
HWY_INLINE Decay DecayAt(const MotionFactors& motion, Read read, VF stretched, float depth) {
  const Floats f;
  const VF k = read(motion.waveNumber);
  const VF down = hn::Exp(f, hn::Mul(k, stretched));
  if (depth == std::numeric_limits<float>::infinity()) return {down, down};
  const VF aboveBed = hn::Max(hn::Add(stretched, hn::Set(f, depth)), hn::Zero(f));
  const VF bed = hn::Exp(f, hn::Mul(hn::Mul(k, aboveBed), hn::Set(f, -2.0f)));
  return {hn::Mul(hn::MulAdd(down, bed, down), read(motion.horizontal)),
          hn::Mul(hn::NegMulAdd(down, bed, down), read(motion.vertical))};
}

/// Pressure head and motion at a stretched height.
template <Quantities kWhat, class Kind, class Block, class Read>
HWY_INLINE Sums<sumsOf(kWhat)> BelowSurface(const Block& block, Read read, const Shape& shape,
                                            VF stretched, float depth) {
  const MotionFactors& motion = block.motion;
  const Decay decay = DecayAt(motion, read, stretched, depth);
  const VF height = hn::Mul(shape.value, read(block.factors.height));
  const VF head = hn::Mul(height, decay.horizontal);
  Sums<sumsOf(kWhat)> result;
  if constexpr (kWhat == Quantities::motion) {
    const VF rate = Weighted<true, Kind::lattice>(motion.materialRate, read, shape);
    const VF rateBelow = hn::Mul(rate, decay.horizontal);
    const VF x = read(motion.alongX), y = read(motion.alongY);
    result.of[0] = hn::Mul(head, x);
    result.of[1] = hn::Mul(head, y);
    result.of[2] = hn::Mul(rate, decay.vertical);
    result.of[3] = hn::Mul(rateBelow, x);
    result.of[4] = hn::Mul(rateBelow, y);
    const VF lift = hn::Mul(height, read(motion.squaredFrequency));
    result.of[5] = hn::Neg(hn::Mul(lift, decay.vertical));
    result.of[6] = head;
  } else {
    result.of[0] = head;
  }
  return result;
}

constexpr bool isBelowSurface(Quantities what) {
  return what == Quantities::pressure || what == Quantities::motion;
}

template <Quantities kWhat, class Kind, class Block, class Read>
HWY_INLINE Sums<sumsOf(kWhat)> Contribution(const Block& block, Read read, const Shape& shape,
                                            VF stretched, float depth) {
  if constexpr (isBelowSurface(kWhat)) {
    return BelowSurface<kWhat, Kind>(block, read, shape, stretched, depth);
  } else {
    return AtSurface<kWhat, Kind>(block, read, shape);
  }
}

template <class Read>
HWY_INLINE Shape RegularShape(const RegularBlock& block, Read read, DoublePair x, DoublePair y) {
  const Floats f;
  const SinCos carrier = SinCosTurns(ReduceAt(block.turns, read, x, y).rest);
  return {carrier.cosine, hn::Sub(hn::Zero(f), carrier.sine), hn::Zero(f), hn::Zero(f)};
}

}  // namespace HWY_NAMESPACE
}  // namespace seaway
HWY_AFTER_NAMESPACE();

#endif  // per-target include
