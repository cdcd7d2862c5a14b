#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>

/// The loops of the wake solver over rows of modes (see ModePlane), in vector instructions chosen
/// at run time. Real and imaginary parts lie in planes of their own; all rows are padded by 16
/// floats.
namespace seaway::wake {

/// A complex number for each column.
struct Columns {
  const float* real;
  const float* imaginary;
};

/// One row's share of a step; see WakeWindow::step for the equations.
struct StepRow {
  int begin, end;  ///< columns
  const float *cosine, *sine, *halfTurn, *gain;
  const float *footprintReal, *footprintImaginary;
  Columns place;                           ///< e^(−i k_x x), by column
  Columns drift;                           ///< e^(−i k_x U_x dt/2)
  const float* driftTurn;                  ///< k_x U_x dt/2
  std::complex<float> rowPlace, rowDrift;  ///< the same of k_y
  float rowDriftTurn;
  float *real, *imaginary;  ///< the state, advanced
};
void stepRow(const StepRow& row);

/// Looks up a tabled footprint (FootprintTable::values) for one row turned to a heading.
struct TurnRow {
  int begin, end;
  int centre;  ///< column of k_x = 0
  const float* table;
  std::int32_t alongX, alongY;
  float xFromColumn, xOffset;  ///< k_x in the body frame, in units of the table's spacing
  float yFromColumn, yOffset;  ///< k_y
  float *real, *imaginary;
};
void turnRow(const TurnRow& row);

/// real, imaginary *= row · column, then out = what `taps` (taps[q] for ±q) make of it along the
/// columns. Columns outside [begin, end) of the input count as zero; `scratch` has the row's length
/// plus 32 floats twice.
struct BorderRow {
  int begin, end, columns;
  std::complex<float> rowPhase;
  Columns phase;
  std::span<const float> taps;
  const float *real, *imaginary;
  float *outReal, *outImaginary;
  float* scratch;
};
void borderAlongRow(const BorderRow& row);

/// Combines rows −q … q of the plane made by borderAlongRow (`rows[taps − 1 ± q]`, null: zero),
/// undoes the phase and writes columns [begin, end).
struct BorderColumns {
  int begin, end;
  std::complex<float> rowPhase;
  Columns phase;
  std::span<const float> taps;
  const float* const* realRows;
  const float* const* imaginaryRows;
  float *real, *imaginary;
};
void borderAcrossRows(const BorderColumns& row);

/// One row of the spectra that become the height map, interleaved, each times prefilter and scale:
///   where `surface` is given    η + i η_t = ½[(1 + ω) Z(k) + (1 − ω) conj Z(−k)]
///   where `potential` is given  φ = −(i g/2ω) [Z(k) − conj Z(−k)]
struct OutputRow {
  int begin, end, columns;
  const float *omega, *gravityOverOmega;
  const float* prefilter;  ///< by column
  float scale;             ///< the prefilter of the row
  const float *real, *imaginary;
  const float *mirroredReal, *mirroredImaginary;  ///< row −k_y
  std::complex<float>* surface;                   ///< by column, or null
  std::complex<float>* potential;                 ///< likewise
};
void outputRow(const OutputRow& row);

}  // namespace seaway::wake
