// A vertex of the grid from the wave map.
uniform sampler2D waveMap;
uniform sampler2D coverMap;
uniform bool coverIsOn;
uniform mat4 clipFromRelativeWorld;

out vec2 waveSlope;
out vec2 waveHeightAndMissingSlope;
out vec3 waterCover;

void main() {
  int columns = textureSize(waveMap, 0).x;
  ivec2 texel = ivec2(gl_VertexID % columns, gl_VertexID / columns);
  vec4 waves = texelFetch(waveMap, texel, 0);
  vec2 point = gridPoint(rows[texel.y].line, float(texel.x));
  gl_Position = clipFromRelativeWorld * vec4(curvedPosition(point, waves.x), 1.0);
  waveSlope = waves.yz;
  waveHeightAndMissingSlope = waves.xw;
  waterCover = coverIsOn ? texelFetch(coverMap, texel, 0).rgb : vec3(0.0);
}
