#pragma once

#include <cstdint>
#include <vector>

#include "render/software/screen_grid.h"

/// Triangles into a strip of the picture, on the processor.
///
/// The nearest surface wins wherever triangles meet, and both cover their common edge: the result
/// does not depend on the order of drawing, hence not on the number of threads.
namespace seaway::render {

/// Some rows of the picture: 1/axial distance of the nearest surface so far, 0 where there is none,
/// and which object it belongs to.
struct Strip {
  int top = 0, rows = 0, width = 0;
  int stride = 0;  ///< floats from row to row; rows are writable 16 past `width`
  std::vector<float> inverse;
  std::vector<std::uint32_t> object;  ///< 0: sea; empty where no objects are drawn

  /// Starts anew.
  void clear(int firstRow, int rowCount, int pixelsAcross, bool withObjects);
};

/// Draws the sea's grid into the strip.
void rasterSea(const ScreenGrid& screen, Strip& strip);

/// Draws one triangle of any size into the strip; where it is nearer than what is there, its object
/// is noted if the strip has objects.
void rasterTriangle(const ScreenTriangle& triangle, Strip& strip);

}  // namespace seaway::render
