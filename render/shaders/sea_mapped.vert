// A vertex from the processor, and where it lies in the wave map.
layout(location = 0) in vec3 position;  // relative to the camera, m

uniform mat4 clipFromRelativeWorld;
uniform ivec2 vertices;  // of the coarse grid, across and along
uniform sampler2D waveMap;

out vec2 mapCoordinate;

void main() {
  gl_Position = clipFromRelativeWorld * vec4(position, 1.0);
  vec2 part = vec2(gl_VertexID % vertices.x, gl_VertexID / vertices.x) / vec2(vertices - 1);
  vec2 texels = vec2(textureSize(waveMap, 0));
  mapCoordinate = (part * (texels - 1.0) + 0.5) / texels;
}
