#include "surface/disturbance/wake_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "surface/disturbance/wake_kernels.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace seaway::wake {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::ScalableTag<float>;
using V = hn::Vec<Floats>;

struct Complex {
  V re, im;
};

HWY_INLINE Complex Load(const float* re, const float* im) {
  return {hn::LoadU(Floats(), re), hn::LoadU(Floats(), im)};
}
HWY_INLINE Complex Broadcast(std::complex<float> z) {
  return {hn::Set(Floats(), z.real()), hn::Set(Floats(), z.imag())};
}
HWY_INLINE Complex Times(Complex a, Complex b) {
  return {hn::MulSub(a.re, b.re, hn::Mul(a.im, b.im)), hn::MulAdd(a.re, b.im, hn::Mul(a.im, b.re))};
}
HWY_INLINE Complex Conjugate(Complex a) { return {a.re, hn::Neg(a.im)}; }

/// Lanes [first, end) of a vector that starts at `at` are written.
HWY_INLINE void StoreWithin(V value, int at, int end, float* row) {
  const Floats f;
  const int lanes = static_cast<int>(hn::Lanes(f));
  if (at + lanes <= end) return hn::StoreU(value, f, row + at);
  hn::BlendedStore(value, hn::FirstN(f, static_cast<std::size_t>(end - at)), f, row + at);
}

HWY_INLINE V Sinc(V x, V sine) {
  const Floats f;
  const V square = hn::Mul(x, x);
  const V series =
      hn::MulAdd(square, hn::MulAdd(square, hn::Set(f, 1.0f / 120.0f), hn::Set(f, -1.0f / 6.0f)),
                 hn::Set(f, 1.0f));
  const auto small = hn::Lt(square, hn::Set(f, 0.01f));
  return hn::IfThenElse(small, series, hn::Div(sine, hn::IfThenElse(small, hn::Set(f, 1.0f), x)));
}

/// Entry (x, y) of a table of complex numbers for each lane.
HWY_INLINE Complex Gather(const float* table, hn::VFromD<hn::RebindToSigned<Floats>> index) {
  const Floats f;
  const auto twice = hn::Add(index, index);
  return {hn::GatherIndex(f, table, twice), hn::GatherIndex(f, table + 1, twice)};
}
HWY_INLINE Complex Mix(Complex a, Complex b, V part) {
  return {hn::MulAdd(part, hn::Sub(b.re, a.re), a.re), hn::MulAdd(part, hn::Sub(b.im, a.im), a.im)};
}

/// Σ_q taps[q] (left q + right q) around `centre`.
template <class At>
HWY_INLINE V Convolve(std::span<const float> taps, At at) {
  const Floats f;
  V sum = hn::Mul(hn::Set(f, taps[0]), at(0));
  for (int q = 1; q < static_cast<int>(taps.size()); ++q) {
    sum = hn::MulAdd(hn::Set(f, taps[static_cast<std::size_t>(q)]), hn::Add(at(-q), at(q)), sum);
  }
  return sum;
}

}  // namespace

void StepRowKernel(const StepRow& row) {
  const Floats f;
  const int lanes = static_cast<int>(hn::Lanes(f));
  const Complex rowPlace = Broadcast(row.rowPlace), rowDrift = Broadcast(row.rowDrift);
  const V rowTurn = hn::Set(f, row.rowDriftTurn);
  for (int c = row.begin; c < row.end; c += lanes) {
    const Complex half = {hn::LoadU(f, row.cosine + c), hn::Neg(hn::LoadU(f, row.sine + c))};
    const Complex drift = Times(Load(row.drift.real + c, row.drift.imaginary + c), rowDrift);
    // x = (ω − k·U) dt/2; sin x is the imaginary part of e^(iω dt/2) e^(−ik·U dt/2).
    const V sine = hn::MulSub(half.re, drift.im, hn::Mul(half.im, drift.re));
    const V x =
        hn::Sub(hn::LoadU(f, row.halfTurn + c), hn::Add(hn::LoadU(f, row.driftTurn + c), rowTurn));
    const V push = hn::Mul(hn::LoadU(f, row.gain + c), Sinc(x, sine));
    const Complex place = Times(Load(row.place.real + c, row.place.imaginary + c), rowPlace);
    const Complex source = Times(place, Load(row.footprintReal + c, row.footprintImaginary + c));
    Complex z = Times(half, Load(row.real + c, row.imaginary + c));
    z.re = hn::MulAdd(push, source.im, z.re);  // − i · source
    z.im = hn::NegMulAdd(push, source.re, z.im);
    z = Times(half, z);
    StoreWithin(z.re, c, row.end, row.real);
    StoreWithin(z.im, c, row.end, row.imaginary);
  }
}

void TurnRowKernel(const TurnRow& row) {
  const Floats f;
  const hn::RebindToSigned<Floats> n;
  const int lanes = static_cast<int>(hn::Lanes(f));
  const auto stride = hn::Set(n, row.alongX + 1);
  const auto lastX = hn::Set(n, row.alongX - 1), lastY = hn::Set(n, 2 * row.alongY - 1);
  const auto none = hn::Zero(n), one = hn::Set(n, 1);
  const V middle = hn::Set(f, static_cast<float>(row.alongY));
  for (int c = row.begin; c < row.end; c += lanes) {
    const V column =
        hn::Add(hn::ConvertTo(f, hn::Iota(n, 0)), hn::Set(f, static_cast<float>(c - row.centre)));
    V x = hn::MulAdd(column, hn::Set(f, row.xFromColumn), hn::Set(f, row.xOffset));
    V y = hn::MulAdd(column, hn::Set(f, row.yFromColumn), hn::Set(f, row.yOffset));
    // The table holds k_x ≥ 0; the rest is its conjugate.
    const auto mirrored = hn::Lt(x, hn::Zero(f));
    x = hn::Abs(x);
    y = hn::Add(hn::IfThenElse(mirrored, hn::Neg(y), y), middle);
    const auto cellX = hn::Min(hn::Max(hn::ConvertTo(n, hn::Floor(x)), none), lastX);
    const auto cellY = hn::Min(hn::Max(hn::ConvertTo(n, hn::Floor(y)), none), lastY);
    const auto corner = hn::Add(hn::Mul(cellY, stride), cellX);
    const auto above = hn::Add(corner, stride);
    const V partX = hn::Sub(x, hn::ConvertTo(f, cellX)),
            partY = hn::Sub(y, hn::ConvertTo(f, cellY));
    const Complex value =
        Mix(Mix(Gather(row.table, corner), Gather(row.table, hn::Add(corner, one)), partX),
            Mix(Gather(row.table, above), Gather(row.table, hn::Add(above, one)), partX), partY);
    StoreWithin(value.re, c, row.end, row.real);
    StoreWithin(hn::IfThenElse(mirrored, hn::Neg(value.im), value.im), c, row.end, row.imaginary);
  }
}

void BorderAlongRowKernel(const BorderRow& row) {
  const Floats f;
  const int lanes = static_cast<int>(hn::Lanes(f));
  const int length = row.columns + 2 * 16;
  float* const re = row.scratch + 16;
  float* const im = row.scratch + length + 16;
  for (float* part : {re, im}) {
    for (int c = -16; c < row.columns + 16; ++c) part[c] = 0.0f;
  }
  const Complex rowPhase = Broadcast(row.rowPhase);
  for (int c = row.begin; c < row.end; c += lanes) {
    const Complex phase = Times(Load(row.phase.real + c, row.phase.imaginary + c), rowPhase);
    const Complex z = Times(phase, Load(row.real + c, row.imaginary + c));
    StoreWithin(z.re, c, row.end, re);
    StoreWithin(z.im, c, row.end, im);
  }
  for (int c = 0; c < row.columns; c += lanes) {
    hn::StoreU(Convolve(row.taps, [&](int q) HWY_ATTR { return hn::LoadU(f, re + c + q); }), f,
               row.outReal + c);
    hn::StoreU(Convolve(row.taps, [&](int q) HWY_ATTR { return hn::LoadU(f, im + c + q); }), f,
               row.outImaginary + c);
  }
}

void BorderAcrossRowsKernel(const BorderColumns& row) {
  const Floats f;
  const int lanes = static_cast<int>(hn::Lanes(f));
  const int reach = static_cast<int>(row.taps.size()) - 1;
  const Complex rowPhase = Broadcast(row.rowPhase);
  for (int c = row.begin; c < row.end; c += lanes) {
    const auto at = [&](const float* const* rows) HWY_ATTR {
      return [rows, reach, c](int q) HWY_ATTR {
        const float* const from = rows[reach + q];
        return from ? hn::LoadU(Floats(), from + c) : hn::Zero(Floats());
      };
    };
    const Complex z{Convolve(row.taps, at(row.realRows)),
                    Convolve(row.taps, at(row.imaginaryRows))};
    const Complex phase = Times(Load(row.phase.real + c, row.phase.imaginary + c), rowPhase);
    const Complex result = Times(Conjugate(phase), z);
    StoreWithin(result.re, c, row.end, row.real);
    StoreWithin(result.im, c, row.end, row.imaginary);
  }
}

void OutputRowKernel(const OutputRow& row) {
  const Floats f;
  const int lanes = static_cast<int>(hn::Lanes(f));
  const V one = hn::Set(f, 1.0f);
  float* const surface = reinterpret_cast<float*>(row.surface);
  float* const potential = reinterpret_cast<float*>(row.potential);
  // The last vector may pass `end` by less than its length; rows are padded, and columns there
  // carry zeros.
  for (int c = row.begin; c < row.end; c += lanes) {
    const Complex z = Load(row.real + c, row.imaginary + c);
    const int mirror = row.columns - c - (lanes - 1);
    const Complex m = {hn::Reverse(f, hn::LoadU(f, row.mirroredReal + mirror)),
                       hn::Neg(hn::Reverse(f, hn::LoadU(f, row.mirroredImaginary + mirror)))};
    const V omega = hn::LoadU(f, row.omega + c);
    const V scale = hn::Mul(hn::LoadU(f, row.prefilter + c), hn::Set(f, 0.5f * row.scale));
    if (surface) {
      const V plus = hn::Mul(scale, hn::Add(one, omega));
      const V minus = hn::Mul(scale, hn::Sub(one, omega));
      hn::StoreInterleaved2(hn::MulAdd(plus, z.re, hn::Mul(minus, m.re)),
                            hn::MulAdd(plus, z.im, hn::Mul(minus, m.im)), f, surface + 2 * c);
    }
    if (!potential) continue;
    const V factor = hn::Mul(scale, hn::LoadU(f, row.gravityOverOmega + c));
    hn::StoreInterleaved2(hn::Mul(factor, hn::Sub(z.im, m.im)),
                          hn::Mul(factor, hn::Sub(m.re, z.re)), f, potential + 2 * c);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace seaway::wake
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace seaway::wake {

HWY_EXPORT(StepRowKernel);
HWY_EXPORT(TurnRowKernel);
HWY_EXPORT(BorderAlongRowKernel);
HWY_EXPORT(BorderAcrossRowsKernel);
HWY_EXPORT(OutputRowKernel);

void stepRow(const StepRow& row) { HWY_DYNAMIC_DISPATCH(StepRowKernel)(row); }
void turnRow(const TurnRow& row) { HWY_DYNAMIC_DISPATCH(TurnRowKernel)(row); }
void borderAlongRow(const BorderRow& row) { HWY_DYNAMIC_DISPATCH(BorderAlongRowKernel)(row); }
void borderAcrossRows(const BorderColumns& row) {
  HWY_DYNAMIC_DISPATCH(BorderAcrossRowsKernel)(row);
}
void outputRow(const OutputRow& row) { HWY_DYNAMIC_DISPATCH(OutputRowKernel)(row); }

}  // namespace seaway::wake
#endif  // HWY_ONCE
