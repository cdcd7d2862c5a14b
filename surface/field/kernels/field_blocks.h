#pragma once

#include <cstddef>
#include <cstdint>

/// What the fast kernels read and write: sixteen octaves of one kind at one time, one array a
/// constant, so that a kernel can broadcast one octave or load all of them.
///
/// Units: lattice coordinates in cells, phases in turns, everything else SI. Coordinates are
/// reduced in double, the rest is float.
namespace seaway {

inline constexpr std::size_t octavesPerBlock = 16;

/// Height, slope and ∂η/∂t of one octave are `height · E`, and sums of a constant times each of
/// three derivatives of its envelope and carrier: by phase, by the first and by the second lattice
/// coordinate (per unit of the weights' own rates).
struct alignas(64) DerivativeFactors {
  float height[octavesPerBlock];
  float slopeX[3][octavesPerBlock];
  float slopeY[3][octavesPerBlock];
  float rate[3][octavesPerBlock];
};

/// Linear coordinates a x + b y + c in double.
struct alignas(64) Coordinates {
  double x[octavesPerBlock];
  double y[octavesPerBlock];
  double offset[octavesPerBlock];
};

/// Group octaves. Unused places have zero factors.
struct GroupBlock {
  Coordinates along, across;  ///< offsets less ½: the nearest integer is the cell
  Coordinates turns;
  alignas(64) std::uint32_t seedX[octavesPerBlock];
  alignas(64) std::uint32_t seedY[octavesPerBlock];
  DerivativeFactors factors;
  alignas(64) float orbitalX[octavesPerBlock];  ///< horizontal orbital velocity at the surface per
  alignas(64) float orbitalY[octavesPerBlock];  ///< unit of E
  float wavelength[octavesPerBlock];  ///< dominant, m
  std::size_t count = 0;
};

/// Regular waves: the same carrier, an envelope that is 1.
struct RegularBlock {
  Coordinates turns;
  DerivativeFactors factors;  ///< only [0], by phase, is read
  alignas(64) float orbitalX[octavesPerBlock];
  alignas(64) float orbitalY[octavesPerBlock];
  float wavelength[octavesPerBlock];  ///< dominant, m
  std::size_t count = 0;
};

/// Perlin octaves: [0] of the factors multiplies the derivative by time of the blended slices,
/// [1] and [2] those by lattice coordinate.
struct PerlinBlock {
  Coordinates first, second;  ///< offsets less ½
  alignas(64) std::uint32_t seedX[2][octavesPerBlock];  ///< of the slice before and after t
  alignas(64) std::uint32_t seedY[2][octavesPerBlock];
  alignas(64) float weight[2][octavesPerBlock];      ///< of the slices
  alignas(64) float weightRate[2][octavesPerBlock];  ///< 1/s
  DerivativeFactors factors;
  float wavelength[octavesPerBlock];  ///< dominant, m
  std::size_t count = 0;
};

/// Sums over octaves, one element a point; kernels add to what is there. Sizes are those of a tile.
struct FieldSums {
  float* height;
  float* slopeX;
  float* slopeY;
  float* rate;
  float* orbitalX;  ///< null: not wanted
  float* orbitalY;
};

/// Points are processed in tiles that fit the first-level cache, padded to whole vectors.
inline constexpr std::size_t pointsPerTile = 256;

/// Batch kernels, points in lanes: add the octaves whose bits are set in `octaves` at `count` points.
/// `x`, `y` and the sums are aligned to 64 bytes and readable and writable up to the next multiple of 16.
void addGroupBatch(const GroupBlock& block, std::uint32_t octaves, const double* x, const double* y,
                   std::size_t count, const FieldSums& sums);
void addPerlinBatch(const PerlinBlock& block, std::uint32_t octaves, const double* x, const double* y,
                    std::size_t count, const FieldSums& sums);
void addRegularBatch(const RegularBlock& block, std::uint32_t octaves, const double* x, const double* y,
                     std::size_t count, const FieldSums& sums);

/// Point kernels, octaves in lanes: the same bits as the batch kernels for one point. `sums` point
/// to one element each.
void addGroupPoint(const GroupBlock& block, std::uint32_t octaves, double x, double y,
                   const FieldSums& sums);
void addPerlinPoint(const PerlinBlock& block, std::uint32_t octaves, double x, double y,
                    const FieldSums& sums);
void addRegularPoint(const RegularBlock& block, std::uint32_t octaves, double x, double y,
                     const FieldSums& sums);

/// Instruction set the kernels run on here: "AVX3", "AVX2", "SSE4".
const char* kernelTarget();

/// Restricts dispatch for tests and benchmarks: "AVX3", "AVX2", "SSE4", or "" for the best there
/// is. False where this machine or build lacks it. Not thread-safe.
bool forceKernelTarget(const char* target);

}  // namespace seaway
