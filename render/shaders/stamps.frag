flat in vec4 stampPlaced;
flat in vec4 stampHalfAndHeight;

layout(location = 0) out vec4 waves;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  TwinRow row = rows[texel.y];
  vec2 offset = gridPoint(row.line, float(texel.x)) - stampPlaced.xy;
  vec2 along = stampPlaced.zw, across = vec2(-along.y, along.x);
  vec2 halfSize = stampHalfAndHeight.xy;
  vec2 local = vec2(dot(offset, along), dot(offset, across)) / halfSize;
  if (any(greaterThan(abs(local), vec2(1.0)))) discard;
  vec3 shape = stampShape(local) * stampHalfAndHeight.z;
  // As octaves fade: four spacings carry a wave in full, two not at all.
  float wavelength = 4.0 * min(halfSize.x, halfSize.y);
  float part = smoothstep(0.5 * row.band.x, max(row.band.x, 1e-6), wavelength);
  vec2 slope = along * (shape.y / halfSize.x) + across * (shape.z / halfSize.y);
  waves = part * vec4(shape.x, slope, 0.0);
}
