#pragma once

#include <span>

#include "render/frame.h"

namespace seaway::render {

/// Softens jagged outlines in place: at the edges of objects, of the horizon and of crests before
/// water farther away, a pixel is averaged along the edge that its brightness shows (the idea of
/// T. Lottes' FXAA, 2009). Waves themselves are left sharp. On the processor, because a software
/// context would pay for every pixel. All of one size; deterministic. Pixels that `isSmooth` marks
/// (1), where it is not empty, are left as they are.
void smoothEdges(ColourImage& colour, const DepthImage& depth, std::span<const PixelClass> classes,
                 std::span<const std::uint8_t> isSmooth = {});

}  // namespace seaway::render
