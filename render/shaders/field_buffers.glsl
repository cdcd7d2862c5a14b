// The field's octaves and the grid's rows, as FieldTwin and WaveMap upload them.
struct TwinOctave {
  vec4 first, second, third;
  uvec4 seeds;
};

struct TwinRow {
  vec4 line;  // first point in xy, step to the next column in zw, m from the camera's foot
  vec4 band;  // wavelengths carried in full and in part, the part, mean-square slope left out
};

layout(std140, binding = 0) uniform FieldBlock {
  ivec4 counts;  // group, Perlin, regular
  TwinOctave octaves[1000];
};

layout(std430, binding = 0) readonly buffer RowBlock {
  TwinRow rows[];
};

vec2 gridPoint(vec4 line, float column) {
  exact vec2 result = vec2(column * line.z + line.x, column * line.w + line.y);
  return result;
}
