layout(location = 0) in vec4 texels;  // first column and row, one past the last of each
layout(location = 1) in vec4 placed;  // centre, m from the camera's foot; first axis
layout(location = 2) in vec4 halfAndHeight;

uniform vec2 mapSize;

flat out vec4 stampPlaced;
flat out vec4 stampHalfAndHeight;

void main() {
  vec2 texel = vec2((gl_VertexID & 1) != 0 ? texels.z : texels.x,
                    (gl_VertexID & 2) != 0 ? texels.w : texels.y);
  gl_Position = vec4(2.0 * texel / mapSize - 1.0, 0.0, 1.0);
  stampPlaced = placed;
  stampHalfAndHeight = halfAndHeight;
}
