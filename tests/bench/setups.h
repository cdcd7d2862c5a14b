#pragma once

#include <cstdint>
#include <vector>

#include "surface/field/wave_field.h"
#include "tests/bench/rivals/cached_octaves.h"
#include "tests/bench/rivals/fft_tile.h"
#include "tests/bench/rivals/seas.h"
#include "tests/bench/rivals/sine_sum.h"

/// The things that are measured, each built once, when first asked for, at time `benchTime`.
namespace seaway::bench {

inline constexpr double benchTime = 12.3;  ///< s
inline constexpr int benchOctaves = 12;

/// Random points within 10 km of the anchor.
struct BenchPoints {
  explicit BenchPoints(std::size_t count);
  std::vector<double> x, y;
  std::vector<glm::dvec2> points;
};

/// Room for answers in the field's cheapest form.
struct BenchArrays {
  explicit BenchArrays(std::size_t count)
      : height(count), slopeX(count), slopeY(count), rate(count) {}
  FieldAtTime::Arrays arrays() { return {height, slopeX, slopeY, rate}; }
  std::vector<float> height, slopeX, slopeY, rate;
};

/// A field, the same at `benchTime`, and the spectral residual of its octaves.
struct PreparedField {
  PreparedField(std::vector<Octave> octaves, double spectralResidual);
  WaveField field;
  FieldAtTime now;
  double residual;
};
const PreparedField& preparedField(OctaveKind kind);

const SineSum& sineSum(int components);
inline constexpr double tileLength = 256.0;  ///< m, of the tile of 256² nodes
FftTile& fftTile(std::uint32_t size);        ///< nodes 1 m apart
CachedOctaves& cachedOctaves();
double cachedResidual();

}  // namespace seaway::bench
