#pragma once

#include <cstddef>

namespace seaway::render {

/// Edges and depth plane of a triangle from a pixel on: e_k = edge[k] + x·acrossEdge[k] +
/// y·downEdge[k] ≥ 0 inside; z likewise, kept within [least, most].
struct TrianglePlanes {
  float edge[3], acrossEdge[3], downEdge[3];
  float depth, acrossDepth, downDepth, least, most;
};

/// A strip's pixels, rows `stride` apart.
struct StripPixels {
  float* inverse;
  int stride, top, rows, width;
};

/// Draws the quads of a batch: corners at columns [first, first + count] of two rows of the grid.
void drawQuads(const float* x, const float* y, const float* inverse, std::size_t nextRow, int count,
               const StripPixels& strip);

/// Draws `width` × 1 pixels from `inverse` on of a triangle whose planes start there; `object` may
/// be null.
void drawSpan(const TrianglePlanes& planes, int width, float* inverse, unsigned* object,
              unsigned which);

}  // namespace seaway::render
