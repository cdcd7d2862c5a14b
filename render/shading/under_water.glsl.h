// The water from inside: the same rules as sea_shading.glsl.h, which comes before this text.
// Surroundings provide of LocalLight's pictures windowLight, depthsNearness and depthsLight.

// Unit normal, downwards, of water with a slope.
SHADER Real3 undersideNormal(Real2 slope) {
  return Real3(slope.x, slope.y, Real(-1.0f)) * inversesqrt(1.0f + dot(slope, slope));
}

// What a facet mirrors from below, averaged over those within the deviation of slope along the
// view.
SHADER Real undersideMirror(Real3 direction, Real2 slope, Real2 deviation) {
  Real mirror = Real(0.0f);
  for (int i = -3; i < 4; ++i) {
    float weight = 0.3205f;
    if (i * i == 1) weight = 0.2327f;
    if (i * i == 4) weight = 0.0891f;
    if (i * i == 9) weight = 0.01795f;
    Real3 normal = undersideNormal(slope + deviation * (0.8f * float(i)));
    mirror = mirror + fresnel(max(-dot(normal, direction), 0.0f), 1.0f / 1.34f) * weight;
  }
  return mirror;
}

// Direction of the ray in air, along the surface where there is none.
SHADER Real3 refractedUpwards(Real3 direction, Real3 normal) {
  Real cosine = max(-dot(normal, direction), 0.0f);
  Real inside = max(1.0f - 1.34f * 1.34f * (1.0f - cosine * cosine), 0.0f);
  Real3 ray = direction * 1.34f + normal * (1.34f * cosine - sqrt(inside));
  return ray * inversesqrt(max(dot(ray, ray), 1e-12f));
}

// Snell's window: sky, and scene objects where still water would show what lies in that direction.
SHADER Real3 throughWindow(Real3 direction, Real2 slope, Real2 calmer, Real blur) {
  Real3 ray = refractedUpwards(direction, undersideNormal(slope));
  Real3 above = blurredSky(ray, blur) + 0.15f * sunDisc(ray);
  if (windowIsOn) {
    Real3 there = refractedUpwards(direction, undersideNormal(calmer));
    Real2 level = Real2(there.x, there.y) * (1.0f / 1.34f);
    Real3 seen = Real3(level.x, level.y, sqrt(max(1.0f - dot(level, level), 0.0f)));
    Real axial = dot(seen, Real3(forward));
    Real part = Real(0.0f);
    Real3 light = windowLight(pixelOf(seen, max(axial, 1e-3f)), part);
    Real shown = choose(axial > 1e-3f, Real(1.0f), Real(0.0f));
    above = above * (1.0f - part * shown) + light * shown;
  }
  return above;
}

// What is below, mirrored: objects of the scene in front of the water's own light.
SHADER Real3 mirroredDepths(Real3 relative, Real3 direction, Real2 slope) {
  Real3 normal = undersideNormal(slope);
  Real3 onwards = direction + normal * (2.0f * max(-dot(normal, direction), 0.0f));
  onwards = Real3(onwards.x, onwards.y, -abs(onwards.z));
  Real3 below = waterLight(onwards);
  if (depthsAreOn) {
    // In the mirrored world the ray goes on upwards; as far as what the pixel itself shows there.
    Real axial = max(dot(relative, Real3(forward)), 1e-3f);
    Real perAxial = sqrt(dot(relative, relative)) / axial;
    Real nearness = depthsNearness(pixelOf(relative, axial));
    Real beyond = choose(nearness > 0.0f, 1.0f / max(nearness, 1e-6f) - axial, Real(2.0f));
    beyond = max(beyond, 0.0f) * perAxial;
    Real3 place = relative + Real3(onwards.x, onwards.y, -onwards.z) * beyond;
    Real part = Real(0.0f);
    Real3 light = depthsLight(pixelOf(place, max(dot(place, Real3(forward)), 1e-3f)), part);
    Real3 clear = leftInWater(beyond);
    below = below - below * clear * part + light * clear;
  }
  return below;
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
  // A part of the ripples for objects: edges would break up into dots.
  Real2 calmer = waveSlope + (slope - waveSlope) * 0.4f;
  Real mirror = undersideMirror(direction, slope, levelDirection(direction) * deviation);
  Real3 seen = Real3(0.0f, 0.0f, 0.0f);
  if (anyOf(mirror > 0.0f)) seen = mirroredDepths(relative, direction, calmer);
  if (anyOf(mirror < 1.0f)) {
    seen = mix(throughWindow(direction, slope, calmer, blurLevel(0.5f * deviation)), seen, mirror);
  }
  return throughWater(seen, direction, distance);
}
