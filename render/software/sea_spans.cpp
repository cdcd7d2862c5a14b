#include "render/software/sea_spans.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "surface/constants.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/software/sea_spans.cpp"
#include "hwy/foreach_target.h"
#include "render/shading/lanes-inl.h"
#include "render/software/ring_place-inl.h"

#ifndef SEAWAY_SPAN_INPUT
#define SEAWAY_SPAN_INPUT
namespace seaway::render {
struct SpanInput {
  const float* inverse;
  const std::uint32_t* packed;
  const float* missing;        // by row
  const float* missingWakes;   // by vertex; null: none
  const std::uint32_t* cover;  // by vertex; null: none
  const float* rowStart;
  const float* rowStep;
  glm::ivec2 size;
  Projector::GridFromPlane grid;
  std::optional<RingLaw> rings;
  float cameraHeight, pixelAngle;
  bool cameraIsUnderWater;
};
}  // namespace seaway::render
#endif

HWY_BEFORE_NAMESPACE();
namespace seaway::render {
namespace HWY_NAMESPACE {
namespace {

constexpr float perStep = SeaSlopes::steepest / 32767.0f;

/// Rows before some places. Neighbours mostly share one or two: then numbers that belong to rows
/// are picked from three, where gathering them takes several times as long.
struct NearRows {
  VI near;
  int first;    // least of them
  bool areTwo;  // none is beyond first + 1
  hn::Mask<Words> isSecond;
};

HWY_INLINE NearRows nearRows(Real near) {
  const Floats f;
  const Real first = hn::MinOfLanes(f, near.v);
  const Mask beyond = near > first;
  return {toInt(near), static_cast<int>(hn::GetLane(first.v)), !anyOf(near > first + 1.0f),
          hn::RebindMask(Words(), beyond.m)};
}

/// Of numbers by row, those of the rows before and behind.
HWY_INLINE Real2 byRow(const float* from, int rows, const NearRows& at) {
  if (!at.areTwo) {
    return {gather(from, at.near), gather(from, hn::Add(at.near, setInt(1)))};
  }
  const Floats f;
  const auto isSecond = hn::RebindMask(f, at.isSecond);
  const VF middle = hn::Set(f, from[at.first + 1]);
  return {hn::IfThenElse(isSecond, middle, hn::Set(f, from[at.first])),
          hn::IfThenElse(isSecond, hn::Set(f, from[std::min(at.first + 2, rows - 1)]), middle)};
}

/// The quadrilateral of a place in the grid, where it lies in it, and how many columns and rows a
/// metre across and ahead crosses.
struct GridPlace {
  NearRows rows;
  Real left;  // column before it
  Real u, v, columnsPerMetre, rowsPerMetre;
};

HWY_INLINE GridPlace ringedPlace(const SpanInput& in, Real2 relative) {
  const RingPlace place = ringPlace(*in.rings, in.size,
                                    {relative.x - static_cast<float>(in.grid.foot.x),
                                     relative.y - static_cast<float>(in.grid.foot.y)});
  const Real near = min(floor(place.row), in.size.y - 2.0f);
  const Real left = min(floor(place.column), in.size.x - 2.0f);
  return {nearRows(near),    left, place.column - left, place.row - near, place.columnsPerMetre,
          place.rowsPerMetre};
}

HWY_INLINE GridPlace gridPlace(const SpanInput& in, Real2 relative) {
  if (in.rings) return ringedPlace(in, relative);
  const Projector::GridFromPlane& g = in.grid;
  // Doubles become floats as they meet vectors: places lie near enough to the camera.
  const Real offX = relative.x - g.foot.x, offY = relative.y - g.foot.y;
  const Real along = offX * g.azimuth.x + offY * g.azimuth.y;
  const Real across = offX * g.azimuth.y - offY * g.azimuth.x;
  const Real axial = max(along * g.cosine + g.heightSine, 1e-6f);
  const Real perAxial = Real(1.0f) / axial;
  const Real v = ((along * g.sine - g.heightCosine) * perAxial - g.leastY) * g.perY;
  // asinh by its logarithm, odd.
  const Real s = (along - g.back) * g.perScale, size = abs(s);
  const Real root = sqrt(size * size + 1.0f);
  const Real half = exactLog2(size + root) * Real(0.69314718f);
  const Real logarithm = choose(s < 0.0f, -half, half);
  const Real share =
      v * (1.0f - g.logarithmic) + (logarithm - g.first) * (g.perLog * g.logarithmic);
  const float rows = in.size.y - 1.0f, columns = in.size.x - 1.0f;
  // dv/d along = (height/axial)²-like: sine·axial − cosine·(along·sine − heightCosine), a constant.
  const double turn = g.heightSine * g.sine + g.heightCosine * g.cosine;
  const Real slope = perAxial * perAxial * (turn * g.perY * (1.0f - g.logarithmic)) +
                     Real(static_cast<float>(g.perScale * g.perLog * g.logarithmic)) / root;
  const Real row = clamp(share * rows, 0.0f, rows);
  const Real near = min(floor(row), rows - 1.0f);
  const Real between = row - near;
  const NearRows rowsNear = nearRows(near);
  const Real2 starts = byRow(in.rowStart, in.size.y, rowsNear);
  const Real2 steps = byRow(in.rowStep, in.size.y, rowsNear);
  const Real start = mix(starts.x, starts.y, between), step = mix(steps.x, steps.y, between);
  const Real perColumn = Real(1.0f) / step;
  const Real column = clamp((across - start) * perColumn, 0.0f, columns);
  const Real left = min(floor(column), columns - 1.0f);
  return {rowsNear, left, column - left, between, perColumn, slope * rows};
}

HWY_INLINE Real2 slopeOf(VU word) {
  const VI x = hn::ShiftRight<16>(hn::ShiftLeft<16>(hn::BitCast(Ints(), word)));
  const VI y = hn::ShiftRight<16>(hn::BitCast(Ints(), word));
  return Real2(toReal(x), toReal(y)) * Real(perStep);
}

/// Which vertices are at the corners of places' quadrilaterals. Where those lie in two rows and
/// within a vector's width of columns, three rows are loaded and shuffled instead of gathered.
struct Quads {
  NearRows rows;
  VI at;  // first corner, where they are gathered
  bool areNarrow;
  std::size_t first, second, third;  // of the loads' vertices
  VI column;                         // in the loads
};

HWY_INLINE Quads quadsOf(const SpanInput& in, const GridPlace& place) {
  const Floats f;
  const int lanes = static_cast<int>(laneCount());
  Quads q{};
  q.rows = place.rows;
  q.areNarrow = place.rows.areTwo && in.size.x >= lanes;
  if (q.areNarrow) {
    const Real least = hn::MinOfLanes(f, place.left.v);
    const int base = std::min(static_cast<int>(hn::GetLane(least.v)), in.size.x - lanes);
    const Real column = place.left - static_cast<float>(base);
    q.areNarrow = !anyOf(column > static_cast<float>(lanes - 2));
    q.column = toInt(column);
    const std::size_t across = in.size.x;
    q.first = across * place.rows.first + base;
    q.second = q.first + across;
    q.third = place.rows.first + 2 < in.size.y ? q.second + across : q.second;
  }
  if (!q.areNarrow) {
    q.at = hn::Add(hn::Mul(place.rows.near, setInt(in.size.x)), toInt(place.left));
  }
  return q;
}

struct CornerWords {
  VU a, b, c, d;
};

HWY_INLINE CornerWords cornersOf(const std::uint32_t* from, int across, const Quads& q) {
  const Words w;
  const VI one = setInt(1);
  if (!q.areNarrow) {
    const VI beyond = hn::Add(q.at, setInt(across));
    return {gather(from, q.at), gather(from, hn::Add(q.at, one)), gather(from, beyond),
            gather(from, hn::Add(beyond, one))};
  }
  const VU rows[3] = {hn::LoadU(w, from + q.first), hn::LoadU(w, from + q.second),
                      hn::LoadU(w, from + q.third)};
  const auto left = hn::IndicesFromVec(w, q.column);
  const auto right = hn::IndicesFromVec(w, hn::Add(q.column, one));
  const auto pick = [&](int row, decltype(left)& at) HWY_ATTR {
    return hn::IfThenElse(q.rows.isSecond, hn::TableLookupLanes(rows[row + 1], at),
                          hn::TableLookupLanes(rows[row], at));
  };
  return {pick(0, left), pick(0, right), pick(1, left), pick(1, right)};
}

struct Slope {
  Real2 mean;
  Real withinPixel;  // mean square of what changes within a pixel
  Real missing;
  Real3 cover;
};

HWY_INLINE Real3 coverOf(VU word) {
  return Real3(bitField<0, 8>(word), bitField<8, 8>(word), bitField<16, 8>(word)) *
         Real(1.0f / 255.0f);
}

HWY_INLINE Slope slopeAt(const SpanInput& in, const GridPlace& place, Real footprint,
                         Real footprintAhead) {
  const Real u = place.u, v = place.v;
  const Quads quads = quadsOf(in, place);
  const CornerWords packed = cornersOf(in.packed, in.size.x, quads);
  const Real2 a = slopeOf(packed.a), b = slopeOf(packed.b);
  const Real2 c = slopeOf(packed.c), d = slopeOf(packed.d);
  const Real2 low = a + (b - a) * u, high = c + (d - c) * u;
  // Slope that changes within a pixel is roughness to that pixel; as sharp normals it would
  // sparkle. Farther apart than a few cells, differences of neighbours tell no more.
  const Real2 ahead = (high - low) * min(footprintAhead * place.rowsPerMetre, 3.0f);
  const Real2 across =
      ((b - a) + ((d - c) - (b - a)) * v) * min(footprint * place.columnsPerMetre, 3.0f);
  const Real2 missingBeside = byRow(in.missing, in.size.y, place.rows);
  Real missing = mix(missingBeside.x, missingBeside.y, v);
  if (in.missingWakes) {
    const CornerWords words =
        cornersOf(reinterpret_cast<const std::uint32_t*>(in.missingWakes), in.size.x, quads);
    const auto of = [&](VU word) HWY_ATTR { return Real(hn::BitCast(Floats(), word)); };
    missing = missing + mix(mix(of(words.a), of(words.b), u), mix(of(words.c), of(words.d), u), v);
  }
  Real3 cover(0.0f, 0.0f, 0.0f);
  if (in.cover) {
    const CornerWords words = cornersOf(in.cover, in.size.x, quads);
    const VU any = hn::Or(hn::Or(words.a, words.b), hn::Or(words.c, words.d));
    if (!hn::AllTrue(Words(), hn::Eq(any, hn::Zero(Words())))) {
      cover = mix(mix(coverOf(words.a), coverOf(words.b), u),
                  mix(coverOf(words.c), coverOf(words.d), u), v);
    }
  }
  return {low + (high - low) * v,
          min((dot(ahead, ahead) + dot(across, across)) * Real(1.0f / 12.0f), 0.05f), missing,
          cover};
}

void FillSpan(const SpanInput& in, PixelSpan& span) {
  const Floats f;
  const int lanes = static_cast<int>(laneCount());
  span.hasCover = in.cover != nullptr;
  for (int i = 0; i < span.count; i += lanes) {
    const Real inverse = hn::LoadU(f, in.inverse + i);
    const Mask water = inverse > 0.0f;
    const Words w;
    const auto kindOf = [&](ShadedAs kind)
                            HWY_ATTR { return hn::Set(w, static_cast<std::uint32_t>(kind)); };
    auto* kinds = reinterpret_cast<std::uint32_t*>(span.kind + i);
    if (!anyOf(water)) {
      hn::Store(kindOf(ShadedAs::sky), w, kinds);
      hn::Store(hn::Set(f, 1.0f), f, span.axial + i);
      continue;
    }
    const Real axial = choose(water, exactQuotient(1.0f, inverse), 1.0f);
    const Real index = hn::Iota(f, static_cast<float>(i));
    const Real3 ray = Real3(span.firstRay) + Real3(span.rayStep) * index;
    const Real3 relative = ray * axial;
    const Real level = relative.x * relative.x + relative.y * relative.y;
    const Real footprint = axial * Real(in.pixelAngle);
    const Real distance = sqrt(level + relative.z * relative.z);
    const Real grazing = clamp(abs(relative.z) / distance, 0.01f, 1.0f);
    const Slope slope =
        slopeAt(in, gridPlace(in, {relative.x, relative.y}), footprint, footprint / grazing);
    const Real height =
        relative.z + in.cameraHeight + level * static_cast<float>(0.5 / earthMeanRadius);
    // A camera sees the side that it is on: the first hit crosses the surface once.
    const VU kind = kindOf(in.cameraIsUnderWater ? ShadedAs::underside : ShadedAs::water);
    hn::Store(hn::IfThenElse(hn::RebindMask(w, water.m), kind, kindOf(ShadedAs::sky)), w, kinds);
    hn::Store(axial.v, f, span.axial + i);
    hn::Store(slope.mean.x.v, f, span.slopeX + i);
    hn::Store(slope.mean.y.v, f, span.slopeY + i);
    hn::Store((slope.missing + slope.withinPixel).v, f, span.missingSlope + i);
    hn::Store(height.v, f, span.height + i);
    if (!in.cover) continue;
    hn::Store(slope.cover.x.v, f, span.cover[0] + i);
    hn::Store(slope.cover.y.v, f, span.cover[1] + i);
    hn::Store(slope.cover.z.v, f, span.cover[2] + i);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace seaway::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace seaway::render {

HWY_EXPORT(FillSpan);

void SeaSlopes::fill(const SeaGrid& grid, const GridLayout& layout) {
  gridFromPlane_ = layout.fromPlane;
  rings_ = layout.rings;
  size_ = grid.size();
  missing_ = grid.missingSlope().data();
  cover_ = grid.cover().empty() ? nullptr : grid.cover().data();
  missingWakes_ = grid.missingWakes().empty() ? nullptr : grid.missingWakes().data();
  rowStart_.resize(size_.y);
  rowStep_.resize(size_.y);
  const glm::dvec2 right(gridFromPlane_.azimuth.y, -gridFromPlane_.azimuth.x);
  for (int row = 0; row < size_.y; ++row) {
    const GridLayout::Row& line = layout.rows[row];
    rowStart_[row] = static_cast<float>(glm::dot(line.start - gridFromPlane_.foot, right));
    rowStep_[row] = static_cast<float>(glm::dot(line.step, right));
  }
  packed_.resize(grid.vertexCount());
  tbb::parallel_for(0, size_.y, [&](int row) {
    const std::size_t first = static_cast<std::size_t>(row) * size_.x;
    const auto steps = [](float slope) {
      const float kept = std::clamp(slope, -steepest, steepest) * (32767.0f / steepest);
      return static_cast<std::uint32_t>(
          static_cast<std::int32_t>(kept + (kept < 0 ? -0.5f : 0.5f)));
    };
    for (std::size_t i = first; i < first + size_.x; ++i) {
      packed_[i] = (steps(grid.slopeX()[i]) & 0xFFFFu) | steps(grid.slopeY()[i]) << 16;
    }
  });
}

void SeaSlopes::fillSpan(const float* inverse, const Camera& camera, bool cameraIsUnderWater,
                         PixelSpan& span) const {
  const SpanInput input{inverse,
                        packed_.data(),
                        missing_,
                        missingWakes_,
                        cover_,
                        rowStart_.data(),
                        rowStep_.data(),
                        size_,
                        gridFromPlane_,
                        rings_,
                        static_cast<float>(camera.position.z),
                        static_cast<float>(camera.pixelAngle()),
                        cameraIsUnderWater};
  HWY_DYNAMIC_DISPATCH(FillSpan)(input, span);
}

}  // namespace seaway::render
#endif
