// One texel of the wave map, a vertex of the grid: height, slope, mean-square slope left out.
uniform sampler2D stamps;
uniform bool stampsAreOn;
uniform sampler2D extras;
uniform bool extrasAreOn;

vec4 waveTexel(ivec2 texel) {
  TwinRow row = rows[texel.y];
  vec2 point = gridPoint(row.line, float(texel.x));
  // Outside the outline the sea lies as the ground does.
  if (outlineIsOn && !isWater(point)) return vec4(0.0, 0.0, 0.0, row.band.w);
  vec3 waves = wavesAt(point, row.band);
  vec4 result = vec4(waves, row.band.w);
  if (stampsAreOn) result += texelFetch(stamps, texel, 0);
  if (extrasAreOn) result += texelFetch(extras, texel, 0);
  return result;
}

// What is noted of a frame's vertices. The bits of floats above 0 grow with them.
layout(std430, binding = 1) buffer TallyBlock {
  uint largestHeight;
  uint verticesInFrustum;
  uint largestSlope;
};

uniform vec3 axialFromWorld, xFromWorld, yFromWorld;  // x and y are 1 at the image's edge per axial
uniform float nearDistance;

bool isInFrustum(ivec2 texel, float height) {
  vec3 relative = curvedPosition(gridPoint(rows[texel.y].line, float(texel.x)), height);
  float axial = dot(relative, axialFromWorld);
  return axial >= nearDistance && abs(dot(relative, xFromWorld)) <= axial &&
         abs(dot(relative, yFromWorld)) <= axial;
}
