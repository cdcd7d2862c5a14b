// Where a point of the sea lies relative to the camera: as seaDrop in surface/curvature.h.
uniform float eyeHeight;   // m above still water
uniform float curvature;   // 1/(2R), 1/m

vec3 curvedPosition(vec2 point, float height) {
  return vec3(point, height - dot(point, point) * curvature - eyeHeight);
}
