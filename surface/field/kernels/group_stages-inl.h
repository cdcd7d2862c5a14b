// Group octaves in stages, once per instruction set: place, corners, weights, contribution.

#if defined(SEAWAY_FIELD_GROUP_STAGES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SEAWAY_FIELD_GROUP_STAGES_INL_H_
#undef SEAWAY_FIELD_GROUP_STAGES_INL_H_
#else
#define SEAWAY_FIELD_GROUP_STAGES_INL_H_
#endif

#include "surface/field/kernels/contributions-inl.h"

HWY_BEFORE_NAMESPACE();
namespace seaway {
namespace HWY_NAMESPACE {

/// Where a point lies in an octave: fractions of lattice cells and turns, and the cell's seeded,
/// premultiplied corner.
struct GroupPlace {
  VF along, across, turns;
  VU x, y;
};

template <class Read>
HWY_INLINE GroupPlace PlaceOf(const GroupBlock& block, Read read, DoublePair x, DoublePair y) {
  const Words w;
  const Reduced along = ReduceAt(block.along, read, x, y);
  const Reduced across = ReduceAt(block.across, read, x, y);
  return {along.rest, across.rest, ReduceAt(block.turns, read, x, y).rest,
          hn::Add(hn::Mul(along.cell, hn::Set(w, latticeStrideX)), read(block.seedX)),
          hn::Add(hn::Mul(across.cell, hn::Set(w, latticeStrideY)), read(block.seedY))};
}

/// Envelope values of a cell's corners, packed: first along (before, after), then across.
struct GroupCorners {
  VU word[2][2];
};

HWY_INLINE GroupCorners CornersOf(VU x, VU y) {
  const Words w;
  const VU xAfter = hn::Add(x, hn::Set(w, latticeStrideX));
  const VU yAfter = hn::Add(y, hn::Set(w, latticeStrideY));
  return {{{PackedCorner(Mix(x, y)), PackedCorner(Mix(x, yAfter))},
           {PackedCorner(Mix(xAfter, y)), PackedCorner(Mix(xAfter, yAfter))}}};
}

struct GroupWeights {
  SinCos carrier;
  Blend along, across;
};

HWY_INLINE GroupWeights WeightsOf(VF along, VF across, VF turns) {
  return {SinCosTurns(turns), BlendAt(along), BlendAt(across)};
}

/// One column of corners, carried: value, derivative across, and derivative by phase.
struct Column {
  VF value, across, byPhase;
};

HWY_INLINE Column CarriedColumn(const VU (&corners)[2], const GroupWeights& weights) {
  const SinCos& carrier = weights.carrier;
  const Blend& across = weights.across;
  const Corner c0 = Unpacked(corners[0]);
  const VF value0 = hn::MulAdd(c0.b, carrier.sine, hn::Mul(c0.a, carrier.cosine));
  const VF phase0 = hn::NegMulAdd(c0.a, carrier.sine, hn::Mul(c0.b, carrier.cosine));
  const Corner c1 = Unpacked(corners[1]);
  const VF value1 = hn::MulAdd(c1.b, carrier.sine, hn::Mul(c1.a, carrier.cosine));
  const VF phase1 = hn::NegMulAdd(c1.a, carrier.sine, hn::Mul(c1.b, carrier.cosine));
  return {hn::MulAdd(across.after, value1, hn::Mul(across.before, value0)),
          hn::NegMulAdd(across.after, value0, hn::Mul(across.before, value1)),
          hn::MulAdd(across.after, phase1, hn::Mul(across.before, phase0))};
}

HWY_INLINE Shape GroupShape(const GroupCorners& corners, const GroupWeights& weights) {
  const Column before = CarriedColumn(corners.word[0], weights);
  const Column after = CarriedColumn(corners.word[1], weights);
  const Blend& blend = weights.along;
  return {hn::MulAdd(blend.after, after.value, hn::Mul(blend.before, before.value)),
          hn::MulAdd(blend.after, after.byPhase, hn::Mul(blend.before, before.byPhase)),
          hn::Mul(hn::NegMulAdd(blend.after, before.value, hn::Mul(blend.before, after.value)),
                  blend.rate),
          hn::Mul(hn::MulAdd(blend.after, after.across, hn::Mul(blend.before, before.across)),
                  weights.across.rate)};
}

/// Octaves in lanes: all stages at once.
template <class Read>
HWY_INLINE Shape GroupShapeAtOnce(const GroupBlock& block, Read read, DoublePair x, DoublePair y) {
  const GroupPlace place = PlaceOf(block, read, x, y);
  return GroupShape(CornersOf(place.x, place.y), WeightsOf(place.along, place.across, place.turns));
}

/// Points in lanes: each stage for all octaves of the block before the next. One octave is a chain
/// of some two hundred dependent instructions; stage by stage, octaves overlap in the processor's
/// window (5 to 30 % faster than one octave after the other).
template <bool kDerivatives>
class GroupStaged {
 public:
  explicit HWY_INLINE GroupStaged(const GroupBlock& block) : block_(block) {}

  HWY_INLINE void Prepare(std::uint32_t octaves, DoublePair x, DoublePair y) {
    const Floats f;
    const Words w;
    for (std::uint32_t left = octaves; left != 0; left &= left - 1) {
      const std::size_t i = hwy::Num0BitsBelowLS1Bit_Nonzero32(left);
      const GroupPlace place = PlaceOf(block_, ReadBroadcast{i}, x, y);
      hn::Store(place.along, f, along_[i]);
      hn::Store(place.across, f, across_[i]);
      hn::Store(place.turns, f, turns_[i]);
      hn::Store(place.x, w, x_[i]);
      hn::Store(place.y, w, y_[i]);
    }
    for (std::uint32_t left = octaves; left != 0; left &= left - 1) {
      const std::size_t i = hwy::Num0BitsBelowLS1Bit_Nonzero32(left);
      const GroupCorners corners = CornersOf(hn::Load(w, x_[i]), hn::Load(w, y_[i]));
      for (int c = 0; c < 4; ++c) hn::Store(corners.word[c >> 1][c & 1], w, corner_[i][c]);
    }
    for (std::uint32_t left = octaves; left != 0; left &= left - 1) {
      const std::size_t i = hwy::Num0BitsBelowLS1Bit_Nonzero32(left);
      StoreWeights(
          i, WeightsOf(hn::Load(f, along_[i]), hn::Load(f, across_[i]), hn::Load(f, turns_[i])));
    }
  }

  HWY_INLINE Shape operator()(std::size_t i) const {
    const Floats f;
    const Words w;
    const auto corner = [&](int c) HWY_ATTR { return hn::Load(w, corner_[i][c]); };
    const auto weight = [&](int c) HWY_ATTR { return hn::Load(f, weight_[i][c]); };
    const auto rate = [&](int c) HWY_ATTR { return kDerivatives ? weight(c) : hn::Zero(f); };
    const GroupCorners corners{{{corner(0), corner(1)}, {corner(2), corner(3)}}};
    return GroupShape(
        corners,
        {{weight(0), weight(1)}, {weight(2), weight(3), rate(6)}, {weight(4), weight(5), rate(7)}});
  }

 private:
  HWY_INLINE void StoreWeights(std::size_t i, const GroupWeights& weights) {
    const Floats f;
    hn::Store(weights.carrier.sine, f, weight_[i][0]);
    hn::Store(weights.carrier.cosine, f, weight_[i][1]);
    hn::Store(weights.along.before, f, weight_[i][2]);
    hn::Store(weights.along.after, f, weight_[i][3]);
    hn::Store(weights.across.before, f, weight_[i][4]);
    hn::Store(weights.across.after, f, weight_[i][5]);
    if constexpr (kDerivatives) {
      hn::Store(weights.along.rate, f, weight_[i][6]);
      hn::Store(weights.across.rate, f, weight_[i][7]);
    }
  }

  static constexpr std::size_t mostLanes = 16;
  const GroupBlock& block_;
  alignas(64) float along_[octavesPerBlock][mostLanes];
  alignas(64) float across_[octavesPerBlock][mostLanes];
  alignas(64) float turns_[octavesPerBlock][mostLanes];
  alignas(64) std::uint32_t x_[octavesPerBlock][mostLanes];
  alignas(64) std::uint32_t y_[octavesPerBlock][mostLanes];
  alignas(64) std::uint32_t corner_[octavesPerBlock][4][mostLanes];
  alignas(64) float weight_[octavesPerBlock][8][mostLanes];
};

}  // namespace HWY_NAMESPACE
}  // namespace seaway
HWY_AFTER_NAMESPACE();

#endif  // per-target include
