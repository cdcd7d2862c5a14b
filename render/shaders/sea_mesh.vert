// A vertex of the grid from the wave map.
uniform sampler2D waveMap;
uniform mat4 clipFromRelativeWorld;

out vec2 waveSlope;
out vec2 waveHeightAndMissingSlope;

void main() {
  int columns = textureSize(waveMap, 0).x;
  ivec2 texel = ivec2(gl_VertexID % columns, gl_VertexID / columns);
  vec4 waves = texelFetch(waveMap, texel, 0);
  vec2 point = gridPoint(rows[texel.y].line, float(texel.x));
  gl_Position = clipFromRelativeWorld * vec4(curvedPosition(point, waves.x), 1.0);
  waveSlope = waves.yz;
  waveHeightAndMissingSlope = waves.xw;
}
