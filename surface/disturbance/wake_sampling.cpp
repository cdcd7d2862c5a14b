#include "surface/disturbance/wake_sampling.h"

#include <algorithm>
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

/// Four cells of (η, ∂η/∂t): one vector of eight lanes, or two of four. Those before and after
/// fit one vector of sixteen where there is one.
using Eight = hn::CappedTag<float, 8>;
using Four = hn::FixedTag<float, 4>;
using Sixteen = hn::CappedTag<float, 16>;
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
HWY_INLINE Cells Times(const Cells& a, const Cells& b) {
  Cells result;
  for (std::size_t p = 0; p < kParts; ++p) result.part[p] = hn::Mul(a.part[p], b.part[p]);
  return result;
}

/// Weights of cells before and after in what is wanted at the time, in the lanes of (η, ∂η/∂t).
struct TimeWeights {
  Cells before, after;
  HWY_INLINE TimeWeights(const float* ofBefore, const float* ofAfter) {
    alignas(32) float lanes[2][8];
    for (std::size_t l = 0; l < 8; ++l) {
      lanes[0][l] = ofBefore[l % 2];
      lanes[1][l] = ofAfter[l % 2];
    }
    before = LoadCells(lanes[0]);
    after = LoadCells(lanes[1]);
  }
};

/// A row, or a sum of rows, of the cells before and of those after.
#if HWY_MAX_BYTES >= 64
struct Rows {
  hn::Vec<Sixteen> both;
};
HWY_INLINE Rows LoadRows(const float* before, const float* after) {
  return {hn::Combine(Sixteen(), hn::LoadU(Eight(), after), hn::LoadU(Eight(), before))};
}
HWY_INLINE Rows Scaled(const Rows& rows, const float* by) {
  return {hn::Mul(rows.both, hn::Set(Sixteen(), *by))};
}
HWY_INLINE void AddScaled(Rows& sum, const Rows& rows, const float* by) {
  sum.both = hn::MulAdd(rows.both, hn::Set(Sixteen(), *by), sum.both);
}
HWY_INLINE Cells At(const TimeWeights& time, const Rows& rows) {
  const V before = hn::LowerHalf(Eight(), rows.both), after = hn::UpperHalf(Eight(), rows.both);
  return {{hn::MulAdd(after, time.after.part[0], hn::Mul(before, time.before.part[0]))}};
}
#else
struct Rows {
  Cells before, after;
};
HWY_INLINE Rows LoadRows(const float* before, const float* after) {
  return {LoadCells(before), LoadCells(after)};
}
HWY_INLINE Rows Scaled(const Rows& rows, const float* by) {
  const V scale = hn::Set(Eight(), *by);
  Rows result;
  for (std::size_t p = 0; p < kParts; ++p) {
    result.before.part[p] = hn::Mul(rows.before.part[p], scale);
    result.after.part[p] = hn::Mul(rows.after.part[p], scale);
  }
  return result;
}
HWY_INLINE void AddScaled(Rows& sum, const Rows& rows, const float* by) {
  const V scale = hn::Set(Eight(), *by);
  for (std::size_t p = 0; p < kParts; ++p) {
    sum.before.part[p] = hn::MulAdd(rows.before.part[p], scale, sum.before.part[p]);
    sum.after.part[p] = hn::MulAdd(rows.after.part[p], scale, sum.after.part[p]);
  }
}
HWY_INLINE Cells At(const TimeWeights& time, const Rows& rows) {
  Cells cells;
  for (std::size_t p = 0; p < kParts; ++p) {
    cells.part[p] = hn::MulAdd(rows.after.part[p], time.after.part[p],
                               hn::Mul(rows.before.part[p], time.before.part[p]));
  }
  return cells;
}
#endif

/// One vector of what four cells come to.
HWY_INLINE V Folded(const Cells& cells) {
  V sum = cells.part[0];
  for (std::size_t p = 1; p < kParts; ++p) sum = hn::Add(sum, cells.part[p]);
  return sum;
}
HWY_INLINE V4 Halved(V v) {
#if HWY_MAX_BYTES >= 32
  return hn::Add(hn::LowerHalf(Four(), v), hn::UpperHalf(Four(), v));
#else
  return v;
#endif
}

/// Sums of the lanes of four vectors, in the four lanes of one.
HWY_INLINE V4 SumsOf(V a, V b, V c, V d) {
  const Eight e;
  const hn::RepartitionToWide<Eight> pairs;
  const V ab = hn::Add(hn::InterleaveLower(e, a, b), hn::InterleaveUpper(e, a, b));
  const V cd = hn::Add(hn::InterleaveLower(e, c, d), hn::InterleaveUpper(e, c, d));
  const auto p = hn::BitCast(pairs, ab), q = hn::BitCast(pairs, cd);
  return Halved(hn::Add(hn::BitCast(e, hn::InterleaveLower(pairs, p, q)),
                        hn::BitCast(e, hn::InterleaveUpper(pairs, p, q))));
}

/// Cubic B-spline weights of cells −1 … 2 as polynomials of the fraction, one coefficient a cell,
/// and those of their derivatives.
constexpr float kCubic[4][4] = {{1.0f / 6, 2.0f / 3, 1.0f / 6, 0.0f},
                                {-0.5f, 0.0f, 0.5f, 0.0f},
                                {0.5f, -1.0f, 0.5f, 0.0f},
                                {-1.0f / 6, 0.5f, -0.5f, 1.0f / 6}};
constexpr float kSlope[3][4] = {
    {-0.5f, 0.0f, 0.5f, 0.0f}, {1.0f, -2.0f, 1.0f, 0.0f}, {-0.5f, 1.5f, -1.5f, 0.5f}};

/// The same for pairs of lanes.
struct PairPolynomial {
  Cells powers[4];
  HWY_INLINE PairPolynomial(const float (*coefficients)[4], int count) {
    for (int power = 0; power < count; ++power) {
      alignas(32) float lanes[8];
      for (std::size_t l = 0; l < 8; ++l) lanes[l] = coefficients[power][l / 2];
      powers[power] = LoadCells(lanes);
    }
  }
  template <int kDegree>
  HWY_INLINE Cells At(const float* fraction) const {
    const V t = hn::Set(Eight(), *fraction);
    Cells w = powers[kDegree];
    for (int power = kDegree - 1; power >= 0; --power) {
      for (std::size_t p = 0; p < kParts; ++p) {
        w.part[p] = hn::MulAdd(w.part[p], t, powers[power].part[p]);
      }
    }
    return w;
  }
};

HWY_INLINE V4 Weights(V4 t) {
  const Four f;
  V4 w = hn::LoadU(f, kCubic[3]);
  for (int power = 2; power >= 0; --power) w = hn::MulAdd(w, t, hn::LoadU(f, kCubic[power]));
  return w;
}
HWY_INLINE V4 Slopes(V4 t) {
  const Four f;
  V4 w = hn::LoadU(f, kSlope[2]);
  for (int power = 1; power >= 0; --power) w = hn::MulAdd(w, t, hn::LoadU(f, kSlope[power]));
  return w;
}

/// Where points lie among the cells, worked out for many at a time.
constexpr std::size_t kTogether = 64;
struct Places {
  alignas(64) float partX[kTogether];
  alignas(64) float weightsY[4][kTogether], slopesY[4][kTogether];
  alignas(64) std::int32_t column[kTogether], row[kTogether];
  bool inside[kTogether];
};

/// Cells and fractions along one axis: `cells` is a power of two.
HWY_INLINE void LocateAxis(const double* x, std::size_t count, double perCell, double cells,
                           float* part, std::int32_t* cell) {
  const hn::ScalableTag<double> d;
  const hn::Rebind<float, decltype(d)> f;
  const hn::Rebind<std::int32_t, decltype(d)> n;
  const auto scale = hn::Set(d, perCell), whole = hn::Set(d, cells),
             turns = hn::Set(d, 1.0 / cells);
  for (std::size_t p = 0; p < count; p += hn::Lanes(d)) {
    const auto at = hn::Mul(hn::LoadU(d, x + p), scale);
    const auto low = hn::Floor(at);
    hn::StoreU(hn::DemoteTo(f, hn::Sub(at, low)), f, part + p);
    hn::StoreU(hn::DemoteTo(n, hn::NegMulAdd(hn::Floor(hn::Mul(low, turns)), whole, low)), n,
               cell + p);
  }
}

template <bool kWithSlopes>
HWY_INLINE void Locate(const SheetSampling& s, const double* x, const double* y, std::size_t count,
                       bool allInside, Places& places) {
  alignas(64) float partY[kTogether];
  alignas(64) double paddedX[kTogether], paddedY[kTogether];
  const std::size_t lanes = hn::Lanes(hn::ScalableTag<float>());
  std::size_t filled = count;
  if (allInside && count % lanes == 0) {
    std::fill_n(places.inside, count, true);
  } else {
    for (std::size_t p = 0; p < count; ++p) {
      places.inside[p] = std::abs(x[p] - s.centreX) < s.half && std::abs(y[p] - s.centreY) < s.half;
      paddedX[p] = places.inside[p] ? x[p] : s.centreX;
      paddedY[p] = places.inside[p] ? y[p] : s.centreY;
    }
    filled = std::min(kTogether, (count + lanes - 1) / lanes * lanes);  // whole vectors
    std::fill(paddedX + count, paddedX + filled, s.centreX);
    std::fill(paddedY + count, paddedY + filled, s.centreY);
    x = paddedX, y = paddedY;
  }
  const auto cells = static_cast<double>(s.mask + 1);
  LocateAxis(x, filled, s.perCell, cells, places.partX, places.column);
  LocateAxis(y, filled, s.perCell, cells, partY, places.row);
  const hn::ScalableTag<float> f;
  for (std::size_t p = 0; p < filled; p += lanes) {
    const auto t = hn::Load(f, partY + p);
    for (std::size_t cell = 0; cell < 4; ++cell) {
      auto w = hn::Set(f, kCubic[3][cell]);
      for (int power = 2; power >= 0; --power) {
        w = hn::MulAdd(w, t, hn::Set(f, kCubic[power][cell]));
      }
      hn::Store(w, f, places.weightsY[cell] + p);
      if constexpr (kWithSlopes) {
        auto d = hn::Set(f, kSlope[2][cell]);
        for (int power = 1; power >= 0; --power) {
          d = hn::MulAdd(d, t, hn::Set(f, kSlope[power][cell]));
        }
        hn::Store(d, f, places.slopesY[cell] + p);
      }
    }
  }
}

/// The potential's own cells, blended in time: u from ∂/∂x, v from ∂/∂y.
HWY_INLINE void PotentialSlopes(const SheetSampling& s, std::size_t corner, const Places& places,
                                std::size_t p, V4& u, V4& v) {
  const Four f;
  const V4 before = hn::Set(f, s.potentialWeights[0]), after = hn::Set(f, s.potentialWeights[1]);
  V4 value = hn::Zero(f), slope = hn::Zero(f);
  for (std::size_t r = 0; r < 4; ++r) {
    const std::size_t at = corner + r * s.stride;
    const V4 row = hn::MulAdd(hn::LoadU(f, s.potentialBefore + at), before,
                              hn::Mul(hn::LoadU(f, s.potentialAfter + at), after));
    value = hn::MulAdd(row, hn::Set(f, places.weightsY[r][p]), value);
    slope = hn::MulAdd(row, hn::Set(f, places.slopesY[r][p]), slope);
  }
  const V4 part = hn::Set(f, places.partX[p]);
  u = hn::Mul(value, Slopes(part));
  v = hn::Mul(slope, Weights(part));
}

/// A sheet at one time and what points of it share.
struct Sheet {
  const SheetSampling& s;
  TimeWeights height, rate, potential;
  PairPolynomial weights, slopes;
  V4 scale;
  explicit HWY_INLINE Sheet(const SheetSampling& sampling)
      : s(sampling),
        height(s.heightBefore, s.heightAfter),
        rate(s.rateBefore, s.rateAfter),
        potential(FromHeight(s, 0).pair, FromHeight(s, 1).pair),
        weights(kCubic, 4),
        slopes(kSlope, 3) {
    const float perCell = static_cast<float>(s.perCell);
    alignas(16) const float scales[4] = {1.0f, perCell, perCell, 1.0f};
    scale = hn::Load(Four(), scales);
  }
  struct FromHeight {
    float pair[2];
    FromHeight(const SheetSampling& s, int which) : pair{s.potentialFromHeight[which], 0.0f} {}
  };
};

template <SheetQuantities kWhat>
HWY_INLINE void AddPoint(const Sheet& sheet, const Places& places, std::size_t p, PointSums& sums) {
  const Four f;
  const SheetSampling& s = sheet.s;
  const std::size_t corner = static_cast<std::size_t>(places.row[p]) * s.stride +
                             static_cast<std::size_t>(places.column[p]);
  const float* const before = s.surfaceBefore + 2 * corner;
  const float* const after = s.surfaceAfter + 2 * corner;
  Rows row = LoadRows(before, after);
  Rows value = Scaled(row, &places.weightsY[0][p]), slope = value;
  if constexpr (kWhat != SheetQuantities::height) slope = Scaled(row, &places.slopesY[0][p]);
  for (std::size_t r = 1; r < 4; ++r) {
    row = LoadRows(before + 2 * r * s.stride, after + 2 * r * s.stride);
    AddScaled(value, row, &places.weightsY[r][p]);
    if constexpr (kWhat != SheetQuantities::height) AddScaled(slope, row, &places.slopesY[r][p]);
  }
  const Cells weightsX = sheet.weights.At<3>(&places.partX[p]);
  const Cells now = At(sheet.height, value);
  if constexpr (kWhat == SheetQuantities::height) {
    // Summed as below: a height is the same bits whatever else is asked.
    const V products = Folded(Times(now, weightsX));
    sums[height] += hn::GetLane(SumsOf(products, products, products, products));
    return;
  } else {
    const Cells slopesX = sheet.slopes.At<2>(&places.partX[p]);
    const V4 all = SumsOf(Folded(Times(now, weightsX)), Folded(Times(now, slopesX)),
                          Folded(Times(At(sheet.height, slope), weightsX)),
                          Folded(Times(At(sheet.rate, value), weightsX)));
    hn::StoreU(hn::MulAdd(all, sheet.scale, hn::LoadU(f, sums.data())), f, sums.data());
    if constexpr (kWhat == SheetQuantities::orbital) {
      V4 u, v;
      PotentialSlopes(s, corner, places, p, u, v);
      u = hn::Add(u, Halved(Folded(Times(At(sheet.potential, value), slopesX))));
      v = hn::Add(v, Halved(Folded(Times(At(sheet.potential, slope), weightsX))));
      alignas(16) const float sum[4] = {hn::GetLane(hn::SumOfLanes(f, u)),
                                        hn::GetLane(hn::SumOfLanes(f, v)), 0.0f, 0.0f};
      const V4 perCell = hn::Set(f, static_cast<float>(s.perCell));
      hn::StoreU(hn::MulAdd(hn::Load(f, sum), perCell, hn::LoadU(f, sums.data() + velocityX)), f,
                 sums.data() + velocityX);
    }
  }
}

template <SheetQuantities kWhat>
HWY_INLINE void AddPoints(const SheetSampling& s, const double* x, const double* y,
                          std::size_t count, bool allInside, PointSums* sums) {
  const Sheet sheet(s);
  Places places;
  for (std::size_t first = 0; first < count; first += kTogether) {
    const std::size_t some = std::min(kTogether, count - first);
    Locate<kWhat != SheetQuantities::height>(s, x + first, y + first, some, allInside, places);
    for (std::size_t p = 0; p < some; ++p) {
      if (places.inside[p]) AddPoint<kWhat>(sheet, places, p, sums[first + p]);
    }
  }
}

}  // namespace

void AddSheetKernel(const SheetSampling& s, SheetQuantities what, const double* x, const double* y,
                    std::size_t count, bool allInside, PointSums* sums) {
  switch (what) {
    case SheetQuantities::height:
      return AddPoints<SheetQuantities::height>(s, x, y, count, allInside, sums);
    case SheetQuantities::surface:
      return AddPoints<SheetQuantities::surface>(s, x, y, count, allInside, sums);
    case SheetQuantities::orbital:
      return AddPoints<SheetQuantities::orbital>(s, x, y, count, allInside, sums);
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
              std::size_t count, bool allInside, PointSums* sums) {
  HWY_DYNAMIC_DISPATCH(AddSheetKernel)(sheet, what, x, y, count, allInside, sums);
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
