#pragma once

#include <vector>

namespace seaway::render {

/// The lace that foam breaks up into: a square tile of numbers in [0, 1], all equally frequent, row
/// by row; water is white where the number is above 1 − cover. Cells of two sizes (Worley 1996),
/// warped, with patches. Always the same tile.
std::vector<float> foamPattern(int side);

}  // namespace seaway::render
