#pragma once

#include <cstdint>
#include <vector>

#include "render/camera.h"
#include "render/grid_layout.h"

namespace seaway::render {

/// Which batches of a grid's quads the camera may see: `batch` quads of a row, between it and the
/// next, row by row. False only where all vertices of a batch, anywhere within ± `bound` m of still
/// water, lie beyond one and the same side of the frustum: no quad that shows is lost.
///
/// Kryachko 2005 skips single vertices out of a widened frustum and loses quads that it leaves
/// between them; whole batches need no width.
std::vector<std::uint8_t> batchesInView(const GridLayout& layout, const Camera& camera,
                                        double bound, int batch);

}  // namespace seaway::render
