#pragma once

#include <cstdint>
#include <vector>

#include "sim_bridge/cost/rivals/cached_octaves.h"
#include "sim_bridge/cost/rivals/fft_tile.h"
#include "sim_bridge/cost/rivals/seas.h"
#include "sim_bridge/cost/rivals/sine_sum.h"
#include "surface/field/wave_field.h"

/// The things that are measured, each built once, when first asked for, at time `benchTime`.
namespace seaway::bench {

using namespace rivals;

inline constexpr double benchTime = 12.3;  ///< s
inline constexpr int benchOctaves = 12;
inline constexpr JonswapParameters benchSea{1.12, 5.6, 3.3};

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

/// A field, and the same at `benchTime`.
struct PreparedField {
  explicit PreparedField(std::vector<Octave> octaves);
  WaveField field;
  FieldAtTime now;
};
const PreparedField& preparedField(OctaveKind kind);

const SineSum& sineSum(int components);
inline constexpr double tileLength = 256.0;  ///< m, of the tile of 256² nodes
FftTile& fftTile(std::uint32_t size);        ///< nodes 1 m apart
CachedOctaves& cachedOctaves();

}  // namespace seaway::bench
