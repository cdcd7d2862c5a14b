#pragma once

#include <cstddef>
#include <vector>

namespace seaway {

/// B-spline coefficients of the water surface on a periodic grid of cells fixed in the world, at
/// one time: cell (i, j) is centred at (i, j) · cellSize modulo the grid's size. Each row and the
/// rows themselves are repeated by one cell before and two after, so that a spline's 4 × 4 cells
/// are read without wrapping.
struct WakeGrid {
  explicit WakeGrid(int cellsAlong, bool withPotential)
      : cells(cellsAlong),
        stride(static_cast<std::size_t>(cells) + 8),
        surface(2 * stride * (static_cast<std::size_t>(cells) + 3)),
        potential(withPotential ? stride * (static_cast<std::size_t>(cells) + 3) : 0) {}

  /// First of the spline's cells of row j − 1 for the cell (i, j), 0 ≤ i, j < cells.
  std::size_t corner(std::size_t i, std::size_t j) const { return j * stride + i; }

  std::size_t memoryBytes() const { return (surface.size() + potential.size()) * sizeof(float); }

  int cells;
  std::size_t stride;            ///< cells from row to row
  std::vector<float> surface;    ///< η in m and ∂η/∂t in m/s, in turn
  std::vector<float> potential;  ///< φ at the surface, m²/s; empty: none
  float largestHeight = 0.0f;    ///< no |η| is above, m
  float largestRate = 0.0f;      ///< no |∂η/∂t| is above, m/s
};

}  // namespace seaway
