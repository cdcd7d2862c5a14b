// Which pixels are under water: the same rules as sea_shading.glsl.h, which comes after this text.
// Surroundings provide waterlineHeight.

SHADER Real2 pixelOf(Real3 place, Real axial) {
  return Real2(dot(place, Real3(pixelRight)) / axial + pixelMiddle.x,
               dot(place, Real3(pixelDown)) / axial + pixelMiddle.y);
}

// How deep a place lies under still water, on the curved sea, m; 0 above.
SHADER Real depthUnderStillWater(Real3 place) {
  return max(stillWater - place.z - 7.848e-8f * (place.x * place.x + place.y * place.y), 0.0f);
}

// 1 where the pixel that shows a place is under water: where its point on the near plane lies below
// the surface (Waterline).
SHADER Real submerged(Real3 place) {
  Real wet = Real(0.0f);
  if (cameraIsUnderWater) wet = Real(1.0f);
  if (waterlineIsOn) {
    Real2 pixel = pixelOf(place, max(dot(place, Real3(forward)), 1e-3f));
    Real x = clamp((pixel.x + 0.5f) * waterlinePerPixel.x, 0.0f, float(waterlineCells));
    Real y = clamp((pixel.y + 0.5f) * waterlinePerPixel.y, 0.0f, float(waterlineCells));
    Real column = min(floor(x), float(waterlineCells) - 1.0f);
    Real row = min(floor(y), float(waterlineCells) - 1.0f);
    Real upper = mix(waterlineHeight(column, row), waterlineHeight(column + 1.0f, row), x - column);
    Real lower = mix(waterlineHeight(column, row + 1.0f),
                     waterlineHeight(column + 1.0f, row + 1.0f), x - column);
    wet = choose(mix(upper, lower, y - row) < 0.0f, Real(1.0f), Real(0.0f));
  }
  return wet;
}

// The same where nothing is met: a ray that goes down from above the water meets it, and one that
// goes up from below, whatever the rounding of either has left out.
SHADER Real submergedNowhere(Real3 direction) {
  Real wet = submerged(direction);
  if (waterlineIsOn) {
    wet = choose(direction.z < -0.05f, Real(1.0f), wet);
    wet = choose(direction.z > 0.05f, Real(0.0f), wet);
  }
  return wet;
}
