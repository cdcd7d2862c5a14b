#include "sim_bridge/cost/rivals/sine_kernel.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim_bridge/cost/rivals/sine_kernel.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"
#include "surface/field/kernels/kernel_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace seaway::rivals {
namespace HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;
namespace math = seaway::HWY_NAMESPACE;

constexpr std::size_t tilePoints = 256;

struct alignas(64) SineTile {
  double x[tilePoints], y[tilePoints];
  float height[tilePoints], slopeX[tilePoints], slopeY[tilePoints], rate[tilePoints];
};

void SumTile(const SineSum::Prepared& c, std::size_t count, SineTile& tile) {
  const math::Floats f;
  for (std::size_t p = 0; p < count; p += hn::Lanes(f)) {
    const math::DoublePair x = math::LoadPair(tile.x + p), y = math::LoadPair(tile.y + p);
    auto height = hn::Zero(f), slopeX = hn::Zero(f), slopeY = hn::Zero(f), rate = hn::Zero(f);
    for (std::size_t i = 0; i < c.turns.size(); ++i) {
      const math::DoublePair turns =
          math::Linear(math::SetPair(c.turnsPerMetreX[i]), x, math::SetPair(c.turnsPerMetreY[i]), y,
                       math::SetPair(c.turns[i]));
      const math::SinCos wave = math::SinCosTurns(math::Reduce(turns).rest);
      height = hn::MulAdd(hn::Set(f, c.height[i]), wave.cosine, height);
      slopeX = hn::MulAdd(hn::Set(f, c.slopeX[i]), wave.sine, slopeX);
      slopeY = hn::MulAdd(hn::Set(f, c.slopeY[i]), wave.sine, slopeY);
      rate = hn::MulAdd(hn::Set(f, c.rate[i]), wave.sine, rate);
    }
    hn::Store(height, f, tile.height + p);
    hn::Store(slopeX, f, tile.slopeX + p);
    hn::Store(slopeY, f, tile.slopeY + p);
    hn::Store(rate, f, tile.rate + p);
  }
}

void SumSines(const SineSum::Prepared& components, std::span<const double> x,
              std::span<const double> y, const FieldAtTime::Arrays& out) {
  SineTile tile{};
  for (std::size_t first = 0; first < x.size(); first += tilePoints) {
    const std::size_t here = std::min(tilePoints, x.size() - first);
    std::copy_n(x.begin() + first, here, tile.x);
    std::copy_n(y.begin() + first, here, tile.y);
    SumTile(components, here, tile);
    std::copy_n(tile.height, here, out.height.begin() + first);
    std::copy_n(tile.slopeX, here, out.slopeX.begin() + first);
    std::copy_n(tile.slopeY, here, out.slopeY.begin() + first);
    std::copy_n(tile.rate, here, out.rate.begin() + first);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace seaway::rivals
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace seaway::rivals {

HWY_EXPORT(SumSines);

void sumSines(const SineSum::Prepared& components, std::span<const double> x,
              std::span<const double> y, const FieldAtTime::Arrays& out) {
  HWY_DYNAMIC_DISPATCH(SumSines)(components, x, y, out);
}

}  // namespace seaway::rivals
#endif
