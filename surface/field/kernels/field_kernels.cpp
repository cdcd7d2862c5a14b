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
template <bool kOrbital>
HWY_INLINE Contribution LoadSums(const FieldSums& sums, std::size_t at) {
  const Floats f;
  Contribution result = Nothing();
  result.height = hn::Load(f, sums.height + at);
  result.slopeX = hn::Load(f, sums.slopeX + at);
  result.slopeY = hn::Load(f, sums.slopeY + at);
  result.rate = hn::Load(f, sums.rate + at);
  if constexpr (kOrbital) {
    result.orbitalX = hn::Load(f, sums.orbitalX + at);
    result.orbitalY = hn::Load(f, sums.orbitalY + at);
  }
  return result;
}

template <bool kOrbital>
HWY_INLINE void StoreSums(const Contribution& result, const FieldSums& sums, std::size_t at) {
  const Floats f;
  hn::Store(result.height, f, sums.height + at);
  hn::Store(result.slopeX, f, sums.slopeX + at);
  hn::Store(result.slopeY, f, sums.slopeY + at);
  hn::Store(result.rate, f, sums.rate + at);
  if constexpr (kOrbital) {
    hn::Store(result.orbitalX, f, sums.orbitalX + at);
    hn::Store(result.orbitalY, f, sums.orbitalY + at);
  }
}

/// Octaves are summed in quads, (a + b) + (c + d), quads one after the other: an order that octaves
/// in lanes can follow. `stages.Prepare(octaves, x, y)` readies a vector of points, `stages(i)` is
/// what octave i then adds.
template <bool kOrbital, class Stages>
HWY_INLINE void AddBatch(std::uint32_t octaves, const double* HWY_RESTRICT x,
                         const double* HWY_RESTRICT y, std::size_t count, const FieldSums& sums,
                         Stages& stages) {
  const std::size_t lanes = hn::Lanes(Floats());
  for (std::size_t at = 0; at < count; at += lanes) {
    stages.Prepare(octaves, LoadPair(x + at), LoadPair(y + at));
    Contribution total = LoadSums<kOrbital>(sums, at);
    Contribution firstPair = Nothing();
    std::size_t octave = 0;
    for (std::uint32_t left = octaves; left != 0; left >>= 2, octave += 2) {
      const Contribution a = (left & 1) != 0 ? stages(octave) : Nothing();
      const Contribution b = (left & 2) != 0 ? stages(octave + 1) : Nothing();
      const Contribution pair = Plus<kOrbital>(a, b);
      const bool second = (octave & 2) != 0;
      if (second) total = Plus<kOrbital>(total, Plus<kOrbital>(firstPair, pair));
      firstPair = second ? Nothing() : pair;
    }
    if (octave & 2) total = Plus<kOrbital>(total, Plus<kOrbital>(firstPair, Nothing()));
    StoreSums<kOrbital>(total, sums, at);
  }
}

/// Points in lanes without stages: each octave in one go.
template <class Contribute>
class Unstaged {
 public:
  explicit HWY_INLINE Unstaged(Contribute contribute) : contribute_(contribute) {}
  HWY_INLINE void Prepare(std::uint32_t, DoublePair x, DoublePair y) { x_ = x, y_ = y; }
  HWY_INLINE Contribution operator()(std::size_t octave) const {
    return contribute_(ReadBroadcast{octave}, x_, y_);
  }

 private:
  Contribute contribute_;
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
template <bool kOrbital, class Contribute>
HWY_INLINE void AddPoint(std::uint32_t octaves, double x, double y, const FieldSums& sums,
                         Contribute contribute) {
  const Floats f;
  const std::size_t lanes = hn::Lanes(f);
  for (std::size_t first = 0; (octaves >> first) != 0; first += lanes) {
    const Contribution all = contribute(ReadLanes{first}, SetPair(x), SetPair(y));
    const std::uint64_t bits = octaves >> first;
    const auto mask = hn::LoadMaskBits(f, reinterpret_cast<const std::uint8_t*>(&bits));
    AddQuads(hn::IfThenElseZero(mask, all.height), *sums.height);
    AddQuads(hn::IfThenElseZero(mask, all.slopeX), *sums.slopeX);
    AddQuads(hn::IfThenElseZero(mask, all.slopeY), *sums.slopeY);
    AddQuads(hn::IfThenElseZero(mask, all.rate), *sums.rate);
    if constexpr (kOrbital) {
      AddQuads(hn::IfThenElseZero(mask, all.orbitalX), *sums.orbitalX);
      AddQuads(hn::IfThenElseZero(mask, all.orbitalY), *sums.orbitalY);
    }
    if (first + lanes >= octavesPerBlock) break;
  }
}

template <bool kOrbital>
struct RegularOf {
  const RegularBlock& block;
  template <class Read>
  HWY_INLINE Contribution operator()(Read read, DoublePair x, DoublePair y) const {
    return RegularContribution<kOrbital>(block, read, x, y);
  }
};

struct PerlinOf {
  const PerlinBlock& block;
  template <class Read>
  HWY_INLINE Contribution operator()(Read read, DoublePair x, DoublePair y) const {
    return PerlinContribution(block, read, x, y);
  }
};

}  // namespace

void GroupBatch(const GroupBlock& block, std::uint32_t octaves, const double* x, const double* y,
                std::size_t count, const FieldSums& sums) {
  if (sums.orbitalX) {
    GroupStaged<true> stages(block);
    AddBatch<true>(octaves, x, y, count, sums, stages);
  } else {
    GroupStaged<false> stages(block);
    AddBatch<false>(octaves, x, y, count, sums, stages);
  }
}

void RegularBatch(const RegularBlock& block, std::uint32_t octaves, const double* x, const double* y,
                  std::size_t count, const FieldSums& sums) {
  if (sums.orbitalX) {
    Unstaged<RegularOf<true>> stages({block});
    AddBatch<true>(octaves, x, y, count, sums, stages);
  } else {
    Unstaged<RegularOf<false>> stages({block});
    AddBatch<false>(octaves, x, y, count, sums, stages);
  }
}

void PerlinBatch(const PerlinBlock& block, std::uint32_t octaves, const double* x, const double* y,
                 std::size_t count, const FieldSums& sums) {
  Unstaged<PerlinOf> stages({block});
  AddBatch<false>(octaves, x, y, count, sums, stages);
}

void GroupPoint(const GroupBlock& block, std::uint32_t octaves, double x, double y,
                const FieldSums& sums) {
  if (sums.orbitalX) {
    AddPoint<true>(octaves, x, y, sums, GroupAtOnce<true>{block});
  } else {
    AddPoint<false>(octaves, x, y, sums, GroupAtOnce<false>{block});
  }
}

void RegularPoint(const RegularBlock& block, std::uint32_t octaves, double x, double y,
                  const FieldSums& sums) {
  if (sums.orbitalX) {
    AddPoint<true>(octaves, x, y, sums, RegularOf<true>{block});
  } else {
    AddPoint<false>(octaves, x, y, sums, RegularOf<false>{block});
  }
}

void PerlinPoint(const PerlinBlock& block, std::uint32_t octaves, double x, double y,
                 const FieldSums& sums) {
  AddPoint<false>(octaves, x, y, sums, PerlinOf{block});
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
void addRegularBatch(const RegularBlock& block, std::uint32_t octaves, const double* x, const double* y,
                     std::size_t count, const FieldSums& sums) {
  HWY_DYNAMIC_DISPATCH(RegularBatch)(block, octaves, x, y, count, sums);
}
void addPerlinBatch(const PerlinBlock& block, std::uint32_t octaves, const double* x, const double* y,
                    std::size_t count, const FieldSums& sums) {
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
