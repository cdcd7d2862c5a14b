#include "surface/disturbance/wake_output.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstring>
#include <vector>

#include "surface/disturbance/wake_kernels.h"
#include "surface/fft/aligned_vector.h"

namespace seaway::wake {
namespace {

using Value = std::complex<float>;
constexpr std::size_t together = ComplexFft::together;

/// Buffers of a transform; a thread keeps its own, so that a step allocates nothing.
struct Scratch {
  AlignedVector<Value> surface, potential;  // spectra: a row of the plane each
  AlignedVector<Value> columns;             // transformed along y: cells rows
  AlignedVector<Value> side;                // columns side by side
  AlignedVector<Value> line;                // one row
};
Scratch& scratch() {
  thread_local Scratch buffers;
  return buffers;
}

std::size_t sizeOf(int count) { return static_cast<std::size_t>(count); }

/// From row to row of the columns: off the powers of two, at which rows would crowd the same lines
/// of the cache.
std::size_t columnStride(const WakeWindowSettings& s) { return sizeOf(s.modes) + 8; }

/// Transforms columns [first, modes) of the spectrum along y, into `columns` (cells rows).
void transformColumns(const WakeWindowSettings& s, const AlignedVector<Value>& spectrum,
                      std::size_t first, const ComplexFft& fft, Scratch& buffers) {
  const std::size_t modes = sizeOf(s.modes), cells = sizeOf(s.cells), half = modes / 2;
  const std::size_t stride = modes + ModePlane::padding;
  const std::size_t out = columnStride(s);
  buffers.columns.resize(cells * out);
  buffers.side.resize(cells * together);
  Value* const side = buffers.side.data();
  for (std::size_t c = first; c < modes; c += together) {
    for (std::size_t r = 0; r < half; ++r) {
      std::copy_n(&spectrum[r * stride + c], together, side + r * together);
    }
    std::fill(side + half * together, side + (cells - half) * together, Value());
    for (std::size_t r = half; r < modes; ++r) {
      std::copy_n(&spectrum[r * stride + c], together, side + (cells - modes + r) * together);
    }
    fft.inverseTogether(side);
    for (std::size_t y = 0; y < cells; ++y) {
      std::copy_n(side + y * together, together, &buffers.columns[y * out + c]);
    }
  }
}

/// Transforms row `y` of the columns along x into the line.
void transformRow(const WakeWindowSettings& s, std::size_t y, const ComplexFft& fft,
                  Scratch& buffers) {
  const std::size_t modes = sizeOf(s.modes), cells = sizeOf(s.cells), half = modes / 2;
  const Value* const from = &buffers.columns[y * columnStride(s)];
  Value* const line = buffers.line.data();
  std::copy_n(from + half, half, line);
  std::fill(line + half, line + cells - half, Value());
  std::copy_n(from, half, line + cells - half);
  fft.inverse(line);
}

/// Writes a row of cells of `width` floats with its repeats, and the rows that repeat it.
void storeRow(const float* values, std::size_t y, std::size_t width, const WakeGrid& grid,
              std::vector<float>& out) {
  const std::size_t cells = sizeOf(grid.cells);
  float* const row = out.data() + (y + 1) * grid.stride * width;
  std::copy_n(values, cells * width, row + width);
  std::copy_n(values + (cells - 1) * width, width, row);
  std::copy_n(values, 2 * width, row + (cells + 1) * width);
  const std::size_t length = (cells + 3) * width;
  if (y == cells - 1) std::copy_n(row, length, out.data());
  if (y < 2) std::copy_n(row, length, out.data() + (y + 1 + cells) * grid.stride * width);
}

void combine(const WakeTables& tables, const ModeState& state, AlignedVector<Value>* surface,
             AlignedVector<Value>* potential) {
  const int modes = tables.settings.modes, half = modes / 2;
  const std::size_t stride = sizeOf(modes) + ModePlane::padding;
  for (AlignedVector<Value>* spectrum : {surface, potential}) {
    if (spectrum) spectrum->assign(stride * sizeOf(modes), Value());
  }
  for (int my = 1 - half; my < half; ++my) {
    const std::size_t shared = sizeOf(std::abs(my));
    const std::size_t row = sizeOf(my >= 0 ? my : my + modes);
    const std::size_t mirror = sizeOf(my > 0 ? modes - my : -my);
    outputRow({tables.begin[shared], tables.end[shared], modes, tables.omega.row(shared),
               tables.gravityOverOmega.row(shared), tables.prefilter.data(),
               tables.prefilter[sizeOf(my + half)], state.real.row(row), state.imaginary.row(row),
               state.real.row(mirror), state.imaginary.row(mirror),
               surface ? &(*surface)[row * stride] : nullptr,
               potential ? &(*potential)[row * stride] : nullptr});
  }
}

/// Largest absolute value of the even and of the odd floats of a row.
void noteLargest(const float* values, std::size_t cells, WakeGrid& out) {
  float even[8] = {}, odd[8] = {};
  for (std::size_t i = 0; i < cells; i += 8) {
    for (std::size_t l = 0; l < 8; ++l) {
      even[l] = std::max(even[l], std::abs(values[2 * (i + l)]));
      odd[l] = std::max(odd[l], std::abs(values[2 * (i + l) + 1]));
    }
  }
  out.largestHeight = std::max(out.largestHeight, *std::max_element(even, even + 8));
  out.largestRate = std::max(out.largestRate, *std::max_element(odd, odd + 8));
}

/// Two rows of real values from one complex transform: a + ib, from the halves of their spectra.
void transformRealRows(const WakeWindowSettings& s, std::size_t y, const ComplexFft& fft,
                       Scratch& buffers) {
  const std::size_t cells = sizeOf(s.cells), half = sizeOf(s.modes) / 2;
  const Value* const a = &buffers.columns[y * columnStride(s) + half];
  const Value* const b = a + columnStride(s);
  Value* const line = buffers.line.data();
  std::fill(line + half, line + cells - half + 1, Value());
  line[0] = {a[0].real(), b[0].real()};
  for (std::size_t m = 1; m < half; ++m) {
    line[m] = {a[m].real() - b[m].imag(), a[m].imag() + b[m].real()};
    line[cells - m] = {a[m].real() + b[m].imag(), b[m].real() - a[m].imag()};
  }
  fft.inverse(line);
}

}  // namespace

void drawGrid(const WakeTables& tables, const ModeState& surface, const ModeState& motion,
              const ComplexFft& fft, WakeGrid& out) {
  const WakeWindowSettings& s = tables.settings;
  const std::size_t cells = sizeOf(s.cells);
  const bool potential = !out.potential.empty();
  Scratch& buffers = scratch();
  buffers.line.resize(cells + 1);
  combine(tables, surface, &buffers.surface, nullptr);
  if (potential) combine(tables, motion, nullptr, &buffers.potential);

  transformColumns(s, buffers.surface, 0, fft, buffers);
  out.largestHeight = out.largestRate = 0.0f;
  for (std::size_t y = 0; y < cells; ++y) {
    transformRow(s, y, fft, buffers);
    const float* const values = reinterpret_cast<const float*>(buffers.line.data());
    noteLargest(values, cells, out);
    storeRow(values, y, 2, out, out.surface);
  }
  if (!potential) return;
  transformColumns(s, buffers.potential, sizeOf(s.modes) / 2, fft, buffers);
  std::vector<float>& first = out.potential;
  thread_local std::vector<float> rows;
  rows.resize(2 * cells);
  for (std::size_t y = 0; y < cells; y += 2) {
    transformRealRows(s, y, fft, buffers);
    for (std::size_t i = 0; i < cells; ++i) {
      rows[i] = buffers.line[i].real();
      rows[cells + i] = buffers.line[i].imag();
    }
    storeRow(rows.data(), y, 1, out, first);
    storeRow(rows.data() + cells, y + 1, 1, out, first);
  }
}

std::vector<float> envelope(const WakeTables& tables, const ModePlane& real,
                            const ModePlane& imaginary, const ComplexFft& fft) {
  const WakeWindowSettings& s = tables.settings;
  const std::size_t cells = sizeOf(s.cells), modes = sizeOf(s.modes);
  const std::size_t stride = modes + ModePlane::padding;
  Scratch& buffers = scratch();
  buffers.line.resize(cells + 1);
  buffers.surface.assign(stride * modes, Value());
  for (std::size_t r = 0; r < modes; ++r) {
    for (std::size_t c = 0; c < modes; ++c) {
      buffers.surface[r * stride + c] = {real.row(r)[c], imaginary.row(r)[c]};
    }
  }
  transformColumns(s, buffers.surface, 0, fft, buffers);
  std::vector<float> result;
  result.reserve(cells * cells);
  for (std::size_t y = 0; y < cells; ++y) {
    transformRow(s, y, fft, buffers);
    for (std::size_t x = 0; x < cells; ++x) result.push_back(std::abs(buffers.line[x]));
  }
  return result;
}

}  // namespace seaway::wake
