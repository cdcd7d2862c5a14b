#include "render/wake_pyramid_kernels.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/wake_pyramid_kernels.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace seaway::render {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// As many points at a time as doubles fit into a vector.
using Doubles = hn::ScalableTag<double>;
using Floats = hn::Rebind<float, Doubles>;
using Ints = hn::Rebind<std::int32_t, Doubles>;
using VD = hn::Vec<Doubles>;
using VF = hn::Vec<Floats>;
using VI = hn::Vec<Ints>;

/// The cell that a coordinate lies in, of so many that repeat (a power of two), and how far.
struct Place {
  VI cell;
  VF part;
};

HWY_INLINE Place placeOf(VD x, int cells) {
  const Doubles d;
  const VD whole = hn::Floor(x);
  // Powers of two: exact.
  const VD turns = hn::Floor(hn::Mul(whole, hn::Set(d, 1.0 / cells)));
  const VD cell = hn::Sub(whole, hn::Mul(turns, hn::Set(d, cells)));
  return {hn::DemoteTo(Ints(), cell), hn::DemoteTo(Floats(), hn::Sub(x, whole))};
}

/// Weights of a cubic B-spline's four coefficients about a place, and their derivatives.
struct Weights {
  VF value[4], slope[4];
};

HWY_INLINE Weights weightsAt(VF t) {
  const Floats f;
  const auto set = [&](float same) HWY_ATTR { return hn::Set(f, same); };
  const VF u = hn::Sub(set(1.0f), t), tt = hn::Mul(t, t), uu = hn::Mul(u, u);
  const VF half = set(0.5f), twoThirds = set(2.0f / 3.0f), sixth = set(1.0f / 6.0f);
  Weights w;
  w.value[0] = hn::Mul(hn::Mul(uu, u), sixth);
  w.value[1] = hn::Sub(twoThirds, hn::Mul(tt, hn::Sub(set(1.0f), hn::Mul(half, t))));
  w.value[2] = hn::Sub(twoThirds, hn::Mul(uu, hn::Sub(set(1.0f), hn::Mul(half, u))));
  w.value[3] = hn::Mul(hn::Mul(tt, t), sixth);
  w.slope[0] = hn::Neg(hn::Mul(half, uu));
  w.slope[1] = hn::Mul(t, hn::Sub(hn::Mul(set(1.5f), t), set(2.0f)));
  w.slope[2] = hn::Mul(u, hn::Sub(set(2.0f), hn::Mul(set(1.5f), u)));
  w.slope[3] = hn::Mul(half, tt);
  return w;
}

/// Height and slopes, per cell.
struct Sample {
  VF height, x, y;
};

HWY_INLINE Sample splineAt(const WakeLevel& level, VD x, VD y) {
  const Floats f;
  const Place column = placeOf(x, level.cells), row = placeOf(y, level.cells);
  const Weights across = weightsAt(column.part), up = weightsAt(row.part);
  const VI first =
      hn::Add(hn::Mul(row.cell, hn::Set(Ints(), static_cast<int>(level.stride))), column.cell);
  constexpr std::size_t most = hn::MaxLanes(Doubles());
  alignas(64) std::array<std::int32_t, most> at;
  alignas(64) std::array<float, 4 * most> near;
  hn::Store(first, Ints(), at.data());
  Sample sample{hn::Zero(f), hn::Zero(f), hn::Zero(f)};
  for (int r = 0; r < 4; ++r) {
    // Four neighbours at once: faster than to gather each.
    const float* const from = level.spline + static_cast<std::size_t>(r) * level.stride;
    for (std::size_t i = 0; i < hn::Lanes(Doubles()); ++i) {
      std::memcpy(&near[4 * i], from + at[i], 4 * sizeof(float));
    }
    VF c[4];
    hn::LoadInterleaved4(f, near.data(), c[0], c[1], c[2], c[3]);
    VF value = hn::Mul(across.value[0], c[0]), slope = hn::Mul(across.slope[0], c[0]);
    for (int k = 1; k < 4; ++k) {
      value = hn::MulAdd(across.value[k], c[k], value);
      slope = hn::MulAdd(across.slope[k], c[k], slope);
    }
    sample.height = hn::MulAdd(up.value[r], value, sample.height);
    sample.x = hn::MulAdd(up.value[r], slope, sample.x);
    sample.y = hn::MulAdd(up.slope[r], value, sample.y);
  }
  return sample;
}

/// Bilinear between the blocks' centres, periodic.
HWY_INLINE VF missingAt(const WakeLevel& level, VD x, VD y) {
  const Doubles d;
  const Floats f;
  const VD half = hn::Set(d, 0.5);
  const Place column = placeOf(hn::Sub(x, half), level.blocks);
  const Place row = placeOf(hn::Sub(y, half), level.blocks);
  const VI one = hn::Set(Ints(), 1), last = hn::Set(Ints(), level.blocks - 1);
  const VI across = hn::Set(Ints(), level.blocks);
  const VI left = column.cell, right = hn::And(hn::Add(left, one), last);
  const VI low = hn::Mul(row.cell, across);
  const VI high = hn::Mul(hn::And(hn::Add(row.cell, one), last), across);
  const auto at = [&](VI line, VI place)
                      HWY_ATTR { return hn::GatherIndex(f, level.missing, hn::Add(line, place)); };
  const auto mix = [](VF a, VF b, VF t) HWY_ATTR { return hn::MulAdd(t, hn::Sub(b, a), a); };
  return mix(mix(at(low, left), at(low, right), column.part),
             mix(at(high, left), at(high, right), column.part), row.part);
}

/// Adds at a vector of points.
HWY_INLINE void addAt(const WakeLevel& level, float part, const double* x, const double* y,
                      const WakeSums& sums, std::size_t p) {
  const Doubles d;
  const Floats f;
  VD px = hn::LoadU(d, x + p), py = hn::LoadU(d, y + p);
  const VD reach = hn::Set(d, 0.5 * level.size);
  const auto near = [&](VD place, double centre) HWY_ATTR {
    return hn::Lt(hn::Abs(hn::Sub(place, hn::Set(d, centre))), reach);
  };
  const auto isInside = hn::And(near(px, level.centreX), near(py, level.centreY));
  if (hn::AllFalse(d, isInside)) return;
  // Places outside, which may be no numbers, are not looked up.
  px = hn::IfThenElse(isInside, px, hn::Set(d, level.centreX));
  py = hn::IfThenElse(isInside, py, hn::Set(d, level.centreY));
  const VF one = hn::DemoteTo(f, hn::IfThenElseZero(isInside, hn::Set(d, 1.0)));
  const auto inside = hn::Gt(one, hn::Zero(f));
  const auto add = [&](VF factor, VF value, float* to) HWY_ATTR {
    const VF before = hn::LoadU(f, to + p);
    hn::StoreU(hn::IfThenElse(inside, hn::MulAdd(factor, value, before), before), f, to + p);
  };
  const VF share = hn::Set(f, part);
  if (sums.missing && level.missing) {
    const VD perBlock = hn::Set(d, level.blocks / level.size);
    add(share, missingAt(level, hn::Mul(px, perBlock), hn::Mul(py, perBlock)), sums.missing);
  }
  if (level.cells == 0) return;
  const double perCell = level.cells / level.size;
  const VD scale = hn::Set(d, perCell);
  const Sample sample = splineAt(level, hn::Mul(px, scale), hn::Mul(py, scale));
  const VF slopeShare = hn::Set(f, part * static_cast<float>(perCell));
  add(share, sample.height, sums.height);
  add(slopeShare, sample.x, sums.slopeX);
  add(slopeShare, sample.y, sums.slopeY);
}

}  // namespace

void AddWakeLevel(const WakeLevel& level, float part, std::span<const double> x,
                  std::span<const double> y, const WakeSums& sums) {
  const std::size_t lanes = hn::Lanes(Doubles()), count = x.size();
  std::size_t p = 0;
  for (; p + lanes <= count; p += lanes) addAt(level, part, x.data(), y.data(), sums, p);
  if (p == count) return;
  constexpr std::size_t most = hn::MaxLanes(Doubles());
  const std::size_t left = count - p;
  std::array<double, most> lastX{}, lastY{};
  std::copy_n(x.begin() + static_cast<std::ptrdiff_t>(p), left, lastX.begin());
  std::copy_n(y.begin() + static_cast<std::ptrdiff_t>(p), left, lastY.begin());
  std::array<std::array<float, most>, 4> last{};
  float* const all[4] = {sums.height, sums.slopeX, sums.slopeY, sums.missing};
  for (int k = 0; k < 4; ++k) {
    if (all[k]) std::copy_n(all[k] + p, left, last[k].begin());
  }
  addAt(level, part, lastX.data(), lastY.data(),
        {last[0].data(), last[1].data(), last[2].data(), all[3] ? last[3].data() : nullptr}, 0);
  for (int k = 0; k < 4; ++k) {
    if (all[k]) std::copy_n(last[k].begin(), left, all[k] + p);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace seaway::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace seaway::render {

HWY_EXPORT(AddWakeLevel);

void addWakeLevel(const WakeLevel& level, float part, std::span<const double> x,
                  std::span<const double> y, const WakeSums& sums) {
  HWY_DYNAMIC_DISPATCH(AddWakeLevel)(level, part, x, y, sums);
}

}  // namespace seaway::render
#endif
