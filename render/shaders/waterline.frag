// Tells the pixels of water that are under it: those of the stencil that this is drawn over.
uniform sampler2D waterlineMap;  // Waterline: top row first
uniform vec2 perPixel;           // cells
uniform int height;              // pixels

void main() {
  vec2 at = vec2(gl_FragCoord.x, float(height) - gl_FragCoord.y) * perPixel;
  vec2 cells = vec2(textureSize(waterlineMap, 0) - 1);
  ivec2 low = ivec2(min(floor(at), cells - 1.0));
  vec2 part = at - vec2(low);
  float upper = mix(texelFetch(waterlineMap, low, 0).r,
                    texelFetch(waterlineMap, low + ivec2(1, 0), 0).r, part.x);
  float lower = mix(texelFetch(waterlineMap, low + ivec2(0, 1), 0).r,
                    texelFetch(waterlineMap, low + ivec2(1, 1), 0).r, part.x);
  if (mix(upper, lower, part.y) >= 0.0) discard;
}
