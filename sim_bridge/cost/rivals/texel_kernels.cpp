#include "sim_bridge/cost/rivals/texel_kernels.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim_bridge/cost/rivals/texel_kernels.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"
#include "surface/field/kernels/kernel_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace seaway::rivals {
namespace HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;
namespace math = seaway::HWY_NAMESPACE;

using Four = hn::FixedTag<float, 4>;
using V4 = hn::Vec<Four>;

constexpr std::size_t tilePoints = 256;

/// Texels below the points of a tile and the fractions above them, [0, 1].
struct alignas(64) Places {
  std::uint32_t cell[tilePoints];
  float fraction[tilePoints];
};

void Place(const double* from, std::size_t count, double scale, double offset, Places& places) {
  const math::Floats f;
  const math::Words w;
  const math::Doubles d;
  alignas(64) double padded[tilePoints];
  std::copy(from, from + count, padded);
  std::fill(padded + count, padded + tilePoints, 0.0);
  const auto factor = hn::Set(d, scale), shift = hn::Set(d, offset - 0.5);
  for (std::size_t i = 0; i < count; i += hn::Lanes(f)) {
    const math::DoublePair at = math::LoadPair(padded + i);
    const math::Reduced reduced =
        math::Reduce({hn::MulAdd(at.low, factor, shift), hn::MulAdd(at.high, factor, shift)});
    hn::Store(reduced.cell, w, places.cell + i);
    hn::Store(hn::Add(reduced.rest, hn::Set(f, 0.5f)), f, places.fraction + i);
  }
}

HWY_INLINE V4 Load(const Texel* texel) { return hn::Load(Four(), &texel->height); }

HWY_INLINE V4 Bilinear(const TexelGrid& grid, std::uint32_t i, std::uint32_t j, float u, float v) {
  const Four four;
  const std::uint32_t mask = grid.size - 1;
  const Texel* low = grid.texels + (j & mask) * grid.size;
  const Texel* high = grid.texels + ((j + 1) & mask) * grid.size;
  const std::uint32_t left = i & mask, right = (i + 1) & mask;
  const V4 across = hn::Set(four, u);
  const auto between = [&](const Texel* row) {
    const V4 from = Load(row + left);
    return hn::MulAdd(across, hn::Sub(Load(row + right), from), from);
  };
  const V4 a = between(low);
  return hn::MulAdd(hn::Set(four, v), hn::Sub(between(high), a), a);
}

/// Catmull–Rom weights of the texels at −1, 0, 1, 2.
HWY_INLINE V4 CubicWeights(float fraction) {
  const Four four;
  alignas(16) constexpr float c0[] = {0.0f, 1.0f, 0.0f, 0.0f}, c1[] = {-0.5f, 0.0f, 0.5f, 0.0f},
                              c2[] = {1.0f, -2.5f, 2.0f, -0.5f}, c3[] = {-0.5f, 1.5f, -1.5f, 0.5f};
  const V4 f = hn::Set(four, fraction);
  const V4 high = hn::MulAdd(hn::Load(four, c3), f, hn::Load(four, c2));
  return hn::MulAdd(hn::MulAdd(high, f, hn::Load(four, c1)), f, hn::Load(four, c0));
}

HWY_INLINE V4 CubicRow(const Texel* row, const std::uint32_t (&column)[4], V4 weights) {
  V4 sum = hn::Mul(hn::Broadcast<0>(weights), Load(row + column[0]));
  sum = hn::MulAdd(hn::Broadcast<1>(weights), Load(row + column[1]), sum);
  sum = hn::MulAdd(hn::Broadcast<2>(weights), Load(row + column[2]), sum);
  return hn::MulAdd(hn::Broadcast<3>(weights), Load(row + column[3]), sum);
}

HWY_INLINE V4 Cubic(const TexelGrid& grid, std::uint32_t i, std::uint32_t j, float u, float v) {
  const std::uint32_t mask = grid.size - 1;
  const std::uint32_t column[] = {(i - 1) & mask, i & mask, (i + 1) & mask, (i + 2) & mask};
  const V4 across = CubicWeights(u), along = CubicWeights(v);
  const auto row = [&](std::uint32_t n) {
    return CubicRow(grid.texels + ((j + n) & mask) * grid.size, column, across);
  };
  V4 sum = hn::Mul(hn::Broadcast<0>(along), row(~std::uint32_t{0}));
  sum = hn::MulAdd(hn::Broadcast<1>(along), row(0), sum);
  sum = hn::MulAdd(hn::Broadcast<2>(along), row(1), sum);
  return hn::MulAdd(hn::Broadcast<3>(along), row(2), sum);
}

template <Interpolation kInterpolation, Store kStore>
void LookUp(const TexelGrid& grid, const double* x, const double* y, std::size_t count,
            float weight, Texel* out) {
  const Four four;
  const V4 scale = hn::Set(four, weight);
  Places across, along;
  for (std::size_t first = 0; first < count; first += tilePoints) {
    const std::size_t here = std::min(tilePoints, count - first);
    Place(x + first, here, grid.texelsPerMetre, grid.offsetX, across);
    Place(y + first, here, grid.texelsPerMetre, grid.offsetY, along);
    for (std::size_t p = 0; p < here; ++p) {
      const std::uint32_t i = across.cell[p], j = along.cell[p];
      const float u = across.fraction[p], v = along.fraction[p];
      V4 value;
      if constexpr (kInterpolation == Interpolation::bilinear)
        value = Bilinear(grid, i, j, u, v);
      else
        value = Cubic(grid, i, j, u, v);
      float* to = &out[first + p].height;
      value = hn::Mul(value, scale);
      if constexpr (kStore == Store::add) value = hn::Add(value, hn::Load(four, to));
      hn::Store(value, four, to);
    }
  }
}

void SetBilinear(const TexelGrid& grid, const double* x, const double* y, std::size_t count,
                 float weight, Texel* out) {
  LookUp<Interpolation::bilinear, Store::set>(grid, x, y, count, weight, out);
}
void AddBilinear(const TexelGrid& grid, const double* x, const double* y, std::size_t count,
                 float weight, Texel* out) {
  LookUp<Interpolation::bilinear, Store::add>(grid, x, y, count, weight, out);
}
void SetCubic(const TexelGrid& grid, const double* x, const double* y, std::size_t count,
              float weight, Texel* out) {
  LookUp<Interpolation::cubic, Store::set>(grid, x, y, count, weight, out);
}
void AddCubic(const TexelGrid& grid, const double* x, const double* y, std::size_t count,
              float weight, Texel* out) {
  LookUp<Interpolation::cubic, Store::add>(grid, x, y, count, weight, out);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace seaway::rivals
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace seaway::rivals {

HWY_EXPORT(SetBilinear);
HWY_EXPORT(AddBilinear);
HWY_EXPORT(SetCubic);
HWY_EXPORT(AddCubic);

void lookUp(const TexelGrid& grid, Interpolation interpolation, const double* x, const double* y,
            std::size_t count, float weight, Store store, Texel* out) {
  const bool cubic = interpolation == Interpolation::cubic;
  if (store == Store::set) {
    (cubic ? HWY_DYNAMIC_DISPATCH(SetCubic) : HWY_DYNAMIC_DISPATCH(SetBilinear))(grid, x, y, count,
                                                                                 weight, out);
  } else {
    (cubic ? HWY_DYNAMIC_DISPATCH(AddCubic) : HWY_DYNAMIC_DISPATCH(AddBilinear))(grid, x, y, count,
                                                                                 weight, out);
  }
}

}  // namespace seaway::rivals
#endif
