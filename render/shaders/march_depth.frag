// Depth of the marched surface, for the objects that are drawn after it.
uniform sampler2D distanceMap;
uniform float nearDistance;

void main() {
  float distance = texelFetch(distanceMap, ivec2(gl_FragCoord.xy), 0).r;
  if (distance <= 0.0) discard;
  gl_FragDepth = nearDistance / distance;
}
