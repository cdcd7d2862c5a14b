#pragma once

#include <vector>

#include "surface/disturbance/wake_grid.h"
#include "surface/disturbance/wake_tables.h"
#include "surface/fft/complex_fft.h"

namespace seaway::wake {

/// Ẑ of all modes.
struct ModeState {
  const ModePlane &real, &imaginary;
};

/// Turns a window's state into spline coefficients: η and ∂η/∂t in one complex transform, the
/// potential (where `out` has one) two rows at a time in half of another. Zero columns are not
/// transformed. η and ∂η/∂t are those of `surface`, the potential that of `motion`.
void drawGrid(const WakeTables& tables, const ModeState& surface, const ModeState& motion,
              const ComplexFft& fft, WakeGrid& out);

/// |Z| on the grid's cells, row by row, cells² values: for waves that all travel to one side, their
/// envelope, m.
std::vector<float> envelope(const WakeTables& tables, const ModePlane& real,
                            const ModePlane& imaginary, const ComplexFft& fft);

}  // namespace seaway::wake
