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

// Radiance for each irradiance of a light that facets of Gaussian slopes mirror (Cox & Munk's
// picture): Fresnel × density of the slope that mirrors, over 4 cos⁴ of its tilt and the area the
// viewer sees. `lit`: part of the facets that no wave hides from the light. `rootFacing`, `spread`: of
// the surface as it is drawn, and the deviation of all slopes on it: ripples, which are not, must not
// count as often as the pixels that they turn to the viewer.
SHADER Real mirroredByFacets(Real3 toViewer, Real3 toLight, Real lit, Real2 slope, Real variance,
                             Real rootFacing, Real spread) {
  Real3 halfway = toViewer + toLight;
  halfway = halfway * inversesqrt(max(dot(halfway, halfway), 1e-12f));
  Real tall = max(halfway.z, 1e-3f);
  Real offX = -halfway.x / tall - slope.x;
  Real offY = -halfway.y / tall - slope.y;
  // The sun is half a degree wide; that alone spreads the slopes that mirror it.
  Real width = variance + 1.2e-5f;
  Real exponent = -0.5f * (offX * offX + offY * offY) / width;
  Real strength = Real(0.0f);
  if (anyOf(exponent > -16.0f)) {
    Real density = exp(max(exponent, -60.0f)) / (6.2831853f * width);
    Real area = roughArea(rootFacing, spread);
    Real cosine = max(dot(toViewer, halfway), 0.0f);
    strength = lit * fresnel(cosine, 1.34f) * density /
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

SHADER Real mirroredLight(Real3 toViewer, Real3 toLight, Real lit, Real2 slope, Real variance,
                          Real rootFacing, Real spread) {
  Real strength = Real(0.0f);
  if (specular == 0) {
    strength = mirroredByFacets(toViewer, toLight, lit, slope, variance, rootFacing, spread);
  } else {
    strength = mirroredByLobe(toViewer, toLight, slope);
  }
  return strength;
}
