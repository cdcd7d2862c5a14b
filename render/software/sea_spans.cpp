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

/// The quadrilateral of a place in the grid, where it lies in it, and how many columns and rows a
/// metre across and ahead crosses.
struct GridPlace {
  VI near;  // row before it
  VI left;  // column before it
  Real u, v, columnsPerMetre, rowsPerMetre;
};

HWY_INLINE GridPlace ringedPlace(const SpanInput& in, Real2 relative) {
  const RingPlace place = ringPlace(*in.rings, in.size,
                                    {relative.x - static_cast<float>(in.grid.foot.x),
                                     relative.y - static_cast<float>(in.grid.foot.y)});
  const Real near = min(floor(place.row), in.size.y - 2.0f);
  const Real left = min(floor(place.column), in.size.x - 2.0f);
  return {toInt(near),           toInt(left),          place.column - left,
          place.row - near,      place.columnsPerMetre, place.rowsPerMetre};
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
  const VI nearIndex = toInt(near), farIndex = hn::Add(nearIndex, setInt(1));
  const Real start = mix(gather(in.rowStart, nearIndex), gather(in.rowStart, farIndex), between);
  const Real step = mix(gather(in.rowStep, nearIndex), gather(in.rowStep, farIndex), between);
  const Real perColumn = Real(1.0f) / step;
  const Real column = clamp((across - start) * perColumn, 0.0f, columns);
  const Real left = min(floor(column), columns - 1.0f);
  return {nearIndex, toInt(left), column - left, between, perColumn, slope * rows};
}

HWY_INLINE Real2 slopeOf(VU word) {
  const VI x = hn::ShiftRight<16>(hn::ShiftLeft<16>(hn::BitCast(Ints(), word)));
  const VI y = hn::ShiftRight<16>(hn::BitCast(Ints(), word));
  return Real2(toReal(x), toReal(y)) * Real(perStep);
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
  const VI at = hn::Add(hn::Mul(place.near, setInt(in.size.x)), place.left);
  const VI beyond = hn::Add(at, setInt(in.size.x)), one = setInt(1);
  const Real2 a = slopeOf(gather(in.packed, at)), b = slopeOf(gather(in.packed, hn::Add(at, one)));
  const Real2 c = slopeOf(gather(in.packed, beyond));
  const Real2 d = slopeOf(gather(in.packed, hn::Add(beyond, one)));
  const Real2 low = a + (b - a) * u, high = c + (d - c) * u;
  // Slope that changes within a pixel is roughness to that pixel; as sharp normals it would
  // sparkle. Farther apart than a few cells, differences of neighbours tell no more.
  const Real2 ahead = (high - low) * min(footprintAhead * place.rowsPerMetre, 3.0f);
  const Real2 across =
      ((b - a) + ((d - c) - (b - a)) * v) * min(footprint * place.columnsPerMetre, 3.0f);
  const Real missingNear = gather(in.missing, place.near);
  const Real missingFar = gather(in.missing, hn::Add(place.near, one));
  Real missing = mix(missingNear, missingFar, v);
  if (in.missingWakes) {
    const Real nearer =
        mix(gather(in.missingWakes, at), gather(in.missingWakes, hn::Add(at, one)), u);
    const Real farther =
        mix(gather(in.missingWakes, beyond), gather(in.missingWakes, hn::Add(beyond, one)), u);
    missing = missing + mix(nearer, farther, v);
  }
  Real3 cover(0.0f, 0.0f, 0.0f);
  if (in.cover) {
    const auto of = [&](VI index) HWY_ATTR { return coverOf(gather(in.cover, index)); };
    cover = mix(mix(of(at), of(hn::Add(at, one)), u),
                mix(of(beyond), of(hn::Add(beyond, one)), u), v);
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
