// The water from inside: the same rules as sea_shading.glsl.h, which comes before this text.
// Surroundings provide of LocalLight's pictures windowLight, depthsNearness and depthsLight.

// What a facet of that slope lets through from above (Snell's window) and mirrors from below.
SHADER Real3 undersideFacet(Real3 relative, Real3 direction, Real2 slope, Real blur) {
  Real upright = inversesqrt(1.0f + dot(slope, slope));
  Real3 normal = Real3(slope.x, slope.y, Real(-1.0f)) * upright;  // downwards
  Real cosine = max(-dot(normal, direction), 0.0f);
  Real inside = 1.0f - 1.34f * 1.34f * (1.0f - cosine * cosine);
  Real3 above = Real3(0.0f, 0.0f, 0.0f);
  if (anyOf(inside > 0.0f)) {
    Real3 refracted = direction * 1.34f + normal * (1.34f * cosine - sqrt(max(inside, 0.0f)));
    above = blurredSky(refracted, blur) + 0.15f * sunDisc(refracted);
    if (windowIsOn) {
      // Seen where still water would show what lies in that direction.
      Real2 level = Real2(refracted.x, refracted.y) * (1.0f / 1.34f);
      Real3 seen = Real3(level.x, level.y, sqrt(max(1.0f - dot(level, level), 0.0f)));
      Real axial = dot(seen, Real3(forward));
      Real part = Real(0.0f);
      Real3 light = windowLight(pixelOf(seen, max(axial, 1e-3f)), part);
      Real shown = choose(axial > 1e-3f, Real(1.0f), Real(0.0f));
      above = above * (1.0f - part * shown) + light * shown;
    }
  }
  Real3 onwards = direction + normal * (2.0f * cosine);
  onwards = Real3(onwards.x, onwards.y, -abs(onwards.z));
  Real3 below = waterLight(onwards);
  if (depthsAreOn) {
    // In the mirrored world the ray goes on upwards; as far as what the pixel itself shows there.
    Real axial = dot(relative, Real3(forward));
    Real perAxial = sqrt(dot(relative, relative)) / max(axial, 1e-3f);
    Real nearness = depthsNearness(pixelOf(relative, max(axial, 1e-3f)));
    Real beyond = choose(nearness > 0.0f, 1.0f / max(nearness, 1e-6f) - axial, Real(2.0f));
    beyond = max(beyond, 0.0f) * perAxial;
    Real3 place = relative + Real3(onwards.x, onwards.y, -onwards.z) * beyond;
    Real placeAxial = max(dot(place, Real3(forward)), 1e-3f);
    Real part = Real(0.0f);
    Real3 light = depthsLight(pixelOf(place, placeAxial), part);
    Real3 clear = Real3(exp(-waterExtinction.x * beyond), exp(-waterExtinction.y * beyond),
                        exp(-waterExtinction.z * beyond));
    below = below - below * clear * part + light * clear;
  }
  Real mirror = choose(inside > 0.0f, fresnel(cosine, 1.0f / 1.34f), Real(1.0f));
  return mix(above, below, mirror);
}

// The surface from below: what is above through Snell's window, around it what is below, mirrored.
SHADER Real3 undersideRadiance(Real3 relative, Real distance, Real2 waveSlope, Real missingSlope) {
  Real3 direction = relative / distance;
  Real2 slope = waveSlope;
  Real meanSquare = missingSlope + hairSlope;
  if (ripplesAreOn) {
    Real footprint = 1.4f * pixelAngle * distance * inversesqrt(max(abs(direction.z), 0.02f));
    meanSquare = meanSquare + addRipples(relative, footprint, Real(1.0f), slope);
  }
  Real deviation = sqrt(0.5f * meanSquare);
  Real blur = blurLevel(deviation * 0.5f);
  Real3 seen = Real3(0.0f, 0.0f, 0.0f);
  // Three facets along and across the view for all that are within the deviation.
  Real2 towards = levelDirection(direction) * (1.4142136f * deviation);
  if (anyOf(deviation > 0.002f)) {
    seen = undersideFacet(relative, direction, slope, blur) * 0.5f +
           undersideFacet(relative, direction, slope + towards, blur) * 0.25f +
           undersideFacet(relative, direction, slope - towards, blur) * 0.25f;
  } else {
    seen = undersideFacet(relative, direction, slope, blur);
  }
  return throughWater(seen, direction, distance);
}
