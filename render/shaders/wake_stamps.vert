uniform vec4 texels;  // first column and row, one past the last of each
uniform vec2 mapSize;

void main() {
  vec2 texel = vec2((gl_VertexID & 1) != 0 ? texels.z : texels.x,
                    (gl_VertexID & 2) != 0 ? texels.w : texels.y);
  gl_Position = vec4(2.0 * texel / mapSize - 1.0, 0.0, 1.0);
}
