// Takes the sea out of a hollow of an open hull: the twin of cutHollows. Reads the texel of the
// distance that it writes.
in vec2 screen;

uniform sampler2D distanceMap;
uniform vec3 middleRay, right, up;
uniform vec4 planes[12];  // relative to the camera
uniform int planeCount;

layout(location = 2) out float signedDistance;

void main() {
  float water = texelFetch(distanceMap, ivec2(gl_FragCoord.xy), 0).r;
  if (water <= 0.0) discard;
  vec3 place = water * (middleRay + screen.x * right + screen.y * up);
  for (int i = 0; i < planeCount; ++i) {
    if (dot(planes[i].xyz, place) >= planes[i].w) discard;
  }
  signedDistance = 0.0;
  gl_FragDepth = 0.0;
}
