uniform sampler2D fresnelTable;  // (reflectance, tilt, area) by √cosine and slope deviation
uniform float roughestSlope;     // slope deviation at the table's end
uniform sampler2D rippleMap;     // (slope.xy, |slope|²) of unit mean square, by mip level
uniform bool ripplesAreOn;
uniform mat2 rippleFromWorld[2];  // texture coordinates from metres
uniform vec2 rippleOrigin[2];     // texture coordinates of the camera's foot point
uniform float rippleSlope;        // mean square of each layer
uniform float rippleTexels;       // side of rippleMap
uniform float hairSlope;          // mean-square slope of what is finer than ripples
uniform float crestHeight;        // m: significant amplitude
uniform float pixelAngle;         // rad

const vec3 crestTransmission = vec3(0.020, 0.110, 0.095);

// Adds ripples finer than the field to the slope; what the pixel cannot show of them is returned
// as mean-square slope.
float addRipples(vec3 relative, float distance, float cosine, inout vec2 slope) {
  if (!ripplesAreOn) return 0.0;
  float left = 0.0;
  for (int i = 0; i < 2; ++i) {
    vec2 coordinate = rippleOrigin[i] + rippleFromWorld[i] * relative.xy;
    float perMetre = length(rippleFromWorld[i][0]) * rippleTexels;
    float footprint = 1.4 * distance * pixelAngle * inversesqrt(max(cosine, 0.02)) * perMetre;
    vec3 moments = textureLod(rippleMap, coordinate, log2(max(footprint, 1e-6))).xyz;
    mat2 worldFromRipple = transpose(rippleFromWorld[i]) / length(rippleFromWorld[i][0]);
    slope += sqrt(rippleSlope) * (worldFromRipple * moments.xy);
    left += rippleSlope * max(moments.z - dot(moments.xy, moments.xy), 0.0);
  }
  return left;
}

// Sun mirrored by facets of Gaussian slopes (Cox & Munk's picture): irradiance × Fresnel × density
// of the slope that mirrors, over 4 cos⁴ of its tilt and the area the viewer sees.
vec3 glitter(vec3 toViewer, vec2 slope, float variance, float area) {
  vec3 halfway = toViewer + sunDirection;
  if (halfway.z <= 1e-3) return vec3(0.0);
  halfway = normalize(halfway);
  vec2 off = -halfway.xy / halfway.z - slope;
  // The sun is half a degree wide; that alone spreads the slopes that mirror it.
  float spread = variance + 1.2e-5;
  float density = exp(-0.5 * dot(off, off) / spread) / (2.0 * pi * spread);
  float sunArea = texture(fresnelTable, vec2(sqrt(max(sunDirection.z, 0.0)),
                                             sqrt(variance) / roughestSlope)).z;
  float lit = clamp(max(sunDirection.z, 0.0) / max(sunArea, 1e-3), 0.0, 1.0);
  float cosine = max(dot(toViewer, halfway), 0.0);
  float tilted = halfway.z * halfway.z;
  return sunLight * lit * fresnel(cosine, 1.34) * density /
         (4.0 * tilted * tilted * max(area, 0.02));
}

vec3 upwelling(vec3 toViewer, vec2 slope, float height) {
  // Thin crests let light through where the viewer looks at them from the side, most towards the
  // sun.
  float crest = clamp(0.5 + 0.5 * height / max(crestHeight, 0.02), 0.0, 1.5);
  float face = clamp(0.2 + 1.6 * dot(-slope, toViewer.xy), 0.0, 1.0) * (1.0 - toViewer.z);
  float against = pow(max(dot(-toViewer.xy, sunDirection.xy), 0.0), 2.0);
  return deepWater() + crestTransmission * crest * crest * face * min(crestHeight, 1.0) *
                           (0.08 * skyLight + 0.06 * against * sunLight);
}

vec3 shadeWater(vec4 surface, vec3 relative, float distance) {
  vec3 toViewer = -relative / distance;
  vec2 slope = surface.xy;
  vec3 normal = normalize(vec3(-slope, 1.0));
  float meanSquare = surface.z + hairSlope +
                     addRipples(relative, distance, max(dot(normal, toViewer), 0.0), slope);
  // Where the mean slope faces away, what is seen are facets that do not.
  vec2 towards = normalize(toViewer.xy + vec2(1e-6, 0.0));
  float facing = dot(vec3(-slope, 1.0), toViewer);
  slope += towards * min(facing, 0.0) / max(length(toViewer.xy), 0.1);
  normal = normalize(vec3(-slope, 1.0));
  float variance = 0.5 * meanSquare;  // along one axis
  float cosine = max(dot(normal, toViewer), 0.0);
  float deviation = sqrt(variance);
  vec3 rough = texture(fresnelTable, vec2(sqrt(cosine), deviation / roughestSlope)).xyz;

  vec3 tilted = normalize(vec3(-slope + rough.y * towards, 1.0));
  vec3 mirrored = reflect(-toViewer, tilted);
  mirrored.z = abs(mirrored.z);  // a ray that starts downwards is mirrored once more
  vec3 sky = blurredSky(normalize(mirrored), log2(1.0 + 340.0 * deviation));

  vec3 colour = mix(upwelling(toViewer, slope, surface.w), sky, rough.x) +
                glitter(toViewer, slope, variance, rough.z);
  return hazed(colour, -toViewer, distance);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 relative = pixelRay() * texelFetch(distanceMap, pixel, 0).r;
  write(shadeWater(texelFetch(surfaceMap, pixel, 0), relative, length(relative)));
}
