// Part of the sunlight that reaches a place, by the maps of ShadowMaps: the same rules as
// sea_shading.glsl.h, which comes after this text. Surroundings provide shadowHeight, and
// shadowMayFall, which may say no where all of a vector's pixels are in full sunlight.

// Where a place under water would be if the sun's ray to it went straight on below the surface.
SHADER Real3 straightened(Real3 place) {
  return place + Real3(shadowBend) * depthUnderStillWater(place);
}

// Quadratic B-spline; the weights of three neighbours add up to 1.
SHADER Real splineWeight(Real off) {
  Real outer = max(1.5f - off, 0.0f);
  return choose(off < 0.5f, 0.75f - off * off, 0.5f * outer * outer);
}

// Three by three texels about a place of map `i`, weighted by a quadratic spline; `height` is the
// place's own towards the sun.
SHADER Real litInMap(int i, Real2 at, Real height) {
  Real column = floor(at.x + 0.5f), row = floor(at.y + 0.5f);
  Real x = at.x - column, y = at.y - row;
  Real lit = Real(0.0f);
  for (int k = -1; k < 2; ++k) {
    for (int j = -1; j < 2; ++j) {
      Real weight = splineWeight(abs(x - float(j))) * splineWeight(abs(y - float(k)));
      Real top = shadowHeight(column + float(j), row + float(k) + shadowRow[i]);
      lit = lit + choose(top > height, Real(0.0f), weight);
    }
  }
  return lit;
}

// 1 in full sunlight, 0 in full shadow. A face, whose unit normal is given, is looked at from off
// its plane, as far as the farthest texel that counts makes necessary for it not to shade itself
// whatever its slope; a zero vector stands for what casts no shadow itself.
SHADER Real sunlitPart(Real3 place, Real3 normal) {
  Real lit = Real(1.0f);
  Real open = Real(1.0f);  // 1 until a map is found that covers the place
  Real cosine = dot(normal, Real3(sunDirection));
  Real sine = sqrt(max(1.0f - cosine * cosine, 0.0f));
  Real rounding = 1e-4f + 4e-7f * (abs(place.x) + abs(place.y) + abs(place.z));
  for (int i = 0; i < shadowCount; ++i) {
    Real3 from = straightened(place + normal * (2.13f * shadowTexel[i] * sine + rounding));
    Real2 at = Real2(dot(from, Real3(shadowRight)) / shadowTexel[i] - shadowLeast[i].x,
                     dot(from, Real3(shadowUp)) / shadowTexel[i] - shadowLeast[i].y);
    Real covered = choose(at.x > 1.0f, open, Real(0.0f));
    covered = choose(at.y > 1.0f, covered, Real(0.0f));
    covered = choose(at.x < shadowSize[i].x - 2.0f, covered, Real(0.0f));
    covered = choose(at.y < shadowSize[i].y - 2.0f, covered, Real(0.0f));
    open = open - covered;
    Real2 held =
        Real2(clamp(at.x, 1.0f, shadowSize[i].x - 2.0f), clamp(at.y, 1.0f, shadowSize[i].y - 2.0f));
    if (shadowMayFall(i, held, covered)) {
      // No lower than where nothing is: what casts a shadow is higher.
      Real height = max(dot(from, Real3(sunDirection)) - shadowBase + rounding, 0.0f);
      lit = choose(covered > 0.0f, litInMap(i, held, height), lit);
    }
  }
  return lit;
}
