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

/// What motion below the surface takes: wave number k, rad/m; Dη/Dt as sums like ∂η/∂t above; ω
/// coth kd along the wave, 1/s; ω², 1/s²; and 1/(1 ± e^(−2kd)), which scale the decay with depth.
struct alignas(64) MotionFactors {
  float waveNumber[octavesPerBlock];
  float materialRate[3][octavesPerBlock];
  float alongX[octavesPerBlock], alongY[octavesPerBlock];
  float squaredFrequency[octavesPerBlock];
  float horizontal[octavesPerBlock], vertical[octavesPerBlock];
};

/// Group octaves. Unused places have zero factors.
struct GroupBlock {
  Coordinates along, across;  ///< offsets less ½: the nearest integer is the cell
  Coordinates turns;
  alignas(64) std::uint32_t seedX[octavesPerBlock];
  alignas(64) std::uint32_t seedY[octavesPerBlock];
  DerivativeFactors factors;
  MotionFactors motion;
  float wavelength[octavesPerBlock];  ///< dominant, m
  std::size_t count = 0;
};

/// Regular waves: the same carrier, an envelope that is 1.
struct RegularBlock {
  Coordinates turns;
  DerivativeFactors factors;  ///< only [0], by phase, is read
  MotionFactors motion;
  float wavelength[octavesPerBlock];  ///< dominant, m
  std::size_t count = 0;
};

/// Perlin octaves: [0] of the factors multiplies the derivative by time of the blended slices,
/// [1] and [2] those by lattice coordinate.
struct PerlinBlock {
  Coordinates first, second;                            ///< offsets less ½
  alignas(64) std::uint32_t seedX[2][octavesPerBlock];  ///< of the slice before and after t
  alignas(64) std::uint32_t seedY[2][octavesPerBlock];
  alignas(64) float weight[2][octavesPerBlock];      ///< of the slices
  alignas(64) float weightRate[2][octavesPerBlock];  ///< 1/s
  DerivativeFactors factors;
  float wavelength[octavesPerBlock];  ///< dominant, m
  std::size_t count = 0;
};

/// What kernels add up, in this order:
///   height    η
///   surface   η, ∂η/∂x, ∂η/∂y, ∂η/∂t
///   orbital   as surface, and the horizontal orbital velocity at the surface (x, y)
///   pressure  dynamic pressure head Σ ηᵢ cosh k(z' + d)/cosh kd, m
///   motion    velocity (x, y, z), acceleration (x, y, z), dynamic pressure head
/// The last two at stretched heights z' and of octaves with kinematics only.
enum class Quantities { height, surface, orbital, pressure, motion };

constexpr std::size_t mostSums = 7;
constexpr std::size_t sumsOf(Quantities what) {
  switch (what) {
    case Quantities::surface:
      return 4;
    case Quantities::orbital:
      return 6;
    case Quantities::motion:
      return 7;
    default:
      return 1;
  }
}

/// Sums over octaves, one element a point; kernels add to what is there. Sizes are those of a tile.
struct FieldSums {
  Quantities what = Quantities::surface;
  float* sum[mostSums] = {};
  const float* stretched = nullptr;  ///< z' ≤ 0, m: for pressure and motion
  float depth = 0.0f;                ///< m, may be infinite: for pressure and motion
};

/// Points are processed in tiles that fit the first-level cache, padded to whole vectors.
inline constexpr std::size_t pointsPerTile = 256;

/// Batch kernels, points in lanes: add the octaves whose bits are set in `octaves` at `count`
/// points. `x`, `y` and the sums are aligned to 64 bytes and readable and writable up to the next
/// multiple of 16.
void addGroupBatch(const GroupBlock& block, std::uint32_t octaves, const double* x, const double* y,
                   std::size_t count, const FieldSums& sums);
void addPerlinBatch(const PerlinBlock& block, std::uint32_t octaves, const double* x,
                    const double* y, std::size_t count, const FieldSums& sums);
void addRegularBatch(const RegularBlock& block, std::uint32_t octaves, const double* x,
                     const double* y, std::size_t count, const FieldSums& sums);

/// Point kernels, octaves in lanes: the same bits as the batch kernels for one point. `sums` point
/// to one element each; height, surface and orbital only.
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
