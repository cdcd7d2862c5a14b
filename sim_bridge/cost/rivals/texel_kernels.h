#pragma once

#include <cstddef>
#include <cstdint>

namespace seaway::rivals {

/// What one look-up answers: the same four values that the field's arrays hold.
struct alignas(16) Texel {
  float height = 0.0f;  ///< m
  float slopeX = 0.0f;
  float slopeY = 0.0f;
  float rate = 0.0f;  ///< ∂η/∂t at a fixed point, m/s
};

/// A square of texels that repeats over the plane; texel (0, 0) lies at −offset.
struct TexelGrid {
  const Texel* texels = nullptr;
  std::uint32_t size = 0;  ///< texels a side, a power of two
  double texelsPerMetre = 0.0;
  double offsetX = 0.0, offsetY = 0.0;  ///< texels
};

enum class Interpolation { bilinear, cubic };  ///< cubic: Catmull–Rom on 4×4 texels
enum class Store { set, add };

/// Looks `grid` up at `count` points (m): out = or += weight · texel. One texel is one vector.
void lookUp(const TexelGrid& grid, Interpolation interpolation, const double* x, const double* y,
            std::size_t count, float weight, Store store, Texel* out);

}  // namespace seaway::rivals
