#pragma once

#include <complex>
#include <glm/vec2.hpp>
#include <memory>
#include <vector>

#include "surface/disturbance/footprint_table.h"
#include "surface/disturbance/wake_grid.h"
#include "surface/disturbance/wake_tables.h"
#include "surface/fft/complex_fft.h"

namespace seaway {

/// Where a hull presses on the water.
struct HullPlace {
  glm::dvec2 position{0.0};  ///< m, in the water's frame: the sea plane less the current's drift
  double heading = 0.0;      ///< direction of the bow, rad counter-clockwise from east
  double immersion = 1.0;    ///< part of the hull's depth that presses, ≥ 0
  bool operator==(const HullPlace&) const = default;
};

/// Linear water waves that one hull makes, on a periodic window, exactly in time: the complex field
/// Z = η + i(ω/g)φ in Fourier space, ω² = g k tanh kd.
///
///   Ẑ(t + dt) = e^(−iω dt) Ẑ(t) + F,
///   F = −iω dt Ĥ(k) L⁻² e^(−iω dt/2) e^(−ik·x) sinc((ω − k·U) dt/2)
///
/// for a hull that moves straight at U through x within the step; exact for any dt, and no mode
/// ever gains energy by itself. The grid is fixed in the world modulo its size, so that nothing
/// moves when the window follows its vessel: only the seam does, where the border absorbs.
///
/// Float; energy drifts by less than 5e-5 over 10 000 steps, the transverse wavelength of a wake is
/// within 0.5 % of 2πU²/g (tests/surface/disturbance/wake_window_test.cpp, wake_physics_test.cpp).
/// One thread at a time.
class WakeWindow {
 public:
  /// Throws InputError for settings that cannot be. `tables` may be shared between windows of the
  /// same settings.
  WakeWindow(std::shared_ptr<const WakeTables> tables, std::shared_ptr<const FootprintTable> hull);

  const WakeWindowSettings& settings() const { return tables_->settings; }

  /// The largest wave number that a footprint table for such a window is asked for, rad/m.
  static double largestWaveNumber(const WakeWindowSettings& settings);

  /// Still water with the hull at rest at `place`.
  void settle(const HullPlace& place);

  /// One step of dt > 0 s, the hull moving straight from `from` to `to`. A dt other than the
  /// tables' makes tables of its own.
  void step(double dt, const HullPlace& from, const HullPlace& to);

  /// Absorbs waves for `seconds` at the border of the window about `centre` (m): the field is
  /// multiplied by m(x) m(y), m = 1 − a cos²⁴(π(x − x_seam)/L), a = 1 − e^(−absorption · seconds).
  void absorb(glm::dvec2 centre, double seconds);

  /// The surface as spline coefficients. `out` has the settings' cells.
  void draw(WakeGrid& out) const;

  /// The same with the hollow under the hull filled, as far as the window's waves can tell: the
  /// surface that others meet, for a hull at `place` that moves at `velocity` m/s with the heading
  /// of the last step. A hull at rest leaves still water.
  void drawFilled(const HullPlace& place, glm::dvec2 velocity, WakeGrid& out) const;

  /// |Z| at the cells, rows from the south, m: the envelope of waves that all travel to one side.
  std::vector<float> envelope() const;

  /// ∫∫ (|Z + H|²) dx dy, m⁴: twice the waves' energy over ρg, without the hollow under a hull at
  /// rest at `place`.
  double waveEnergy(const HullPlace& place);

  /// Σ|Ẑ|², m²: with the hollow.
  double energy() const;

  /// Mean wave number, weighted by energy, rad/m; 0 for still water.
  double meanWaveNumber() const;

  /// Force on the hull against its heading, N: ρg∫∫ H ∂η/∂x dA, x ahead, with the hull at `place`.
  /// The wave resistance where the wake is steady.
  double waveResistance(const HullPlace& place);

  /// Ẑ of mode (m_x, m_y), |m| < modes/2, m.
  std::complex<float> mode(int mx, int my) const;

  std::size_t memoryBytes() const;

  /// Writes or reads the state: see surface/state_archive.h.
  template <class Archive>
  void archive(Archive& archive);

 private:
  struct AxisPhases;
  void turnFootprint(const HullPlace& place);
  std::size_t rowOf(int my) const;
  template <class Visit>
  void forEachMode(Visit visit) const;

  std::shared_ptr<const WakeTables> tables_;
  std::shared_ptr<const FootprintTable> hull_;
  ModePlane real_, imaginary_;                    // Ẑ
  ModePlane footprintReal_, footprintImaginary_;  // Ĥ at footprintHeading_, per immersion
  double footprintHeading_;
  ComplexFft fft_;
};

}  // namespace seaway
