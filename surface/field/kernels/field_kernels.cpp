#include "surface/field/kernels/field_blocks.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "surface/field/kernels/field_kernels.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"
#include "surface/field/kernels/contributions-inl.h"
#include "surface/field/kernels/group_stages-inl.h"
#include "surface/field/kernels/perlin_contribution-inl.h"

HWY_BEFORE_NAMESPACE();
namespace seaway {
namespace HWY_NAMESPACE {
namespace {

/// Sums of a vector of points.
template <std::size_t N>
HWY_INLINE Sums<N> LoadSums(const FieldSums& sums, std::size_t at) {
  Sums<N> result;
  for (std::size_t n = 0; n < N; ++n) result.of[n] = hn::Load(Floats(), sums.sum[n] + at);
  return result;
}

template <std::size_t N>
HWY_INLINE void StoreSums(const Sums<N>& result, const FieldSums& sums, std::size_t at) {
  for (std::size_t n = 0; n < N; ++n) hn::Store(result.of[n], Floats(), sums.sum[n] + at);
}

/// Octaves are summed in quads, (a + b) + (c + d), quads one after the other: an order that octaves
/// in lanes can follow. `stages.Prepare(octaves, x, y)` readies a vector of points, `stages(i)` is
/// the shape of octave i there.
template <Quantities kWhat, class Kind, class Block, class Stages>
HWY_INLINE void AddBatch(const Block& block, std::uint32_t octaves, const double* HWY_RESTRICT x,
                         const double* HWY_RESTRICT y, std::size_t count, const FieldSums& sums,
                         Stages& stages) {
  constexpr std::size_t n = sumsOf(kWhat);
  const Floats f;
  const std::size_t lanes = hn::Lanes(f);
  for (std::size_t at = 0; at < count; at += lanes) {
    stages.Prepare(octaves, LoadPair(x + at), LoadPair(y + at));
    VF stretched = hn::Zero(f);
    if constexpr (isBelowSurface(kWhat)) stretched = hn::Load(f, sums.stretched + at);
    const auto contribution = [&](std::size_t i) HWY_ATTR {
      return Contribution<kWhat, Kind>(block, ReadBroadcast{i}, stages(i), stretched, sums.depth);
    };
    Sums<n> total = LoadSums<n>(sums, at);
    Sums<n> firstPair = Nothing<n>();
    std::size_t octave = 0;
    for (std::uint32_t left = octaves; left != 0; left >>= 2, octave += 2) {
      const Sums<n> a = (left & 1) != 0 ? contribution(octave) : Nothing<n>();
      const Sums<n> b = (left & 2) != 0 ? contribution(octave + 1) : Nothing<n>();
      const Sums<n> pair = Plus(a, b);
      const bool second = (octave & 2) != 0;
      if (second) total = Plus(total, Plus(firstPair, pair));
      firstPair = second ? Nothing<n>() : pair;
    }
    if (octave & 2) total = Plus(total, Plus(firstPair, Nothing<n>()));
    StoreSums<n>(total, sums, at);
  }
}

/// Points in lanes without stages: each octave in one go.
template <class ShapeOf>
class Unstaged {
 public:
  explicit HWY_INLINE Unstaged(ShapeOf shapeOf) : shapeOf_(shapeOf) {}
  HWY_INLINE void Prepare(std::uint32_t, DoublePair x, DoublePair y) { x_ = x, y_ = y; }
  HWY_INLINE Shape operator()(std::size_t octave) const {
    return shapeOf_(ReadBroadcast{octave}, x_, y_);
  }

 private:
  ShapeOf shapeOf_;
  DoublePair x_, y_;
};

/// (a + b) + (c + d) of each quad of lanes, in all its lanes.
HWY_INLINE VF QuadSums(VF v) {
  const VF pairs = hn::Add(v, hn::Shuffle2301(v));
  return hn::Add(pairs, hn::Shuffle1032(pairs));
}

HWY_INLINE void AddQuads(VF contribution, float& sum) {
  const std::size_t lanes = hn::Lanes(Floats());
  HWY_ALIGN float quads[octavesPerBlock];
  hn::Store(QuadSums(contribution), Floats(), quads);
  for (std::size_t quad = 0; quad < lanes; quad += 4) sum += quads[quad];
}

/// Unused places of a block add zeros, which changes no bit of a sum that began as +0.
template <Quantities kWhat, class Kind, class Block, class ShapeOf>
HWY_INLINE void AddPoint(const Block& block, std::uint32_t octaves, double x, double y,
                         const FieldSums& sums, ShapeOf shapeOf) {
  const Floats f;
  const std::size_t lanes = hn::Lanes(f);
  for (std::size_t first = 0; (octaves >> first) != 0; first += lanes) {
    const ReadLanes read{first};
    const auto all = AtSurface<kWhat, Kind>(block, read, shapeOf(read, SetPair(x), SetPair(y)));
    const std::uint64_t bits = octaves >> first;
    const auto mask = hn::LoadMaskBits(f, reinterpret_cast<const std::uint8_t*>(&bits));
    for (std::size_t n = 0; n < sumsOf(kWhat); ++n) {
      AddQuads(hn::IfThenElseZero(mask, all.of[n]), *sums.sum[n]);
    }
    if (first + lanes >= octavesPerBlock) break;
  }
}

struct GroupShapes {
  const GroupBlock& block;
  template <class Read>
  HWY_INLINE Shape operator()(Read read, DoublePair x, DoublePair y) const {
    return GroupShapeAtOnce(block, read, x, y);
  }
};

struct RegularShapes {
  const RegularBlock& block;
  template <class Read>
  HWY_INLINE Shape operator()(Read read, DoublePair x, DoublePair y) const {
    return RegularShape(block, read, x, y);
  }
};

struct PerlinShapes {
  const PerlinBlock& block;
  template <class Read>
  HWY_INLINE Shape operator()(Read read, DoublePair x, DoublePair y) const {
    return PerlinShape(block, read, x, y);
  }
};

template <Quantities kWhat>
HWY_INLINE void AddGroups(const GroupBlock& block, std::uint32_t octaves, const double* x,
                          const double* y, std::size_t count, const FieldSums& sums) {
  GroupStaged<kWhat != Quantities::height && kWhat != Quantities::pressure> stages(block);
  AddBatch<kWhat, GroupKind>(block, octaves, x, y, count, sums, stages);
}

template <Quantities kWhat>
HWY_INLINE void AddRegulars(const RegularBlock& block, std::uint32_t octaves, const double* x,
                            const double* y, std::size_t count, const FieldSums& sums) {
  Unstaged<RegularShapes> stages({block});
  AddBatch<kWhat, RegularKind>(block, octaves, x, y, count, sums, stages);
}

template <Quantities kWhat>
HWY_INLINE void AddPerlins(const PerlinBlock& block, std::uint32_t octaves, const double* x,
                           const double* y, std::size_t count, const FieldSums& sums) {
  Unstaged<PerlinShapes> stages({block});
  AddBatch<kWhat, PerlinKind>(block, octaves, x, y, count, sums, stages);
}

}  // namespace

void GroupBatch(const GroupBlock& block, std::uint32_t octaves, const double* x, const double* y,
                std::size_t count, const FieldSums& sums) {
  switch (sums.what) {
    case Quantities::height:
      return AddGroups<Quantities::height>(block, octaves, x, y, count, sums);
    case Quantities::surface:
      return AddGroups<Quantities::surface>(block, octaves, x, y, count, sums);
    case Quantities::orbital:
      return AddGroups<Quantities::orbital>(block, octaves, x, y, count, sums);
    case Quantities::pressure:
      return AddGroups<Quantities::pressure>(block, octaves, x, y, count, sums);
    case Quantities::motion:
      return AddGroups<Quantities::motion>(block, octaves, x, y, count, sums);
  }
}

void RegularBatch(const RegularBlock& block, std::uint32_t octaves, const double* x,
                  const double* y, std::size_t count, const FieldSums& sums) {
  switch (sums.what) {
    case Quantities::height:
      return AddRegulars<Quantities::height>(block, octaves, x, y, count, sums);
    case Quantities::surface:
      return AddRegulars<Quantities::surface>(block, octaves, x, y, count, sums);
    case Quantities::orbital:
      return AddRegulars<Quantities::orbital>(block, octaves, x, y, count, sums);
    case Quantities::pressure:
      return AddRegulars<Quantities::pressure>(block, octaves, x, y, count, sums);
    case Quantities::motion:
      return AddRegulars<Quantities::motion>(block, octaves, x, y, count, sums);
  }
}

void PerlinBatch(const PerlinBlock& block, std::uint32_t octaves, const double* x, const double* y,
                 std::size_t count, const FieldSums& sums) {
  if (sums.what == Quantities::height) {
    return AddPerlins<Quantities::height>(block, octaves, x, y, count, sums);
  }
  // Without kinematics the orbital sums stay as they are.
  AddPerlins<Quantities::surface>(block, octaves, x, y, count, sums);
}

void GroupPoint(const GroupBlock& block, std::uint32_t octaves, double x, double y,
                const FieldSums& sums) {
  const GroupShapes shapes{block};
  if (sums.what == Quantities::orbital) {
    AddPoint<Quantities::orbital, GroupKind>(block, octaves, x, y, sums, shapes);
  } else if (sums.what == Quantities::surface) {
    AddPoint<Quantities::surface, GroupKind>(block, octaves, x, y, sums, shapes);
  } else {
    AddPoint<Quantities::height, GroupKind>(block, octaves, x, y, sums, shapes);
  }
}

void RegularPoint(const RegularBlock& block, std::uint32_t octaves, double x, double y,
                  const FieldSums& sums) {
  const RegularShapes shapes{block};
  if (sums.what == Quantities::orbital) {
    AddPoint<Quantities::orbital, RegularKind>(block, octaves, x, y, sums, shapes);
  } else if (sums.what == Quantities::surface) {
    AddPoint<Quantities::surface, RegularKind>(block, octaves, x, y, sums, shapes);
  } else {
    AddPoint<Quantities::height, RegularKind>(block, octaves, x, y, sums, shapes);
  }
}

void PerlinPoint(const PerlinBlock& block, std::uint32_t octaves, double x, double y,
                 const FieldSums& sums) {
  const PerlinShapes shapes{block};
  if (sums.what == Quantities::height) {
    AddPoint<Quantities::height, PerlinKind>(block, octaves, x, y, sums, shapes);
  } else {
    AddPoint<Quantities::surface, PerlinKind>(block, octaves, x, y, sums, shapes);
  }
}

const char* TargetName() { return hwy::TargetName(HWY_TARGET); }

}  // namespace HWY_NAMESPACE
}  // namespace seaway
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include <cstring>

namespace seaway {

HWY_EXPORT(GroupBatch);
HWY_EXPORT(RegularBatch);
HWY_EXPORT(PerlinBatch);
HWY_EXPORT(GroupPoint);
HWY_EXPORT(RegularPoint);
HWY_EXPORT(PerlinPoint);
HWY_EXPORT(TargetName);

void addGroupBatch(const GroupBlock& block, std::uint32_t octaves, const double* x, const double* y,
                   std::size_t count, const FieldSums& sums) {
  HWY_DYNAMIC_DISPATCH(GroupBatch)(block, octaves, x, y, count, sums);
}
void addRegularBatch(const RegularBlock& block, std::uint32_t octaves, const double* x,
                     const double* y, std::size_t count, const FieldSums& sums) {
  HWY_DYNAMIC_DISPATCH(RegularBatch)(block, octaves, x, y, count, sums);
}
void addPerlinBatch(const PerlinBlock& block, std::uint32_t octaves, const double* x,
                    const double* y, std::size_t count, const FieldSums& sums) {
  HWY_DYNAMIC_DISPATCH(PerlinBatch)(block, octaves, x, y, count, sums);
}
void addGroupPoint(const GroupBlock& block, std::uint32_t octaves, double x, double y,
                   const FieldSums& sums) {
  HWY_DYNAMIC_DISPATCH(GroupPoint)(block, octaves, x, y, sums);
}
void addRegularPoint(const RegularBlock& block, std::uint32_t octaves, double x, double y,
                     const FieldSums& sums) {
  HWY_DYNAMIC_DISPATCH(RegularPoint)(block, octaves, x, y, sums);
}
void addPerlinPoint(const PerlinBlock& block, std::uint32_t octaves, double x, double y,
                    const FieldSums& sums) {
  HWY_DYNAMIC_DISPATCH(PerlinPoint)(block, octaves, x, y, sums);
}

const char* kernelTarget() { return HWY_DYNAMIC_DISPATCH(TargetName)(); }

bool forceKernelTarget(const char* target) {
  hwy::DisableTargets(0);
  if (std::strlen(target) == 0) return true;
  std::uint32_t above = 0;
  if (std::strcmp(target, "AVX3") == 0) {
    above = HWY_AVX3_DL;
  } else if (std::strcmp(target, "AVX2") == 0) {
    above = HWY_AVX3_DL | HWY_AVX3;
  } else if (std::strcmp(target, "SSE4") == 0) {
    above = HWY_AVX3_DL | HWY_AVX3 | HWY_AVX2;
  } else {
    return false;
  }
  hwy::DisableTargets(above);
  return std::strcmp(kernelTarget(), target) == 0;
}

}  // namespace seaway
#endif  // HWY_ONCE
