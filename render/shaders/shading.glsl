// What shading of sky, water and objects has in common.

in vec2 screen;
flat in vec3 sunLight;
flat in vec3 skyLight;

uniform sampler2D surfaceMap;
uniform sampler2D albedoMap;
uniform sampler2D distanceMap;
uniform vec3 forward, right, up;  // view axes; right and up as long as half the image plane
uniform bool cameraIsUnderWater;

layout(location = 0) out vec4 radiance;

const vec3 deepReflectance = vec3(0.0050, 0.0300, 0.0520);  // of light below the surface
const vec3 waterExtinction = vec3(0.40, 0.075, 0.055);      // 1/m
const float visibility = 28e3;                              // m, at 2 % contrast

vec3 pixelRay() { return forward + screen.x * right + screen.y * up; }

// Mean radiance of sky and sunlight on the sea's level.
vec3 daylightOnSea() { return skyLight + sunLight * max(sunDirection.z, 0.0) / pi; }

vec3 deepWater() { return deepReflectance * daylightOnSea(); }

// Air puts the sky just above the horizon in front of everything far away.
vec3 hazed(vec3 colour, vec3 direction, float distance) {
  vec3 level = vec3(normalize(direction.xy + vec2(1e-6, 0.0)), 0.0);
  return mix(blurredSky(level, 0.0), colour, exp(-3.912 * distance / visibility));
}

vec3 throughWater(vec3 colour, float distance) {
  return mix(1.6 * deepWater(), colour, exp(-waterExtinction * distance));
}

float fresnel(float cosine, float index) {
  float sineSquared = (1.0 - cosine * cosine) / (index * index);
  if (sineSquared >= 1.0) return 1.0;
  float refracted = sqrt(1.0 - sineSquared);
  float a = (cosine - index * refracted) / (cosine + index * refracted);
  float b = (index * cosine - refracted) / (index * cosine + refracted);
  return 0.5 * (a * a + b * b);
}

vec3 sunDisc(vec3 direction) {
  float angle = acos(clamp(dot(direction, sunDirection), -1.0, 1.0));
  float disc = 1.0 - smoothstep(0.0052, 0.0068, angle);
  float glare = 0.012 * exp(-angle * 22.0) + 0.10 * exp(-angle * 120.0);
  return sunLight * (6.0 * disc + glare);
}

void write(vec3 colour) { radiance = vec4(min(colour, vec3(6e4)), 1.0); }
