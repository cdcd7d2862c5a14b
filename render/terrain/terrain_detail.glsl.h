// What ground looks like from near: one text that GLSL and C++ (terrain_skin.cpp) compile, a pixel
// at a time. It keeps to what both understand: no swizzles.

SHADER uint groundHash(uint x, uint y) {
  uint h = (x * 0x9E3779B1u) ^ (y * 0x85EBCA77u);
  h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
  h = (h ^ (h >> 12)) * 0x297A2D39u;
  return h ^ (h >> 15);
}

SHADER float groundKnot(int x, int y) {
  return float(groundHash(uint(x), uint(y)) >> 8) * (2.0f / 16777216.0f) - 1.0f;
}

// Noise between knots a unit apart, [-1, 1].
SHADER float groundNoise(vec2 place) {
  vec2 corner = floor(place);
  vec2 part = place - corner;
  float u = part.x * part.x * (3.0f - 2.0f * part.x);
  float v = part.y * part.y * (3.0f - 2.0f * part.y);
  int x = int(corner.x);
  int y = int(corner.y);
  float low = mix(groundKnot(x, y), groundKnot(x + 1, y), u);
  float high = mix(groundKnot(x, y + 1), groundKnot(x + 1, y + 1), u);
  return mix(low, high, v);
}

// Grain of three sizes, each as far as a pixel of `footprint` m shows it, about [-1, 1].
SHADER float groundGrain(vec2 place, float footprint) {
  float grain = 0.0f;
  float size = 6.1f;
  for (int i = 0; i < 4; ++i) {
    float shown = clamp(2.0f - 4.0f * footprint / size, 0.0f, 1.0f);
    if (shown > 0.0f) {
      vec2 turned = vec2(0.8f * place.x - 0.6f * place.y, 0.6f * place.x + 0.8f * place.y);
      grain += 0.45f * shown * groundNoise(turned / size + vec2(float(7 * i), float(-3 * i)));
    }
    size = size * 0.23f;
  }
  return grain;
}

// Reflectance of ground whose own is `dry`, at a height above the still water: water that runs up
// wets it to `wetHeight` m and leaves an uneven rim.
SHADER vec3 groundReflectance(vec3 dry, float height, float wetHeight, float grain) {
  float rim = height - 0.25f * wetHeight * grain;
  float wet = 1.0f - smoothstep(0.6f * wetHeight, 1.1f * wetHeight, rim);
  return dry * ((1.0f - 0.45f * wet) * (1.0f + 0.22f * grain));
}
