// Clear maritime air over the sea: sunlight scattered once in a plane-parallel layer (closed form),
// with an isotropic term for light scattered more often. Radiance in units in which the sun's
// irradiance above the atmosphere is `solar`.

const float pi = 3.14159265;
const vec3 solar = vec3(20.0, 19.6, 18.6);
const vec3 rayleigh = vec3(0.046, 0.108, 0.262);  // zenith optical depth at 650, 550, 440 nm
const vec3 aerosol = vec3(0.050, 0.055, 0.060);

// Path through the air in zenith paths; 33 at the horizon.
float airMass(float sineOfElevation) {
  float s = max(sineOfElevation, 0.0);
  return 1.0 / (s + 0.03 * exp(-9.0 * s));
}

// Sunlight that reaches the sea, on a plane that faces the sun. The disc sets over half a degree.
vec3 sunIrradiance(vec3 sun) {
  return solar * exp(-(rayleigh + aerosol) * airMass(sun.z)) * smoothstep(-0.01, 0.01, sun.z);
}

// What is left of scattered light after sunset.
float daylight(vec3 sun) { return exp(30.0 * min(sun.z + 0.01, 0.0)); }

vec3 skyRadiance(vec3 direction, vec3 sun) {
  float cosine = dot(direction, sun);
  float seen = airMass(direction.z), lit = airMass(sun.z);
  vec3 depth = rayleigh + aerosol;
  float g = 0.76;
  float rayleighPhase = 3.0 / (16.0 * pi) * (1.0 + cosine * cosine);
  float aerosolPhase =
      (1.0 - g * g) / (4.0 * pi * pow(max(1.0 + g * g - 2.0 * g * cosine, 1e-3), 1.5));
  vec3 scattered = (rayleigh * rayleighPhase + 0.65 * aerosol * aerosolPhase) / depth;
  // Integral of exp(-t lit) exp(-(depth - t) seen) over the layer, stable where both are equal.
  vec3 x = depth * (seen - lit);
  vec3 safe = mix(x, vec3(1.0), lessThan(abs(x), vec3(1e-3)));
  vec3 shape = mix((1.0 - exp(-safe)) / safe, vec3(1.0), lessThan(abs(x), vec3(1e-3)));
  vec3 once = scattered * depth * seen * exp(-depth * lit) * shape;
  vec3 often = 0.055 * (1.0 - exp(-(rayleigh + 0.6 * aerosol) * seen)) *
               exp(-0.14 * depth * lit);
  return solar * (once + often) * daylight(sun) + vec3(0.6, 1.0, 1.8) * 1e-3;
}

uint scramble(uvec2 cell) {
  uint h = cell.x * 0x9E3779B1u ^ cell.y * 0x85EBCA77u;
  h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
  h = (h ^ (h >> 13)) * 0x297A2D39u;
  return h ^ (h >> 16);
}

float valueNoise(vec2 p) {
  vec2 cell = floor(p), f = p - cell;
  f = f * f * (3.0 - 2.0 * f);
  uvec2 c = uvec2(ivec2(cell));
  vec4 corners = vec4(scramble(c), scramble(c + uvec2(1u, 0u)), scramble(c + uvec2(0u, 1u)),
                      scramble(c + uvec2(1u))) / 4294967296.0;
  return mix(mix(corners.x, corners.y, f.x), mix(corners.z, corners.w, f.x), f.y);
}

float clouds(vec2 p) {
  p += 0.35 * vec2(valueNoise(p * 0.7 + 11.0), valueNoise(p * 0.7 - 5.0));
  float sum = 0.0, amplitude = 0.5;
  for (int i = 0; i < 5; ++i) {
    sum += amplitude * valueNoise(p);
    p = mat2(1.55, 1.25, -1.25, 1.55) * p + 3.7;
    amplitude *= 0.5;
  }
  return sum;
}

// Sky without the sun's disc. Below the horizon it goes on as at the horizon.
vec3 skyWithClouds(vec3 direction, vec3 sun) {
  vec3 clear = skyRadiance(direction, sun);
  float up = max(direction.z, 0.0);
  vec2 overhead = direction.xy / (up + 0.10);
  // Long streaks: high thin cloud drawn out by the wind aloft.
  float density = smoothstep(0.47, 0.85, clouds(vec2(0.55, 1.5) * overhead + 2.3));
  float cover = 0.75 * density * smoothstep(0.015, 0.22, up);
  float forward = pow(max(dot(direction, sun), 0.0), 8.0);
  vec3 lit = sunIrradiance(sun) * (0.075 + 0.11 * forward) +
             0.6 * skyRadiance(vec3(0.0, 0.0, 1.0), sun) + 0.35 * clear;
  return mix(clear, lit, cover);
}

// Paraboloid map of the upper hemisphere.
vec2 domeFromDirection(vec3 direction) {
  return direction.xy / (1.0 + max(direction.z, 0.0)) * 0.5 + 0.5;
}
