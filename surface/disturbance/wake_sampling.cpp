#include "surface/disturbance/wake_sampling.h"

#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "surface/disturbance/wake_sampling.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace seaway::wake {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Four cells of (η, ∂η/∂t): one vector of eight lanes, or two of four.
using Eight = hn::CappedTag<float, 8>;
using Four = hn::FixedTag<float, 4>;
using V = hn::Vec<Eight>;
using V4 = hn::Vec<Four>;
constexpr std::size_t kParts = 8 / hn::MaxLanes(Eight());

struct Cells {
  V part[kParts];
};

HWY_INLINE Cells LoadCells(const float* from) {
  Cells cells;
  for (std::size_t p = 0; p < kParts; ++p) {
    cells.part[p] = hn::LoadU(Eight(), from + p * hn::MaxLanes(Eight()));
  }
  return cells;
}
HWY_INLINE Cells Scaled(const Cells& a, V by) {
  Cells result;
  for (std::size_t p = 0; p < kParts; ++p) result.part[p] = hn::Mul(a.part[p], by);
  return result;
}
HWY_INLINE void AddScaled(Cells& sum, const Cells& a, V by) {
  for (std::size_t p = 0; p < kParts; ++p) sum.part[p] = hn::MulAdd(a.part[p], by, sum.part[p]);
}
HWY_INLINE Cells Blend(const Cells& a, V byA, const Cells& b, V byB) {
  Cells result;
  for (std::size_t p = 0; p < kParts; ++p) {
    result.part[p] = hn::MulAdd(b.part[p], byB, hn::Mul(a.part[p], byA));
  }
  return result;
}

/// Products with the weights of four cells, each for both of its lanes, down to four lanes to sum.
HWY_INLINE V4 Along(const Cells& cells, const Cells& weights) {
#if HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_SSSE3
  return hn::MulAdd(cells.part[1], weights.part[1], hn::Mul(cells.part[0], weights.part[0]));
#else
  const V products = hn::Mul(cells.part[0], weights.part[0]);
  return hn::Add(hn::LowerHalf(Four(), products), hn::UpperHalf(Four(), products));
#endif
}

/// Sums of the lanes of four vectors.
HWY_INLINE V4 SumsOf(V4 a, V4 b, V4 c, V4 d) {
  const Four f;
  const V4 ab = hn::Add(hn::InterleaveLower(f, a, b), hn::InterleaveUpper(f, a, b));
  const V4 cd = hn::Add(hn::InterleaveLower(f, c, d), hn::InterleaveUpper(f, c, d));
  return hn::Add(hn::ConcatLowerLower(f, cd, ab), hn::ConcatUpperUpper(f, cd, ab));
}

/// Cubic B-spline weights of cells −1 … 2 as polynomials of the fraction, one coefficient a cell.
alignas(16) constexpr float kCubic[4][4] = {{1.0f / 6, 2.0f / 3, 1.0f / 6, 0.0f},
                                            {-0.5f, 0.0f, 0.5f, 0.0f},
                                            {0.5f, -1.0f, 0.5f, 0.0f},
                                            {-1.0f / 6, 0.5f, -0.5f, 1.0f / 6}};
alignas(32) constexpr float kPairs[4][8] = {
    {1.0f / 6, 1.0f / 6, 2.0f / 3, 2.0f / 3, 1.0f / 6, 1.0f / 6, 0.0f, 0.0f},
    {-0.5f, -0.5f, 0.0f, 0.0f, 0.5f, 0.5f, 0.0f, 0.0f},
    {0.5f, 0.5f, -1.0f, -1.0f, 0.5f, 0.5f, 0.0f, 0.0f},
    {-1.0f / 6, -1.0f / 6, 0.5f, 0.5f, -0.5f, -0.5f, 1.0f / 6, 1.0f / 6}};

HWY_INLINE V4 Weights(V4 t) {
  const Four f;
  V4 w = hn::MulAdd(hn::Load(f, kCubic[3]), t, hn::Load(f, kCubic[2]));
  w = hn::MulAdd(w, t, hn::Load(f, kCubic[1]));
  return hn::MulAdd(w, t, hn::Load(f, kCubic[0]));
}
HWY_INLINE V4 Slopes(V4 t) {
  const Four f;
  const V4 three = hn::Mul(t, hn::Set(f, 3.0f));
  const V4 w = hn::MulAdd(hn::Load(f, kCubic[3]), three,
                          hn::Add(hn::Load(f, kCubic[2]), hn::Load(f, kCubic[2])));
  return hn::MulAdd(w, t, hn::Load(f, kCubic[1]));
}
HWY_INLINE Cells PairWeights(float fraction) {
  Cells w = LoadCells(kPairs[3]);
  const V t = hn::Set(Eight(), fraction);
  for (int power = 2; power >= 0; --power) {
    const Cells c = LoadCells(kPairs[power]);
    for (std::size_t p = 0; p < kParts; ++p) w.part[p] = hn::MulAdd(w.part[p], t, c.part[p]);
  }
  return w;
}
HWY_INLINE Cells PairSlopes(float fraction) {
  const Eight e;
  const V t = hn::Set(e, fraction), two = hn::Set(e, 2.0f), three = hn::Set(e, 3.0f);
  const Cells c1 = LoadCells(kPairs[1]), c2 = LoadCells(kPairs[2]), c3 = LoadCells(kPairs[3]);
  Cells w;
  for (std::size_t p = 0; p < kParts; ++p) {
    w.part[p] = hn::MulAdd(hn::Mul(c3.part[p], three), t, hn::Mul(c2.part[p], two));
    w.part[p] = hn::MulAdd(w.part[p], t, c1.part[p]);
  }
  return w;
}

HWY_INLINE V Pair(const float* weights) {
  alignas(32) const float lanes[8] = {weights[0], weights[1], weights[0], weights[1],
                                      weights[0], weights[1], weights[0], weights[1]};
  return hn::Load(Eight(), lanes);
}

/// Time weights in the lanes of (η, ∂η/∂t).
struct TimeWeights {
  V heightBefore, heightAfter, rateBefore, rateAfter, potentialBefore, potentialAfter;
  explicit HWY_INLINE TimeWeights(const SheetSampling& s)
      : heightBefore(Pair(s.heightBefore)),
        heightAfter(Pair(s.heightAfter)),
        rateBefore(Pair(s.rateBefore)),
        rateAfter(Pair(s.rateAfter)) {
    const float before[2] = {s.potentialFromHeight[0], 0.0f};
    const float after[2] = {s.potentialFromHeight[1], 0.0f};
    potentialBefore = Pair(before);
    potentialAfter = Pair(after);
  }
};

/// The potential's own cells, blended in time: u from ∂/∂x, v from ∂/∂y.
HWY_INLINE void PotentialSlopes(const SheetSampling& s, std::size_t corner, const float* weightsY,
                                const float* slopesY, V4 weightsX, V4 slopesX, V4& u, V4& v) {
  const Four f;
  const V4 before = hn::Set(f, s.potentialWeights[0]), after = hn::Set(f, s.potentialWeights[1]);
  V4 value = hn::Zero(f), slope = hn::Zero(f);
  for (std::size_t r = 0; r < 4; ++r) {
    const std::size_t at = corner + r * s.stride;
    const V4 row = hn::MulAdd(hn::LoadU(f, s.potentialBefore + at), before,
                              hn::Mul(hn::LoadU(f, s.potentialAfter + at), after));
    value = hn::MulAdd(row, hn::Set(f, weightsY[r]), value);
    slope = hn::MulAdd(row, hn::Set(f, slopesY[r]), slope);
  }
  u = hn::MulAdd(value, slopesX, u);
  v = hn::MulAdd(slope, weightsX, v);
}

template <SheetQuantities kWhat>
HWY_INLINE void AddPoint(const SheetSampling& s, const TimeWeights& time, V4 scale, double x,
                         double y, PointSums& sums) {
  const Four f;
  const double cellX = x * s.perCell, cellY = y * s.perCell;
  const double floorX = std::floor(cellX), floorY = std::floor(cellY);
  const float partX = static_cast<float>(cellX - floorX);
  const float partY = static_cast<float>(cellY - floorY);
  const auto i = static_cast<std::size_t>(static_cast<std::int64_t>(floorX) & s.mask);
  const auto j = static_cast<std::size_t>(static_cast<std::int64_t>(floorY) & s.mask);
  const std::size_t corner = j * s.stride + i;

  alignas(16) float weightsY[4], slopesY[4];
  hn::Store(Weights(hn::Set(f, partY)), f, weightsY);
  if constexpr (kWhat != SheetQuantities::height) hn::Store(Slopes(hn::Set(f, partY)), f, slopesY);
  Cells before, after, slopeBefore, slopeAfter;
  for (std::size_t r = 0; r < 4; ++r) {
    const std::size_t at = 2 * (corner + r * s.stride);
    const Cells a = LoadCells(s.surfaceBefore + at), b = LoadCells(s.surfaceAfter + at);
    const V w = hn::Set(Eight(), weightsY[r]);
    if (r == 0) {
      before = Scaled(a, w), after = Scaled(b, w);
    } else {
      AddScaled(before, a, w), AddScaled(after, b, w);
    }
    if constexpr (kWhat != SheetQuantities::height) {
      const V d = hn::Set(Eight(), slopesY[r]);
      if (r == 0) {
        slopeBefore = Scaled(a, d), slopeAfter = Scaled(b, d);
      } else {
        AddScaled(slopeBefore, a, d), AddScaled(slopeAfter, b, d);
      }
    }
  }
  const Cells weightsX = PairWeights(partX);
  const Cells now = Blend(before, time.heightBefore, after, time.heightAfter);
  const V4 heights = Along(now, weightsX);
  if constexpr (kWhat == SheetQuantities::height) {
    sums[height] += hn::GetLane(hn::SumOfLanes(f, heights));
    return;
  } else {
    const Cells slopesX = PairSlopes(partX);
    const Cells across = Blend(slopeBefore, time.heightBefore, slopeAfter, time.heightAfter);
    const Cells rates = Blend(before, time.rateBefore, after, time.rateAfter);
    const V4 all =
        SumsOf(heights, Along(now, slopesX), Along(across, weightsX), Along(rates, weightsX));
    hn::StoreU(hn::MulAdd(all, scale, hn::LoadU(f, sums.data())), f, sums.data());
    if constexpr (kWhat == SheetQuantities::orbital) {
      V4 u = Along(Blend(before, time.potentialBefore, after, time.potentialAfter), slopesX);
      V4 v = Along(Blend(slopeBefore, time.potentialBefore, slopeAfter, time.potentialAfter),
                   weightsX);
      PotentialSlopes(s, corner, weightsY, slopesY, Weights(hn::Set(f, partX)),
                      Slopes(hn::Set(f, partX)), u, v);
      const V4 velocity = hn::Mul(SumsOf(u, v, hn::Zero(f), hn::Zero(f)),
                                  hn::Set(f, static_cast<float>(s.perCell)));
      hn::StoreU(hn::Add(velocity, hn::LoadU(f, sums.data() + velocityX)), f,
                 sums.data() + velocityX);
    }
  }
}

template <SheetQuantities kWhat>
HWY_INLINE void AddPoints(const SheetSampling& s, const double* x, const double* y,
                          std::size_t count, PointSums* sums) {
  const TimeWeights time(s);
  const float perCell = static_cast<float>(s.perCell);
  alignas(16) const float scales[4] = {1.0f, perCell, perCell, 1.0f};
  const V4 scale = hn::Load(Four(), scales);
  for (std::size_t p = 0; p < count; ++p) {
    const bool inside = std::abs(x[p] - s.centreX) < s.half && std::abs(y[p] - s.centreY) < s.half;
    if (inside) AddPoint<kWhat>(s, time, scale, x[p], y[p], sums[p]);
  }
}

}  // namespace

void AddSheetKernel(const SheetSampling& s, SheetQuantities what, const double* x, const double* y,
                    std::size_t count, PointSums* sums) {
  switch (what) {
    case SheetQuantities::height:
      return AddPoints<SheetQuantities::height>(s, x, y, count, sums);
    case SheetQuantities::surface:
      return AddPoints<SheetQuantities::surface>(s, x, y, count, sums);
    case SheetQuantities::orbital:
      return AddPoints<SheetQuantities::orbital>(s, x, y, count, sums);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace seaway::wake
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "surface/constants.h"

namespace seaway::wake {

HWY_EXPORT(AddSheetKernel);

void addSheet(const SheetSampling& sheet, SheetQuantities what, const double* x, const double* y,
              std::size_t count, PointSums* sums) {
  HWY_DYNAMIC_DISPATCH(AddSheetKernel)(sheet, what, x, y, count, sums);
}

void setTime(SheetSampling& sheet, double before, double after, double time) {
  const double step = after - before, s = (time - before) / step;
  const double fromBefore = (1.0 + 2.0 * s) * (1.0 - s) * (1.0 - s), fromAfter = 1.0 - fromBefore;
  const double rateBefore = s * (1.0 - s) * (1.0 - s) * step, rateAfter = s * s * (s - 1.0) * step;
  const auto set = [](float* pair, double value, double rate) {
    pair[0] = static_cast<float>(value), pair[1] = static_cast<float>(rate);
  };
  set(sheet.heightBefore, fromBefore, rateBefore);
  set(sheet.heightAfter, fromAfter, rateAfter);
  const double slope = 6.0 * s * (1.0 - s) / step;
  set(sheet.rateBefore, -slope, (1.0 - s) * (1.0 - 3.0 * s));
  set(sheet.rateAfter, slope, s * (3.0 * s - 2.0));
  set(sheet.potentialWeights, fromBefore, fromAfter);
  set(sheet.potentialFromHeight, -standardGravity * rateBefore, -standardGravity * rateAfter);
}

}  // namespace seaway::wake
#endif  // HWY_ONCE
