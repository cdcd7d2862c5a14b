// Lamps, moon and stars, in the common subset of GLSL and C++ (sea_shading.glsl.h says how).

// Lamps before or beside what is `distance` away, as a lens shows them: a spot, and a tenth of the
// veil that light scattered in an eye lays about it (Stiles and Holladay: 10 E/θ², θ in degrees;
// CIE 146:2002).
SHADER Real3 lampsSeen(Real3 direction, Real distance) {
  Real3 light = Real3(0.0f, 0.0f, 0.0f);
  for (int i = 0; i < lampCount; ++i) {
    Real3 place = Real3(lampPlace[i]);
    Real along = max(dot(direction, place), 1e-3f);
    Real3 off = direction * along - place;
    Real perAlong = 1.0f / (along * along);
    Real squared = dot(off, off) * perAlong;
    // A lamp sits on its mast or house, not in it.
    Real open = choose(along < distance + 0.35f, Real(1.0f), Real(0.0f));
    open = choose(dot(direction, place) > 0.05f, open, Real(0.0f));
    float width = lampWidth[i];
    Real spot = exp(max(squared * (-0.5f / width), -60.0f)) * (0.159f / width);
    Real glare = 0.0003f / (squared + 4.0f * width);
    Real air = Real(1.0f);
    if (hazeIsOn) air = exp(-airExtinction * along);
    light = light + Real3(lampLight[i]) * ((spot + glare) * open * perAlong * air);
  }
  return light;
}

// Their glitter on the water.
SHADER Real3 lampGlitter(Real3 relative, Real3 toViewer, Real2 slope, Real waves, Real fine,
                         Real rootFacing, Real ripples) {
  Real3 light = Real3(0.0f, 0.0f, 0.0f);
  for (int i = 0; i < lampCount; ++i) {
    Real3 offset = Real3(lampPlace[i]) - relative;
    Real squared = max(dot(offset, offset), 0.04f);
    Real3 toLight = offset * inversesqrt(squared);
    Real height = max(toLight.z, 0.0f);
    Real lit = min(height / max(roughArea(sqrt(height), Real(seaDeviation)), 1e-3f), 1.0f);
    Real strength = mirroredLight(toViewer, toLight, lit, slope, waves, fine, rootFacing, ripples);
    strength = choose(toLight.z > 0.0f, strength / squared, Real(0.0f));
    light = light + Real3(lampLight[i]) * strength;
  }
  return light;
}

// Their irradiance on a surface, over π.
SHADER Real3 lampLightOn(Real3 relative, Real3 normal) {
  Real3 light = Real3(0.0f, 0.0f, 0.0f);
  for (int i = 0; i < lampCount; ++i) {
    Real3 offset = Real3(lampPlace[i]) - relative;
    Real squared = max(dot(offset, offset), 0.25f);
    Real facing = max(dot(normal, offset), 0.0f) * inversesqrt(squared);
    light = light + Real3(lampLight[i]) * (facing / squared * (lampShines[i] * 0.31830989f));
  }
  return light;
}

// Part of a disc that is lit at `off` from its centre, a chord; `squared` its length's square.
SHADER Real moonlit(Real3 off, Real squared) {
  Real along = dot(off, Real3(discAxis)) * (1.0f / 0.0068f);
  Real chord = sqrt(max(1.0f - (squared * (1.0f / 4.624e-5f) - along * along), 0.0f));
  return smoothstep(Real(-0.1f), Real(0.1f), along - discEdge * chord);
}

// A star in few of the cells of a paraboloid map, as bright as chance has it: four times as many of
// each next magnitude, to the fifth.
SHADER Real3 starsSeen(Real3 direction) {
  float cells = 70.0f;
  Real upwards = 1.0f + max(direction.z, 0.0f);
  Real x = direction.x / upwards * cells, y = direction.y / upwards * cells;
  Real column = floor(x), row = floor(y);
  Word number = rainHash(wordOf(column), wordOf(row), word(0x5EA3u), word(0x51A2u));
  Word other = rainHash(wordOf(column), wordOf(row), word(0x77E1u), word(0x2C1Bu));
  Real offX = x - column - (0.15f + 0.7f * unitOf(number));
  Real offY = y - row - (0.15f + 0.7f * unitOf(shiftedDown(number, 16)));
  // One unit of the map is an angle of (1 + z)/cells.
  Real angle = upwards * (1.0f / cells);
  Real squared = (offX * offX + offY * offY) * angle * angle;
  float width = 0.35f * pixelAngle * pixelAngle + 1e-8f;
  Real chance = unitOf(other);
  // Irradiance falls as (number of brighter ones)^(−2/3).
  Real share = 0.0015f / max(chance, 0.0015f);
  Real bright = choose(chance < 0.16f, share * sqrt(share), Real(0.0f));
  Real spot = exp(max(squared * (-0.5f / width), -60.0f)) * (0.159f / width);
  Real warm = unitOf(shiftedDown(other, 16));
  Real seen = starLight * bright * spot * clamp(direction.z * 4.0f, 0.0f, 1.0f);
  return Real3(0.85f + 0.3f * warm, Real(1.0f), 1.2f - 0.4f * warm) * seen;
}
