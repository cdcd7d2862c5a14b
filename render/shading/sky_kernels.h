#pragma once

namespace seaway::render {

struct SkyLights;

/// Row `row` of a paraboloid map of `side`² texels of the sky's radiance, red, green and blue of
/// each texel after the other. `side` is a multiple of 16. Outside the unit disc lies what is below
/// the horizon: there the horizon goes on, as filtering needs it to.
void drawSkyRow(const SkyLights& lights, int row, int side, float* rgb);

}  // namespace seaway::render
