// Shading of sea, sky and objects: one text that GLSL and C++ compile.
//
// `Real`, `Real2`, `Real3` are values that differ between pixels, `float`, `vec2`, `vec3` values
// that are the same for all of them (members of ShadingConstants, uniforms in GLSL). In GLSL both
// are the same types (shading_prelude.glsl); in C++ Real is a vector of pixels (lanes-inl.h) and
// this text is the inside of a class. It keeps to what both understand: no swizzles, `choose`
// instead of ?:, `if` only on `anyOf`. Surroundings provide skyTexel, rippleMoments, foamTexel,
// roughMirror, roughArea, and of LocalLight's pictures nearness (1/axial distance at a pixel, 0
// where there is nothing) and light (between pixels, times the part that is covered, which is
// returned too), mirrorMayShow, which may say no where none of a vector's rays meets anything, and
// rain_rings.glsl.h, optics.glsl.h, waterline.glsl.h, shadows.glsl.h and night_lights.glsl.h before
// this text.

// Bends water's mirror sharpness into the dome's mip level: a lobe of that slope deviation.
SHADER Real blurLevel(Real deviation) { return log2(1.0f + 340.0f * deviation); }

SHADER Real3 blurredSky(Real3 direction, Real level) {
  Real upwards = 1.0f + max(direction.z, 0.0f);
  Real2 dome = Real2(direction.x, direction.y) / upwards * 0.5f + Real2(0.5f, 0.5f);
  return skyTexel(dome, level);
}

// Sky just above the horizon: skyRadiance of atmosphere.glsl.h with all that does not depend on
// the direction worked out.
SHADER Real3 horizonSky(Real3 direction) {
  Real cosine = dot(levelDirection(direction), Real2(levelSun.x, levelSun.y));
  Real forwards = max(aerosolShape.x - aerosolShape.y * cosine, 1e-3f);
  Real3 sky = horizonOften + horizonRayleigh * (1.0f + cosine * cosine) +
              horizonAerosol / (forwards * sqrt(forwards));
  if (twilightIsOn) {
    Real side = 0.5f + 0.5f * cosine;
    sky = sky + Real3(horizonSide) * side + Real3(horizonArch) * (side * side * side);
  }
  if (moonIsOn) {
    Real off = dot(levelDirection(direction), Real2(levelMoon.x, levelMoon.y));
    Real towards = max(aerosolShape.x - aerosolShape.y * off, 1e-3f);
    sky = sky + Real3(moonRayleigh) * (1.0f + off * off) +
          Real3(moonAerosol) / (towards * sqrt(towards));
  }
  return sky;
}

// Air puts the sky just above the horizon in front of everything far away.
SHADER Real3 hazed(Real3 colour, Real3 direction, Real distance) {
  Real3 seen = colour;
  if (hazeIsOn) seen = mix(horizonSky(direction), colour, exp(-airExtinction * distance));
  return seen;
}

// Light of the water itself along a ray in it, brightest from above, as deep as the eye is.
SHADER Real3 waterLight(Real3 direction) { return Real3(eyeVeil) * exp(0.9f * direction.z); }

SHADER Real3 throughWater(Real3 colour, Real3 direction, Real distance) {
  return mix(waterLight(direction), colour, leftInWater(distance));
}

// The ray that a facet mirrors, in the mirrored world, where it goes on below the water.
SHADER Real3 mirroredOnwards(Real3 toViewer, Real2 facet) {
  Real3 normal = Real3(-facet.x, -facet.y, Real(1.0f));
  normal = normal * inversesqrt(dot(normal, normal));
  Real3 mirrored = normal * (2.0f * dot(normal, toViewer)) - toViewer;
  return Real3(mirrored.x, mirrored.y, -abs(mirrored.z));
}

// A place by its parts across, down and ahead of the picture: pixels from its middle times the
// axial distance, and that.
SHADER Real3 inPicture(Real3 place) {
  return Real3(dot(place, Real3(pixelRight)), dot(place, Real3(pixelDown)),
               dot(place, Real3(forward)));
}

SHADER Real2 pixelThere(Real3 place) {
  Real perAxial = 1.0f / max(place.z, 1e-3f);
  return Real2(place.x * perAxial + pixelMiddle.x, place.y * perAxial + pixelMiddle.y);
}

// Whether the box of two pixels meets what is mirrored.
SHADER Real meetsMirror(Real2 from, Real2 to) {
  Real meets = choose(min(from.y, to.y) < mirrorLeast.y + mirrorSize.y, Real(1.0f), Real(0.0f));
  meets = choose(max(from.y, to.y) > mirrorLeast.y - 1.0f, meets, Real(0.0f));
  meets = choose(min(from.x, to.x) < mirrorLeast.x + mirrorSize.x, meets, Real(0.0f));
  return choose(max(from.x, to.x) > mirrorLeast.x - 1.0f, meets, Real(0.0f));
}

// What of the scene's objects lies on such a ray, times the part of it that shows any: where the
// ray first lies behind something that lies behind the water's surface. `from` and `onwards` as
// inPicture has them.
SHADER Real3 mirroredObjects(Real3 from, Real3 onwards, INOUT(Real) part) {
  Real3 light = Real3(0.0f, 0.0f, 0.0f);
  // Steps through the distances between which there are objects: even ones, or where land is among
  // them ones that grow, for both what is near and what is far.
  Real perMetre = 1.0f / max(onwards.z, 0.02f);
  Real first = max((mirrorNearest - from.z) * perMetre, 0.0f);
  Real reach = max((mirrorFarthest - from.z) * perMetre - first, 0.0f);
  Real2 start = pixelThere(from + onwards * first);
  Real2 end = pixelThere(from + onwards * (first + reach));
  if (mirrorMayShow(start, end, meetsMirror(start, end))) {
    Real open = Real(1.0f);
    Real2 where = Real2(0.0f, 0.0f);
    Real surface = 1.0f / max(from.z, 1e-3f);
    for (int i = 1; i <= mirrorSteps && anyOf(open > 0.0f); ++i) {
      float share = float(i) / float(mirrorSteps);
      float slow = 1.0f - mirrorBend * (1.0f - share);
      Real3 place = from + onwards * (first + reach * (share * slow * slow));
      Real2 pixel = pixelThere(place);
      Real nearness = mirrorNearness(pixel);
      Real hit = choose(nearness * max(place.z, 1e-3f) > 1.0f, open, Real(0.0f));
      hit = choose(nearness < surface, hit, Real(0.0f));
      open = open - hit;
      where = Real2(choose(hit > 0.0f, pixel.x, where.x), choose(hit > 0.0f, pixel.y, where.y));
    }
    if (anyOf(open < 1.0f)) {
      Real covered = Real(0.0f);
      light = mirrorLight(where, covered) * (1.0f - open);
      part = part + covered * (1.0f - open);
    }
  }
  return light;
}

// Whether the rays of all facets that count end within pixels that what is mirrored is among.
SHADER Real raysMeetMirror(Real3 from, Real3 toViewer, Real2 slope, Real2 towards, Real deviation) {
  Real2 low = pixelThere(from);
  Real2 high = low;
  for (int i = -1; i < 2; i += 2) {
    Real2 facet = slope + towards * (deviation * (2.08f * float(i)));
    Real3 onwards = inPicture(mirroredOnwards(toViewer, facet));
    Real reach = max(mirrorFarthest - from.z, 0.0f) / max(onwards.z, 0.02f);
    Real2 end = pixelThere(from + onwards * reach);
    low = Real2(min(low.x, end.x), min(low.y, end.y));
    high = Real2(max(high.x, end.x), max(high.y, end.y));
  }
  return meetsMirror(low, high);
}

// Five facets for all, a deviation of their slope apart: fewer show as so many pictures.
SHADER Real3 roughlyMirrored(Real3 relative, Real3 toViewer, Real2 slope, Real2 towards,
                             Real deviation, INOUT(Real) part) {
  Real3 light = Real3(0.0f, 0.0f, 0.0f);
  Real3 from = inPicture(relative);
  Real meets = choose(from.z < mirrorFarthest, Real(1.0f), Real(0.0f));
  if (anyOf(meets > 0.0f))
    meets = meets * raysMeetMirror(from, toViewer, slope, towards, deviation);
  if (anyOf(meets > 0.0f)) {
    for (int i = -2; i < 3; ++i) {
      Real2 facet = slope + towards * (deviation * (1.04f * float(i)));
      float weight = 0.0545f;
      if (i == 0) weight = 0.403f;
      if (i * i == 1) weight = 0.244f;
      Real shown = Real(0.0f);
      Real3 onwards = inPicture(mirroredOnwards(toViewer, facet));
      light = light + mirroredObjects(from, onwards, shown) * weight;
      part = part + shown * weight;
    }
  }
  return light;
}

// Whether a slope may shift what lies under the water into the pixel of a place where nothing does:
// there half a metre of depth along the picture's axis is looked through. withObjectsBelow, by how
// far its pixel can move at most.
SHADER Real meetsBelow(Real2 pixel, Real perAxial, Real axial, Real2 slope) {
  Real shift = 0.17f * perAxial;
  Real ahead = slope.x * forward.x + slope.y * forward.y;
  Real perPlace = shift / max(axial + 0.5f - shift * abs(ahead), 1e-3f);
  Real across = slope.x * pixelRight.x + slope.y * pixelRight.y - (pixel.x - pixelMiddle.x) * ahead;
  Real down = slope.x * pixelDown.x + slope.y * pixelDown.y - (pixel.y - pixelMiddle.y) * ahead;
  Real2 reach = Real2(abs(across) * perPlace + 1.0f, abs(down) * perPlace + 1.0f);
  Real meets = choose(pixel.x + reach.x > belowLeast.x, Real(1.0f), Real(0.0f));
  meets = choose(pixel.x - reach.x < belowLeast.x + belowSize.x, meets, Real(0.0f));
  meets = choose(pixel.y + reach.y > belowLeast.y, meets, Real(0.0f));
  return choose(pixel.y - reach.y < belowLeast.y + belowSize.y, meets, Real(0.0f));
}

// Adds what of the scene's objects lies under the water to the light that comes up through it.
// Depths there are apparent ones; the wave's slope shifts what is seen through it by as much of the
// depth as a slope refracts.
SHADER Real3 refractedObjects(Real3 relative, Real axial, Real perAxial, Real2 straight,
                              Real3 toViewer, Real2 slope, Real3 water) {
  Real nearness = belowNearness(straight);
  Real beyond = choose(nearness > 0.0f, 1.0f / max(nearness, 1e-6f) - axial, Real(0.5f)) * perAxial;
  Real apparent = max(beyond, 0.0f) * max(toViewer.z, 0.05f);
  Real shift = 0.34f * min(apparent, 4.0f);
  Real3 place =
      relative - toViewer * max(beyond, 0.0f) + Real3(slope.x * shift, slope.y * shift, Real(0.0f));
  Real placeAxial = max(dot(place, Real3(forward)), 1e-3f);
  Real2 pixel = pixelOf(place, placeAxial);
  // A bed goes on beyond the picture.
  if (shoreHardness > 0.0f) {
    pixel = Real2(clamp(pixel.x, belowLeast.x, belowLeast.x + belowSize.x - 1.0f),
                  clamp(pixel.y, belowLeast.y, belowLeast.y + belowSize.y - 1.0f));
  }
  Real there = belowNearness(pixel);
  Real depth = (1.0f / max(there, 1e-6f) - axial) * perAxial * max(toViewer.z, 0.05f) * 1.34f;
  Real shown = choose(there > 0.0f, Real(1.0f), Real(0.0f));
  shown = choose(depth > 0.0f, shown, Real(0.0f));
  Real3 seen = water;
  if (anyOf(shown > 0.0f)) {
    Real part = Real(0.0f);
    Real3 light = belowLight(pixel, part);
    Real steep = sqrt(max(1.0f - (1.0f - toViewer.z * toViewer.z) / (1.34f * 1.34f), 0.1f));
    Real3 clear = leftInWater(max(depth, 0.0f) / steep);
    seen = water - water * clear * (part * shown) + light * clear * shown;
  }
  return seen;
}

SHADER Real3 withObjectsBelow(Real3 relative, Real distance, Real3 toViewer, Real2 slope,
                              Real3 water) {
  Real axial = dot(relative, Real3(forward));
  Real perAxial = distance / axial;
  Real2 straight = pixelOf(relative, axial);
  Real meets = Real(1.0f);
  if (!(shoreHardness > 0.0f)) meets = meetsBelow(straight, perAxial, axial, slope);
  Real3 seen = water;
  if (anyOf(meets > 0.0f)) {
    seen = refractedObjects(relative, axial, perAxial, straight, toViewer, slope, water);
  }
  return seen;
}

// Where water begins, what lies under it shows unrefracted: blended in by depth times hardness
// (Toman, "Shore softness"). The bed there is as wet as the pictures of LocalLight make it.
SHADER Real3 withSoftShore(Real3 relative, Real distance, Real3 toViewer, Real3 water) {
  Real axial = dot(relative, Real3(forward));
  Real2 pixel = pixelOf(relative, axial);
  Real nearness = belowNearness(pixel);
  Real beyond = (1.0f / max(nearness, 1e-6f) - axial) * distance / axial;
  Real depth = 1.34f * max(beyond, 0.0f) * max(toViewer.z, 0.02f);
  Real part = Real(0.0f);
  Real3 bed = belowLight(pixel, part);
  Real shown = choose(nearness > 0.0f, clamp(depth * shoreHardness, 0.0f, 1.0f), Real(1.0f));
  return mix(bed / max(part, 1e-3f), water, choose(part > 0.01f, shown, Real(1.0f)));
}

// Disc and glare about it. Angles are small where either shows: chord for arc.
SHADER Real3 sunDisc(Real3 direction) {
  Real3 off = direction - Real3(sunDirection);
  Real squared = dot(off, off);
  Real3 disc = Real3(0.0f, 0.0f, 0.0f);
  if (anyOf(squared < 0.16f)) {
    Real angle = sqrt(squared);
    Real sharp = 1.0f - smoothstep(0.0052f, 0.0068f, angle);
    if (moonIsOn) sharp = sharp * moonlit(off, squared);
    Real glare = 0.012f * exp(-22.0f * angle) + 0.10f * exp(-120.0f * angle);
    disc = Real3(sunLight) * (discLight * sharp + glare);
  }
  return disc;
}

SHADER Real3 skyRadianceSeen(Real3 direction) {
  return blurredSky(direction, Real(0.0f)) + sunDisc(direction);
}

// Adds ripples finer than the field to the slope; what the pixel cannot show of them is returned
// as mean-square slope.
SHADER Real addRipples(Real3 relative, Real footprint, Real calm, INOUT(Real2) slope) {
  Real left = Real(0.0f);
  Real deviation = rippleDeviation * calm;
  for (int i = 0; i < 2; ++i) {
    Real level = log2(max(footprint * rippleTexelsPerMetre[i], 1e-6f));
    Real3 moments = Real3(0.0f, 0.0f, 0.0f);
    if (anyOf(level < rippleLastLevel)) {
      vec2 x = rippleFromWorld[2 * i];
      vec2 y = rippleFromWorld[2 * i + 1];
      moments = rippleMoments(Real2(rippleOrigin[i].x + x.x * relative.x + y.x * relative.y,
                                    rippleOrigin[i].y + x.y * relative.x + y.y * relative.y),
                              level);
    }
    vec2 along = rippleAlong[i];
    slope = slope + deviation * Real2(along.x * moments.x - along.y * moments.y,
                                      along.y * moments.x + along.x * moments.y);
    left = left + deviation * deviation * max(1.0f - moments.z, 0.0f);
  }
  return left;
}

// Light that comes back out of the water: thin crests let light through where the viewer looks at
// them from the side, most towards the sun; bubbles under foam scatter it.
SHADER Real3 upwelling(Real3 toViewer, Real2 slope, Real height, Real white, Real oil) {
  Real crest = clamp(0.5f + height * crestScale, 0.0f, 1.5f);
  Real tilt = -(slope.x * toViewer.x + slope.y * toViewer.y);
  Real face = clamp(0.2f + 1.6f * tilt, 0.0f, 1.0f) * (1.0f - toViewer.z);
  Real against = max(-(toViewer.x * sunDirection.x + toViewer.y * sunDirection.y), 0.0f);
  Real high = crest * crest;
  Real3 water = Real3(deepWater) + Real3(bubbleLight) * white +
                high * face * (Real3(crestSky) + against * against * Real3(crestSun));
  return mix(water, Real3(oilLight), oil);
}

// Part of a pixel's water that whitecaps cover: WhitecapRule (surface/whitecaps.h), and where the
// grid no longer carries the slopes that it asks for, its mean.
SHADER Real whitecaps(Real2 slope, Real missingSlope, Real height) {
  Real kept = clamp(1.0f - missingSlope * perTotalSlope, 0.0f, 1.0f);
  Real elevation = height * whitecapPerHeight;
  Real ahead =
      -(slope.x * whitecapAlong.x + slope.y * whitecapAlong.y) * inversesqrt(max(kept, 0.1f));
  Real crests =
      clamp((0.857f * elevation + 0.515f * ahead - breakingRamp.x) * breakingRamp.y, 0.0f, 1.0f) +
      clamp((0.5f * elevation - 0.866f * ahead - oldRamp.x) * oldRamp.y, 0.0f, 1.0f) * oldRamp.z;
  crests = mix(Real(whitecapMean), crests, smoothstep(Real(0.03f), Real(0.3f), kept));
  Real steep = (sqrt(dot(slope, slope)) - 0.55f) * 3.3333333f;
  return clamp(max(crests, steep), 0.0f, 1.0f);
}

// How opaque foam of a cover is in a pixel: patches and lace by three layers of a pattern whose
// numbers are equally frequent, so that on average it is as white as the cover says; cover itself
// where the pattern is too fine to be seen.
SHADER Real foamOpacity(Real3 relative, Real footprint, Real cover) {
  Real sum = Real(0.0f);
  Real kept = Real(0.0f);
  for (int i = 0; i < 3; ++i) {
    Real level = log2(max(footprint * foamTexelsPerMetre[i], 1e-6f));
    Real2 number = Real2(0.5f, 0.0f);
    if (anyOf(level < foamLastLevel)) {
      vec2 axis = foamAxis[i];
      number = foamTexel(Real2(foamOrigin[i].x + axis.x * relative.x + axis.y * relative.y,
                               foamOrigin[i].y - axis.y * relative.x + axis.x * relative.y),
                         level);
    }
    sum = sum + number.x;
    kept = kept + number.y * 0.33333333f;
  }
  // The sum of three is spread as Irwin and Hall say; this makes it even again.
  Real over = 3.0f - sum;
  Real middle = sum * (sum * (9.0f - 2.0f * sum) - 9.0f) + 3.0f;
  Real outer = choose(sum < 1.5f, sum * sum * sum, 6.0f - over * over * over);
  Real even = choose(abs(sum - 1.5f) < 0.5f, middle, outer) * 0.16666667f;
  // A ramp of width ½ has the mean of the cover for this threshold.
  Real threshold = choose(cover < 0.25f, sqrt(cover), cover + 0.25f);
  Real lace = clamp((even - 1.0f + threshold) * 2.0f, 0.0f, 1.0f);
  return mix(cover, lace, kept);
}

// Adds to the waves' slope what is finer; returned is the mean-square slope of what is finer that
// the pixel cannot show. `waves`: that of waves, the missing ones as they come. `rippled`: that of
// the ripples in the slope.
SHADER Real seenSlope(Real3 relative, Real footprint, Real3 cover, INOUT(Real2) slope,
                      INOUT(Real) waves, INOUT(Real) rippled) {
  // Smooth water lacks short waves, in slopes as in samples.
  Real calm = (1.0f - 0.9f * cover.y) * (1.0f - 0.9f * cover.z);
  waves = waves * calm * calm;
  Real meanSquare = hairSlope * calm * calm;
  rippled = Real(0.0f);
  if (ripplesAreOn) {
    Real left = addRipples(relative, footprint, calm, slope);
    meanSquare = meanSquare + left;
    rippled = max(2.0f * rippleDeviation * rippleDeviation * calm * calm - left, 0.0f);
  }
  return meanSquare;
}

// Width of a pixel on the water.
SHADER Real footprintOn(Real3 toViewer, Real distance, Real2 slope) {
  Real upright = inversesqrt(1.0f + dot(slope, slope));
  Real facing = upright * (toViewer.z - slope.x * toViewer.x - slope.y * toViewer.y);
  return 1.4f * pixelAngle * distance * inversesqrt(max(facing, 0.02f));
}

// Part of a pixel of water that is white with foam, as waterRadiance mixes it in. `lying`: foam
// that lies on the water, [0, 1].
SHADER Real foamPart(Real3 relative, Real distance, Real2 slope, Real missingSlope, Real height,
                     Real lying) {
  Real3 toViewer = -relative / distance;
  Real footprint = footprintOn(toViewer, distance, slope);
  Real white = whitecaps(slope, missingSlope, height);
  return foamOpacity(relative, footprint, white + lying * (1.0f - white));
}

// `cover`: foam that lies on the water, smoothed water, oil; each in [0, 1].
SHADER Real3 waterRadiance(Real3 relative, Real distance, Real2 waveSlope, Real missingSlope,
                           Real height, Real3 cover) {
  Real3 toViewer = -relative / distance;
  Real2 slope = waveSlope;
  Real footprint = footprintOn(toViewer, distance, slope);
  Real rippled = Real(0.0f);
  Real waves = missingSlope;
  Real finer = seenSlope(relative, footprint, cover, slope, waves, rippled);
  Real2 ripples = slope - waveSlope;
  if (rainIsOn) finer = finer + addRain(relative, footprint, slope);
  // Where the mean slope faces away, what is seen are facets that do not.
  Real2 towards = levelDirection(toViewer);
  Real facing = toViewer.z - slope.x * toViewer.x - slope.y * toViewer.y;
  Real level = sqrt(max(1.0f - toViewer.z * toViewer.z, 0.01f));
  if (backFacesAreTilted) slope = slope + towards * (min(facing, 0.0f) / level);
  Real upright = inversesqrt(1.0f + dot(slope, slope));
  Real variance = unseenAlong(waves, towards) + 0.5f * finer;  // along the view
  Real cosine = max(max(facing, 0.0f) * upright, 0.0f);
  Real rootCosine = sqrt(cosine);
  Real deviation = sqrt(variance);
  Real2 rough = roughMirror(rootCosine, deviation);

  Real2 leaned = slope - towards * rough.y;
  Real3 tilted = Real3(-leaned.x, -leaned.y, Real(1.0f));
  tilted = tilted * inversesqrt(dot(tilted, tilted));
  Real3 mirrored = tilted * (2.0f * dot(tilted, toViewer)) - toViewer;
  mirrored.z = abs(mirrored.z);  // a ray that starts downwards is mirrored once more
  Real3 sky = blurredSky(mirrored, blurLevel(deviation));
  Real open = Real(1.0f);  // part of what is mirrored that no object hides
  if (mirrorIsOn) {
    // Half of a pixel's own ripples, the rest as roughness: edges would break up into dots.
    Real hidden = Real(0.0f);
    Real3 objects = roughlyMirrored(relative, toViewer, leaned - 0.5f * ripples, towards,
                                    sqrt(variance + 0.375f * rippled), hidden);
    open = 1.0f - hidden;
    sky = sky * open + objects;
  }

  Real white = Real(0.0f);
  if (foamIsOn) {
    white = whitecaps(waveSlope, missingSlope, height);
    white = white + cover.x * (1.0f - white);
  }
  // A film of oil reflects half as much again.
  Real mirror = rough.x + 0.5f * cover.z * rough.x * (1.0f - rough.x);
  Real3 fromBelow = upwelling(toViewer, slope, height, white, cover.z);
  Real sunlit = Real(1.0f);
  if (shadowCount > 0) {
    sunlit = sunlitPart(relative, Real3(0.0f, 0.0f, 0.0f));
    fromBelow = fromBelow - fromBelow * Real3(sunPartBelow) * (1.0f - sunlit);
  }
  if (belowIsOn) fromBelow = withObjectsBelow(relative, distance, toViewer, slope, fromBelow);
  Real3 colour = mix(fromBelow, sky, mirror);
  Real drawn = toViewer.z - waveSlope.x * toViewer.x - waveSlope.y * toViewer.y;
  Real rootFacing = sqrt(max(drawn, 0.0f) * inversesqrt(1.0f + dot(waveSlope, waveSlope)));
  if (sunIsOn) {
    Real mirroredSun = mirroredLight(toViewer, Real3(sunDirection), Real(sunlitFacets), slope,
                                     waves, 0.5f * finer, rootFacing, 0.5f * rippled);
    colour = colour + Real3(sunLight) * (mirroredSun * open * sunlit);
  }
  if (lampCount > 0) {
    colour = colour + lampGlitter(relative, toViewer, slope, waves, 0.5f * finer, rootFacing,
                                  0.5f * rippled) *
                          open;
  }
  if (anyOf(white > 0.0f)) {
    Real lit =
        max(sunDirection.z - slope.x * sunDirection.x - slope.y * sunDirection.y, 0.0f) * upright;
    Real3 whiteWater = Real3(foamSky) + Real3(foamSun) * (lit * sunlit);
    if (lampCount > 0) {
      whiteWater = whiteWater + lampLightOn(relative, Real3(0.0f, 0.0f, 1.0f)) * 0.5f;
    }
    colour = mix(colour, whiteWater, foamOpacity(relative, footprint, white));
  }
  if (shoreHardness > 0.0f) colour = withSoftShore(relative, distance, toViewer, colour);
  colour = hazed(colour, -toViewer, distance);
  if (lampCount > 0) colour = colour + lampsSeen(-toViewer, distance);
  return colour;
}

SHADER Real3 skyPixel(Real3 direction) {
  Real wet = submergedNowhere(direction);
  Real3 seen = Real3(0.0f, 0.0f, 0.0f);
  if (anyOf(wet < 0.5f)) {
    seen = skyRadianceSeen(direction);
    if (starLight > 0.0f) seen = seen + starsSeen(direction);
    if (lampCount > 0) seen = seen + lampsSeen(direction, Real(1e9f));
  }
  return choose(wet < 0.5f, seen, waterLight(direction));
}

// `place`: where the object is, where `relative` shows it by way of the water.
SHADER Real3 objectRadiance(Real3 relative, Real distance, Real3 normal, Real3 reflectance,
                            Real3 place) {
  Real depth = depthUnderStillWater(place);
  Real wetted = clamp(depth * 10.0f, 0.0f, 1.0f);  // by degrees: there are waves
  Real3 sun = mix(Real3(sunDirection), Real3(sunInWater), wetted);
  Real facing = max(dot(normal, sun), 0.0f) * 0.31830989f;
  if (shadowCount > 0) {
    if (anyOf(facing > 0.0f)) facing = facing * sunlitPart(place, normal);
  }
  // Under water the sun's light is what the surface let in; the sky's fills Snell's window, 1/n² of
  // the hemisphere, less 7 % that the surface mirrors, the water's own the rest.
  facing = facing * mix(Real(1.0f), Real(sunThroughSurface), wetted);
  Real3 upper = Real3(normal.x, normal.y, normal.z + 1.2f);
  Real3 ambient = blurredSky(upper * inversesqrt(max(dot(upper, upper), 1e-12f)), Real(7.0f));
  ambient = mix(ambient, ambient * 0.52f + Real3(veil) * 0.44f, wetted);
  Real3 lower = mix(Real3(0.06f * skyLight), Real3(veil), wetted);
  Real3 light = mix(lower, ambient, 0.5f + 0.5f * normal.z) + Real3(sunLight) * facing;
  if (lampCount > 0) light = light + lampLightOn(relative, normal);
  // Light that has come down through the water, the way of the sun's. From below the surface
  // mirrors 48 % of diffuse light back to it, again and again: 1 − (1 − 0.068)/1.34², by what it
  // mirrors above.
  Real3 clear = leftInWater(depth * (1.0f / sunInWater.z));
  Real3 colour = reflectance * light * clear /
                 (Real3(1.0f, 1.0f, 1.0f) - reflectance * clear * (0.48f * wetted));
  Real wet = submerged(relative);
  Real3 seen = hazed(colour, relative / distance, distance);
  if (lampCount > 0) seen = seen + lampsSeen(relative / distance, distance);
  if (anyOf(wet > 0.5f)) {
    seen = choose(wet > 0.5f, throughWater(colour, relative / distance, distance), seen);
  }
  return seen;
}

// ToneCurve of what is exposed, [0, 1].
SHADER Real3 toneMapped(Real3 radiance) {
  Real3 x = radiance * exposure;
  Real3 shown = x;
  if (toneCurve == 0) shown = x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f);
  if (toneCurve == 1) shown = x * (0.0625f * x + 1.0f) / (x + 1.0f);
  return clamp(shown, 0.0f, 1.0f);
}

// Thresholds of [0, 1) for a pixel, evenly spread among neighbours (Jimenez 2014, "Next generation
// post processing in Call of Duty", interleaved gradient noise).
SHADER Real ditherAt(Real column, Real row) {
  Real first = column * 0.06711056f + row * 0.00583715f;
  Real second = 52.9829189f * (first - floor(first));
  return second - floor(second);
}
