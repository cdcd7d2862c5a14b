// The wave field's octaves in single precision. Compiled twice: as GLSL, and as C++ with GLM
// (render/field_twin.cpp), which must give the same bits on llvmpipe. Hence no sin, no exp, no mix,
// Horner as c*x + d, f on every literal. The formulas are those of surface/field/kernels.
//
// A coordinate vec4 holds a gradient per metre in xy and the value at the origin in z, in lattice
// cells from the middle of the origin's cell, or in turns from the nearest whole one.

struct SineCosine {
  float sine, cosine;
};

struct Blend {
  float before, after, rate;
};

struct Corner {
  float a, b;
};

struct Column {
  float value, across, byPhase;
};

struct Row {
  float ramp, rampSlope, gradientY;
};

float coordinateAt(vec4 coordinate, vec2 point) {
  exact float sum = coordinate.x * point.x + coordinate.y * point.y;
  return sum + coordinate.z;
}

float nearest(float x) { return floor(x + 0.5f); }

uint cellOf(float whole) { return uint(int(whole)); }

uint cornerHash(uint x, uint y) {
  uint h = (x ^ y) * 0x2C1B3C6Du;
  h = h ^ (h >> 15u);
  h = h * 0x297A2D39u;
  return h ^ (h >> 16u);
}

// sin 2πp and cos 2πp, p in [-½, ½].
SineCosine sineCosineTurns(float turns) {
  exact float q = turns * turns;
  exact float s = 3.058325f * q + -9.53079904f;
  s = s * q + 16.7609745f;
  s = s * q + -16.2086703f;
  s = s * q + 6.2831826f;
  exact float c = -0.397413859f * q + 1.58899844f;
  c = c * q + -3.65806692f;
  c = c * q + 5.11148042f;
  c = c * q + -3.73918126f;
  c = c * q + 0.999999493f;
  exact float zeroAtHalf = -4.0f * q + 1.0f;
  exact float zeroAtQuarter = -16.0f * q + 1.0f;
  exact SineCosine result;
  result.sine = (turns * zeroAtHalf) * s;
  result.cosine = zeroAtQuarter * c;
  return result;
}

// Weights of a cell's corners at `rest` in [-½, ½] from its middle, and their angle's rate over its
// largest.
Blend blendAt(float rest) {
  exact float squared = rest * rest;
  exact float angle = 9.42477796f * squared + -7.85398163f;
  angle = angle * squared + 2.94524311f;
  exact float theta = rest * angle;
  exact float theta2 = theta * theta;
  exact float odd = 0.00574280867f * theta2 + -0.117805135f;
  odd = odd * theta2 + 0.707103244f;
  odd = theta * odd;
  exact float even = -0.000960668804f * theta2 + 0.029454552f;
  even = even * theta2 + -0.353552377f;
  even = even * theta2 + 0.707106762f;
  exact float edge = -4.0f * squared + 1.0f;
  exact Blend result;
  result.before = even - odd;
  result.after = even + odd;
  result.rate = edge * edge;
  return result;
}

// The two envelope values of a corner: differences of pairs of its hash's nibbles.
Corner cornerAt(uint x, uint y) {
  uint hash = cornerHash(x, y);
  uint pairs = (hash & 0x0F0F0F0Fu) + ((hash >> 4u) & 0x0F0F0F0Fu);
  Corner result;
  result.a = float(int(pairs & 0xFFu) - int((pairs >> 8u) & 0xFFu));
  result.b = float(int((pairs >> 16u) & 0xFFu) - int(pairs >> 24u));
  return result;
}

Column carriedColumn(Corner c0, Corner c1, SineCosine carrier, Blend across) {
  exact float value0 = c0.b * carrier.sine + c0.a * carrier.cosine;
  exact float value1 = c1.b * carrier.sine + c1.a * carrier.cosine;
  exact float phase0 = c0.b * carrier.cosine - c0.a * carrier.sine;
  exact float phase1 = c1.b * carrier.cosine - c1.a * carrier.sine;
  exact Column result;
  result.value = across.after * value1 + across.before * value0;
  result.across = across.before * value1 - across.after * value0;
  result.byPhase = across.after * phase1 + across.before * phase0;
  return result;
}

// Height and slope of a group octave.
vec3 groupOctave(TwinOctave octave, vec2 point) {
  exact float along = coordinateAt(octave.first, point);
  exact float across = coordinateAt(octave.second, point);
  exact float turns = coordinateAt(octave.third, point);
  float wholeAlong = nearest(along);
  float wholeAcross = nearest(across);
  uint x = octave.seeds.x + cellOf(wholeAlong) * 0x9E3779B1u;
  uint y = octave.seeds.y + cellOf(wholeAcross) * 0x85EBCA77u;
  uint xAfter = x + 0x9E3779B1u;
  uint yAfter = y + 0x85EBCA77u;
  Blend blend = blendAt(along - wholeAlong);
  Blend sideways = blendAt(across - wholeAcross);
  SineCosine carrier = sineCosineTurns(turns - nearest(turns));
  Column before = carriedColumn(cornerAt(x, y), cornerAt(x, yAfter), carrier, sideways);
  Column after = carriedColumn(cornerAt(xAfter, y), cornerAt(xAfter, yAfter), carrier, sideways);
  exact float value = blend.after * after.value + blend.before * before.value;
  exact float byPhase = blend.after * after.byPhase + blend.before * before.byPhase;
  exact float byAlong = blend.before * after.value - blend.after * before.value;
  byAlong = byAlong * blend.rate;
  exact float byAcross = blend.after * after.across + blend.before * before.across;
  byAcross = byAcross * sideways.rate;
  // Per turn and per cell: 2π, and the blending angle's largest rate, 15π/16.
  byPhase = 6.28318531f * byPhase;
  byAlong = 2.94524311f * byAlong;
  byAcross = 2.94524311f * byAcross;
  exact float slopeX = byAlong * octave.first.x + byAcross * octave.second.x;
  slopeX = byPhase * octave.third.x + slopeX;
  exact float slopeY = byAlong * octave.first.y + byAcross * octave.second.y;
  slopeY = byPhase * octave.third.y + slopeY;
  exact vec3 result = vec3(value * octave.first.w, slopeX * octave.first.w,
                           slopeY * octave.first.w);
  return result;
}

// Height and slope of a regular wave.
vec3 regularOctave(TwinOctave octave, vec2 point) {
  exact float turns = coordinateAt(octave.first, point);
  SineCosine carrier = sineCosineTurns(turns - nearest(turns));
  exact float byPhase = -6.28318531f * carrier.sine;
  exact vec3 result = vec3(carrier.cosine * octave.first.w,
                           (byPhase * octave.first.x) * octave.first.w,
                           (byPhase * octave.first.y) * octave.first.w);
  return result;
}

// Quintic fade and its slope at `rest` from the middle of a cell.
vec2 fadeAt(float rest) {
  exact float squared = rest * rest;
  exact float odd = 6.0f * squared + -5.0f;
  odd = odd * squared + 1.875f;
  exact float edge = -4.0f * squared + 1.0f;
  exact float weight = rest * odd + 0.5f;
  exact float slope = (edge * edge) * 1.875f;
  return vec2(weight, slope);
}

float centredByte(uint hash) { return float(int(hash & 0xFFu)) - 127.5f; }

// A corner's gradient: those of the slices before and after t, weighted.
vec2 gradientAt(uint before, uint after, vec2 weights) {
  exact float x = centredByte(before) * weights.x + centredByte(after) * weights.y;
  exact float y = centredByte(before >> 8u) * weights.x + centredByte(after >> 8u) * weights.y;
  return vec2(x, y);
}

float blended(float a, float b, float weight) {
  exact float result = (b - a) * weight + a;
  return result;
}

Row rowOf(vec2 before, vec2 after, float toBefore, float toAfter, float dy, vec2 fade) {
  exact float ramp0 = before.x * toBefore + before.y * dy;
  exact float ramp1 = after.x * toAfter + after.y * dy;
  exact Row result;
  result.ramp = blended(ramp0, ramp1, fade.x);
  result.rampSlope = (ramp1 - ramp0) * fade.y + blended(before.x, after.x, fade.x);
  result.gradientY = blended(before.y, after.y, fade.x);
  return result;
}

// Height and slope of a Perlin octave.
vec3 perlinOctave(TwinOctave octave, vec2 point) {
  exact float first = coordinateAt(octave.first, point);
  exact float second = coordinateAt(octave.second, point);
  float column = nearest(first);
  float line = nearest(second);
  exact float dx = first - column;
  exact float dy = second - line;
  uint x = cellOf(column) * 0x9E3779B1u;
  uint y = cellOf(line) * 0x85EBCA77u;
  uvec2 left = uvec2(x + octave.seeds.x, x + octave.seeds.y);
  uvec2 right = uvec2(left.x + 0x9E3779B1u, left.y + 0x9E3779B1u);
  uvec2 low = uvec2(y + octave.seeds.z, y + octave.seeds.w);
  uvec2 high = uvec2(low.x + 0x85EBCA77u, low.y + 0x85EBCA77u);
  vec2 weights = vec2(octave.third.x, octave.third.y);
  vec2 fadeX = fadeAt(dx);
  vec2 fadeY = fadeAt(dy);
  Row lower = rowOf(
      gradientAt(cornerHash(left.x, low.x), cornerHash(left.y, low.y), weights),
      gradientAt(cornerHash(right.x, low.x), cornerHash(right.y, low.y), weights), dx + 0.5f,
      dx - 0.5f, dy + 0.5f, fadeX);
  Row upper = rowOf(
      gradientAt(cornerHash(left.x, high.x), cornerHash(left.y, high.y), weights),
      gradientAt(cornerHash(right.x, high.x), cornerHash(right.y, high.y), weights), dx + 0.5f,
      dx - 0.5f, dy - 0.5f, fadeX);
  exact float value = blended(lower.ramp, upper.ramp, fadeY.x);
  exact float byFirst = blended(lower.rampSlope, upper.rampSlope, fadeY.x);
  exact float bySecond = (upper.ramp - lower.ramp) * fadeY.y +
                         blended(lower.gradientY, upper.gradientY, fadeY.x);
  exact float slopeX = byFirst * octave.first.x + bySecond * octave.second.x;
  exact float slopeY = byFirst * octave.first.y + bySecond * octave.second.y;
  exact vec3 result = vec3(value * octave.first.w, slopeX * octave.first.w,
                           slopeY * octave.first.w);
  return result;
}

// How much of an octave a grid row carries: band holds the wavelengths carried in full and in part,
// and the part.
float carriedPart(float wavelength, vec4 band) {
  return wavelength >= band.x ? 1.0f : (wavelength >= band.y ? band.z : 0.0f);
}
