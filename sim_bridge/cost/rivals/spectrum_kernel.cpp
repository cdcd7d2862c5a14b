#include "sim_bridge/cost/rivals/spectrum_kernel.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sim_bridge/cost/rivals/spectrum_kernel.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"
#include "surface/field/kernels/kernel_math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace seaway::rivals {
namespace HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;
namespace math = seaway::HWY_NAMESPACE;

HWY_INLINE void StorePair(math::VF real, math::VF imaginary, std::size_t wanted, float* out) {
  const math::Floats f;
  if (wanted == hn::Lanes(f)) {
    hn::StoreInterleaved2(real, imaginary, f, out);
    return;
  }
  alignas(64) float both[2 * hn::MaxLanes(f)];
  hn::StoreInterleaved2(real, imaginary, f, both);
  std::copy_n(both, 2 * wanted, out);
}

void Advance(const TileSpectrum& s, double t, std::size_t count, float* out) {
  const math::Floats f;
  const math::Doubles d;
  const auto time = hn::Set(d, t);
  const auto twoPi = hn::Set(f, 6.28318531f);
  const std::size_t lanes = hn::Lanes(f), half = hn::Lanes(d);
  for (std::size_t i = 0; i < count; i += lanes) {
    const auto low = hn::LoadU(d, s.turnsPerSecond.data() + i);
    const auto high = hn::LoadU(d, s.turnsPerSecond.data() + i + half);
    const auto omega = hn::Mul(twoPi, hn::Combine(f, hn::DemoteTo(hn::Half<math::Floats>(), high),
                                                  hn::DemoteTo(hn::Half<math::Floats>(), low)));
    const math::SinCos w =
        math::SinCosTurns(math::Reduce({hn::Mul(low, time), hn::Mul(high, time)}).rest);
    const auto pr = hn::LoadU(f, s.pReal.data() + i), pi = hn::LoadU(f, s.pImaginary.data() + i);
    const auto mr = hn::LoadU(f, s.mReal.data() + i), mi = hn::LoadU(f, s.mImaginary.data() + i);
    // p e^(−iωt) and m e^(iωt)
    const auto ar = hn::MulAdd(pr, w.cosine, hn::Mul(pi, w.sine));
    const auto ai = hn::NegMulAdd(pr, w.sine, hn::Mul(pi, w.cosine));
    const auto br = hn::NegMulAdd(mi, w.sine, hn::Mul(mr, w.cosine));
    const auto bi = hn::MulAdd(mr, w.sine, hn::Mul(mi, w.cosine));
    const auto real = hn::Add(ar, br), imaginary = hn::Add(ai, bi);
    const auto kx = hn::LoadU(f, s.kx.data() + i), ky = hn::LoadU(f, s.ky.data() + i);
    const std::size_t wanted = std::min(lanes, count - i);
    float* to = out + 2 * i;
    StorePair(real, imaginary, wanted, to);
    StorePair(hn::Neg(hn::Mul(kx, imaginary)), hn::Mul(kx, real), wanted, to + 2 * count);
    StorePair(hn::Neg(hn::Mul(ky, imaginary)), hn::Mul(ky, real), wanted, to + 4 * count);
    StorePair(hn::Mul(omega, hn::Sub(ai, bi)), hn::Mul(omega, hn::Sub(br, ar)), wanted,
              to + 6 * count);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace seaway::rivals
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace seaway::rivals {

HWY_EXPORT(Advance);

void advanceSpectrum(const TileSpectrum& spectrum, double t, std::size_t count, float* out) {
  HWY_DYNAMIC_DISPATCH(Advance)(spectrum, t, count, out);
}

}  // namespace seaway::rivals
#endif
