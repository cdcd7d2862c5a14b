// A wake window over the texels of the wave map: WakePyramid::addTo, by the row's spacing.
// Coefficients: level 0 on the left, the others one above the other on its right. As mip levels
// they would not do: llvmpipe fetches all pixels of a quad from one.
uniform sampler2D spline;
uniform sampler3D missingSlope;  // by blocks; depth is the level
uniform vec2 origin;             // camera's foot in the window's grid, in sizes
uniform vec2 centre;             // of the window, m from the foot
uniform float size, cell;        // m
uniform int levels, cells0;

layout(location = 0) out vec4 waves;

vec4 splineWeights(float t) {
  float u = 1.0 - t;
  return vec4(u * u * u / 6.0, 2.0 / 3.0 - t * t * (1.0 - 0.5 * t),
              2.0 / 3.0 - u * u * (1.0 - 0.5 * u), t * t * t / 6.0);
}
vec4 splineSlopes(float t) {
  float u = 1.0 - t;
  return vec4(-0.5 * u * u, t * (1.5 * t - 2.0), u * (2.0 - 1.5 * u), 0.5 * t * t);
}

// Height and slope, m and 1, at a place in sizes of the window.
vec3 levelAt(int level, vec2 place) {
  if (level >= levels) return vec3(0.0);
  int cells = cells0 >> level;
  ivec2 corner = level == 0 ? ivec2(0) : ivec2(cells0, cells0 - 2 * cells);
  vec2 at = place * float(cells), low = floor(at), part = at - low;
  ivec2 first = ivec2(low) - 1;
  vec4 across = splineWeights(part.x), along = splineSlopes(part.x);
  vec4 up = splineWeights(part.y), rise = splineSlopes(part.y);
  vec3 sum = vec3(0.0);
  for (int r = 0; r < 4; ++r) {
    vec4 row;
    for (int c = 0; c < 4; ++c) {
      row[c] = texelFetch(spline, corner + ((first + ivec2(c, r)) & (cells - 1)), 0).x;
    }
    float value = dot(across, row);
    sum += vec3(up[r] * value, up[r] * dot(along, row), rise[r] * value);
  }
  return vec3(sum.x, sum.yz * (float(cells) / size));
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  TwinRow row = rows[texel.y];
  vec2 point = gridPoint(row.line, float(texel.x));
  if (any(greaterThanEqual(abs(point - centre), vec2(0.5 * size)))) discard;
  vec2 place = origin + point / size;
  // Waves of four spacings are carried.
  float level = clamp(log2(max(0.25 * row.band.x / cell, 1.0)), 0.0, float(levels));
  int finer = int(level);
  float share = level - float(finer);
  vec3 surface = levelAt(finer, place);
  if (share > 0.0) surface = mix(surface, levelAt(finer + 1, place), share);
  float missing = texture(missingSlope, vec3(place, (level + 0.5) / float(levels + 1))).x;
  waves = vec4(surface, missing);
}
