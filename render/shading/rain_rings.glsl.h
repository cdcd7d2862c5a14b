// Rings of raindrops about a pixel: Rain::at (surface/disturbance/analytic/rain.h) in the common
// subset of GLSL and C++ (sea_shading.glsl.h says how). `Word` is an unsigned integer that differs
// between pixels.

SHADER Word rainHash(Word x, Word y, Word seedX, Word seedY) {
  Word h = ((x * word(0x9E3779B1u) + seedX) ^ (y * word(0x85EBCA77u) + seedY)) * word(0x2C1B3C6Du);
  h = h ^ shiftedDown(h, 15);
  h = h * word(0x297A2D39u);
  return h ^ shiftedDown(h, 16);
}

SHADER Real unitOf(Word bits) { return realOf(bits & word(0xFFFFu)) * (1.0f / 65536.0f); }

// Slope of one drop's ring at `off` from its place.
SHADER Real2 ringSlope(Real2 off, Real part) {
  Real r = sqrt(dot(off, off) + 1e-4f);
  Real age = part * rainLifetime;
  Real behind = r - rainSpeed * age;
  Real u = behind * (1.0f / rainHalfWidth);
  Real inside = max(1.0f - u * u, 0.0f);
  Real left = 1.0f - part;
  Real risen = min(part * 10.0f, 1.0f);
  Real strength = rainHeight * left * left * (risen * risen * (3.0f - 2.0f * risen));
  Real turns = behind * (1.0f / rainWavelength);
  Real2 wave = cosineAndSine(turns);
  Real byDistance = strength * (-4.0f * u * (1.0f / rainHalfWidth) * inside * wave.x -
                                inside * inside * (6.2831853f / rainWavelength) * wave.y);
  return off * (byDistance / r);
}

// Slope of all rings, at `relative` m from the camera's foot.
SHADER Real2 rainSlopeAt(Real2 relative) {
  Real x = relative.x + rainFoot.x, y = relative.y + rainFoot.y;  // m from the foot's cell
  Real left = floor(x * (1.0f / rainCellSize) - 0.5f);
  Real low = floor(y * (1.0f / rainCellSize) - 0.5f);
  Real2 sum = Real2(0.0f, 0.0f);
  for (int c = 0; c < 4; ++c) {
    Real i = left + float(c % 2), j = low + float(c / 2);
    Word column = wordOf(i) + word(rainColumn), row = wordOf(j) + word(rainRow);
    Real inX = x - i * rainCellSize, inY = y - j * rainCellSize;
    for (int slot = 0; slot < rainSlots; ++slot) {
      uint number = rainSeed + 2u * uint(slot);
      Real offset = unitOf(rainHash(column, row, word(rainSeed), word(number)));
      Real part = offset + rainPart;
      Word count = word(rainCount) + wordOf(floor(part));
      part = part - floor(part);
      Word place =
          rainHash(column, row, word(rainSeed) + count * word(0x297A2D39u), word(number + 1u));
      Real2 off = Real2(inX - unitOf(place) * rainCellSize,
                        inY - unitOf(shiftedDown(place, 16)) * rainCellSize);
      Real falls = choose(offset + float(slot) < Real(rainDrops), Real(1.0f), Real(0.0f));
      sum = sum + ringSlope(off, part) * falls;
    }
  }
  return sum;
}

// Adds the rings to the slope; what the pixel cannot show of them is returned as mean-square slope.
SHADER Real addRain(Real3 relative, Real footprint, INOUT(Real2) slope) {
  Real kept =
      1.0f - smoothstep(Real(0.25f * rainWavelength), Real(0.7f * rainWavelength), footprint);
  if (anyOf(kept > 0.0f)) slope = slope + rainSlopeAt(Real2(relative.x, relative.y)) * kept;
  return rainMeanSquare * (1.0f - kept * kept);
}
