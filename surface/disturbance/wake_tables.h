#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace seaway {

/// Wavelengths that a wake window carries, m: nothing below `shortNone`, all between `shortAll` and
/// `longAll`, nothing above `longNone`, smooth steps in log k between. Windows of a cascade share
/// the step between two neighbours, so that their weights add to 1.
struct WavelengthBand {
  double shortNone = 2.0, shortAll = 4.0;
  double longAll = std::numeric_limits<double>::infinity();
  double longNone = std::numeric_limits<double>::infinity();

  /// Part of a wave number k, rad/m, that is carried, [0, 1].
  double weight(double k) const;
};

/// One periodic window of the wake solver. Cells and modes are powers of two, modes ≤ cells; the
/// modes reach down to a wavelength of `wavelengthLimit()`, which `band.shortNone` must not be
/// below.
struct WakeWindowSettings {
  double cellSize = 0.5;                                   ///< m, of the height map that is sampled
  int cells = 512;                                         ///< along each side
  int modes = 256;                                         ///< Fourier modes along each side
  double depth = std::numeric_limits<double>::infinity();  ///< m, > 0
  WavelengthBand band;
  double absorption = 1.0;  ///< rate at which the border takes waves away at the seam, 1/s; 0: none

  double size() const { return cellSize * cells; }  ///< m
  double wavelengthLimit() const { return 2.0 * size() / modes; }
  bool operator==(const WakeWindowSettings&) const;
};

/// Throws InputError for settings outside the ranges above.
void check(const WakeWindowSettings& settings);

/// A window's planes of float, one value a mode: row r holds k_y = 2π m/L with m = r for r <
/// modes/2 and r − modes above (the order of the transform), column c holds m = c − modes/2. Rows
/// have 16 zeros before and after them, so that column `modes` exists and vectors may run over.
struct ModePlane {
  static constexpr std::size_t padding = 16;

  explicit ModePlane(int modes, std::size_t rows)
      : stride(static_cast<std::size_t>(modes) + padding), values(stride * rows + padding) {}

  float* row(std::size_t r) { return values.data() + padding + r * stride; }
  const float* row(std::size_t r) const { return values.data() + padding + r * stride; }

  std::size_t stride;
  std::vector<float> values;
};

/// What the modes of a window have in common for steps of one length; k_y and −k_y share a row.
struct WakeTables {
  WakeTables(const WakeWindowSettings& settings, double dt);

  WakeWindowSettings settings;
  double dt;
  ModePlane halfTurn;            ///< ω dt/2
  ModePlane cosine, sine;        ///< of the half turn
  ModePlane gain;                ///< W ω dt/L², 1/m²: the step's share of a pressure head's Ĥ
  ModePlane share;               ///< W/L², 1/m²: of a pressure head's Ĥ in the mode
  ModePlane omega;               ///< rad/s
  ModePlane gravityOverOmega;    ///< g/ω, m/s; 0 where ω is
  std::vector<float> prefilter;  ///< of the B-spline along one axis, by column
  std::vector<int> begin, end;   ///< columns of each row that carry anything
  std::size_t memoryBytes() const;
};

}  // namespace seaway
