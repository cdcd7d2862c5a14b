// Optics of water: reflectance, extinction, and light of one direction mirrored by it, in the
// common subset of GLSL and C++ (sea_shading.glsl.h says how).

// Part of each colour that is left after a way through water.
SHADER Real3 leftInWater(Real distance) {
  Real3 depth = Real3(waterExtinction) * distance;
  Real3 left = Real3(exp(-depth.x), exp(-depth.y), exp(-depth.z));
  // Three extinction lengths leave 5 %: there Toman's linear fade ends.
  if (extinctionIsLinear) {
    left = Real3(max(1.0f - depth.x * 0.33333333f, 0.0f), max(1.0f - depth.y * 0.33333333f, 0.0f),
                 max(1.0f - depth.z * 0.33333333f, 0.0f));
  }
  return left;
}

// Unpolarised reflectance; 1 where all is reflected.
SHADER Real fresnel(Real cosine, float index) {
  Real sineSquared = (1.0f - cosine * cosine) / (index * index);
  Real refracted = sqrt(max(1.0f - sineSquared, 0.0f));
  Real a = (cosine - index * refracted) / (cosine + index * refracted);
  Real b = (index * cosine - refracted) / (index * cosine + refracted);
  return choose(sineSquared >= 1.0f, Real(1.0f), 0.5f * (a * a + b * b));
}

// Horizontal unit vector; shorter towards the vertical, where there is no such direction.
SHADER Real2 levelDirection(Real3 direction) {
  Real2 level = Real2(direction.x, direction.y);
  return level * inversesqrt(max(dot(level, level), 0.04f * dot(direction, direction)));
}

// Mean square along a horizontal direction, unit vector or shorter, of slopes of waves that are not
// drawn, whose mean square is `waves`: they lean the way the sea's waves go.
SHADER Real unseenAlong(Real waves, Real2 direction) {
  Real squares = direction.x * direction.x - direction.y * direction.y;
  return 0.5f * waves *
         (1.0f + waveLean.x * squares + waveLean.y * (2.0f * direction.x * direction.y));
}

// Mean of max(x, 0) for Gaussian x of this mean and variance: within 6 % of it for means from 0 on,
// exact at 0 and without variance.
SHADER Real meanPositive(Real mean, Real variance) {
  return 0.5f * (mean + sqrt(mean * mean + 0.63662f * variance));
}

// Radiance for each irradiance of a light that facets of Gaussian slopes mirror (Cox & Munk's
// picture): Fresnel × density of the slope that mirrors, over 4 cos⁴ of its tilt and the area the
// viewer sees. `lit`: part of the facets that no wave hides from the light. Slopes on the surface
// as it is drawn, whose facing has the root `rootFacing`: waves that are not drawn, `waves` their
// mean square; finer ones that the pixel cannot show, `fine` their variance along an axis; and
// `ripples`, the variance of those that are in `slope` but not drawn, which must not count as often
// as the pixels that they turn to the viewer.
//
// Fine slopes hide one another on each wave (Smith 1967), more on one that turns away. Waves that
// are drawn show that; for those that are not, the mean of what is left of their facing, of waves
// on which the mirroring slope lies, stands for it.
SHADER Real mirroredByFacets(Real3 toViewer, Real3 toLight, Real lit, Real2 slope, Real waves,
                             Real fine, Real rootFacing, Real ripples) {
  Real3 halfway = toViewer + toLight;
  halfway = halfway * inversesqrt(max(dot(halfway, halfway), 1e-12f));
  Real tall = max(halfway.z, 1e-3f);
  Real offX = -halfway.x / tall - slope.x;
  Real offY = -halfway.y / tall - slope.y;
  // The sun is half a degree wide; that alone spreads the slopes that mirror it.
  Real mean = 0.5f * waves + fine + 1.2e-5f;
  Real leanX = 0.5f * waves * waveLean.x;
  Real leanY = 0.5f * waves * waveLean.y;
  // Covariance ((mean + leanX, leanY), (leanY, mean − leanX)): its determinant, its inverse on
  // `off`.
  Real perArea = 1.0f / (mean * mean - leanX * leanX - leanY * leanY);
  Real pullX = ((mean - leanX) * offX - leanY * offY) * perArea;
  Real pullY = ((mean + leanX) * offY - leanY * offX) * perArea;
  Real exponent = -0.5f * (offX * pullX + offY * pullY);
  Real strength = Real(0.0f);
  if (anyOf(exponent > -16.0f)) {
    Real density = exp(max(exponent, -60.0f)) * sqrt(perArea) * 0.15915494f;
    Real cosine = rootFacing * rootFacing;
    Real2 viewer = Real2(toViewer.x, toViewer.y);
    Real along = unseenAlong(waves, levelDirection(toViewer));
    Real area = roughArea(rootFacing, sqrt(along + fine + ripples));
    Real level = 1.0f - cosine * cosine;
    Real rough = (fine + ripples) * level;
    along = along * level;
    // Of waves on which the mirroring slope lies.
    Real2 pull = Real2(pullX, pullY);
    Real turned = 0.5f * waves * dot(viewer, pull) + leanX * (viewer.x * pullX - viewer.y * pullY) +
                  leanY * (viewer.x * pullY + viewer.y * pullX);
    Real facing = max(cosine, 0.01f);
    Real left = along * fine / (along + fine + 1e-6f);
    Real shown =
        meanPositive(facing - turned, left) * meanPositive(facing, along + rough) /
        (max(meanPositive(facing - turned, left + rough), 1e-4f) * meanPositive(facing, along));
    Real mirrored = max(dot(toViewer, halfway), 0.0f);
    strength = lit * shown * fresnel(mirrored, 1.34f) * density /
               (4.0f * tall * tall * tall * tall * max(area, 0.02f));
    strength = choose(halfway.z > 1e-3f, strength, Real(0.0f));
  }
  return strength;
}

// Rival terms for the same, which know one slope and no roughness.
SHADER Real mirroredByLobe(Real3 toViewer, Real3 toLight, Real2 slope) {
  Real3 normal = Real3(-slope.x, -slope.y, Real(1.0f));
  normal = normal * inversesqrt(dot(normal, normal));
  Real cosine = max(dot(normal, toViewer), 0.0f);
  Real3 mirrored = normal * (2.0f * dot(normal, toViewer)) - toViewer;
  Real along = dot(mirrored, toLight);
  Real reflected = fresnel(cosine, 1.34f);
  Real strength = Real(0.0f);
  if (specular == 1) {
    // Phong, exponent 2⁸, scaled so that the lobe's integral over directions is 1.
    Real lobe = clamp(along, 0.0f, 1.0f);
    for (int i = 0; i < 8; ++i) lobe = lobe * lobe;
    strength = reflected * lobe * (257.0f / 6.2831853f);
  } else {
    // Toman, exponent 2⁹; sunlight over π for the white of his picture.
    Real lobe = clamp(0.5f * along + 0.5f, 0.0f, 1.0f);
    for (int i = 0; i < 9; ++i) lobe = lobe * lobe;
    float shininess = 0.6f;
    strength = (1.0f - reflected) * max(toLight.z, 0.0f) * lobe * (1.8f * shininess + 0.2f);
    strength = strength * (1.0f + 25.0f * (shininess - 0.05f)) * 0.31830989f;
  }
  return strength;
}

SHADER Real mirroredLight(Real3 toViewer, Real3 toLight, Real lit, Real2 slope, Real waves,
                          Real fine, Real rootFacing, Real ripples) {
  Real strength = Real(0.0f);
  if (specular == 0) {
    strength = mirroredByFacets(toViewer, toLight, lit, slope, waves, fine, rootFacing, ripples);
  } else {
    strength = mirroredByLobe(toViewer, toLight, slope);
  }
  return strength;
}
