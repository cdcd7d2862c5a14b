// Tells water from ground: the twin of Shore::fillSpan, before objects are drawn. Reads the texel
// of the distance that it writes.
in vec2 screen;

uniform sampler2D distanceMap;
uniform vec3 middleRay, right, up;
uniform float eyeHeight, curvature, nearDistance;
uniform vec3 groundReflectance;

layout(location = 0) out vec4 surface;
layout(location = 1) out vec4 albedo;
layout(location = 2) out float signedDistance;

const float nowhere = 3e38;

float stillWaterAlong(float sink, float bend) {
  float under = sink * sink - 4.0 * bend * eyeHeight;
  if (under < 0.0) return nowhere;
  float q = -0.5 * (sink + (sink < 0.0 ? -1.0 : 1.0) * sqrt(under));
  float a = bend > 0.0 ? q / bend : nowhere, b = q != 0.0 ? eyeHeight / q : nowhere;
  return min(a > nearDistance ? a : nowhere, b > nearDistance ? b : nowhere);
}

void main() {
  float water = texelFetch(distanceMap, ivec2(gl_FragCoord.xy), 0).r;
  vec3 ray = middleRay + screen.x * right + screen.y * up;
  bool dry = water > 0.0 && !isWater(ray.xy * water);
  float still = stillWaterAlong(ray.z, dot(ray.xy, ray.xy) * curvature);
  float shown = water > 0.0 && !dry ? water : nowhere;
  bool behind = still < shown && !isWater(ray.xy * still);
  if (!dry && !behind) discard;
  float distance = behind ? still : water;
  surface = vec4(0.0, 0.0, 1.0, 0.0);
  albedo = vec4(groundReflectance, 0.0);  // alpha tells ground from objects
  signedDistance = -distance;
  gl_FragDepth = nearDistance / distance;
}
