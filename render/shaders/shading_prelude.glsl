// What sea_shading.glsl.h needs of its surroundings, in GLSL: a pixel at a time.
#define Real float
#define Real2 vec2
#define Real3 vec3
#define SHADER
#define INOUT(type) inout type
#define anyOf(condition) (condition)
#define choose(condition, yes, no) ((condition) ? (yes) : (no))

// ShadingConstants
uniform vec3 forward, middleRay, right, up;
uniform float pixelAngle;
uniform bool cameraIsUnderWater, sunIsOn, skyIsOn, ripplesAreOn;
uniform vec3 sunDirection, sunLight, skyLight;
uniform float seaDeviation, sunlitFacets, airExtinction, exposure;
uniform vec2 levelSun, aerosolShape;
uniform vec3 horizonRayleigh, horizonAerosol, horizonOften;
uniform bool hazeIsOn, twilightIsOn, moonIsOn, extinctionIsLinear, backFacesAreTilted;
uniform vec3 horizonSide, horizonArch, moonRayleigh, moonAerosol, discAxis;
uniform vec2 levelMoon;
uniform float discEdge, discLight, starLight;
uniform int specular, lampCount;
uniform vec3 lampPlace[16], lampLight[16];
uniform float lampWidth[16], lampShines[16];
uniform vec3 waterExtinction, deepWater, veil, crestSky, crestSun;
uniform float crestScale, rippleDeviation, hairSlope, rippleLastLevel;
uniform vec2 waveLean;
uniform vec2 rippleFromWorld[4];
uniform vec2 rippleOrigin[2], rippleAlong[2];
uniform float rippleTexelsPerMetre[2];
uniform float rippleKept[8];

uniform vec3 pixelRight, pixelDown;
uniform vec2 pixelMiddle;
uniform bool mirrorIsOn, belowIsOn;
uniform vec2 mirrorLeast, mirrorSize, belowLeast, belowSize;
uniform float mirrorNearest, mirrorFarthest, mirrorBend, shoreHardness;
uniform int mirrorSteps;

uniform bool windowIsOn, depthsAreOn, waterlineIsOn;
uniform vec2 windowLeast, windowSize, depthsLeast, depthsSize;
uniform float stillWater, shadowBase;
uniform vec3 sunInWater, eyeVeil, sunPartBelow;
uniform float sunThroughSurface;
uniform int toneCurve;
uniform bool dithers;
uniform vec2 waterlinePerPixel;
const int waterlineCells = 64;
uniform int shadowCount;
uniform vec3 shadowRight, shadowUp, shadowBend;
uniform vec2 shadowLeast[3], shadowSize[3];
uniform float shadowTexel[3], shadowRow[3];

uniform bool foamIsOn, rainIsOn;
uniform vec3 foamSky, foamSun, bubbleLight, oilLight, oldRamp;
uniform vec2 whitecapAlong, breakingRamp;
uniform float foamTexelsPerMetre[3];
uniform float whitecapPerHeight, whitecapMean, perTotalSlope, foamLastLevel;
uniform vec2 foamAxis[3], foamOrigin[3];
uniform float foamKept[8];
uniform ivec2 rainCell, rainCode;  // column and row; count and seed
uniform vec2 rainFoot;
uniform float rainPart, rainDrops, rainMeanSquare;
uniform int rainSlots;
#define rainColumn uint(rainCell.x)
#define rainRow uint(rainCell.y)
#define rainCount uint(rainCode.x)
#define rainSeed uint(rainCode.y)
const float rainCellSize = 0.6f, rainLifetime = 0.9f, rainSpeed = 0.25f;
const float rainWavelength = 0.055f, rainHalfWidth = 0.07f, rainHeight = 0.003f;

#define Word uint
#define word(same) (same)
#define shiftedDown(bits, by) ((bits) >> (by))
#define wordOf(whole) uint(int(whole))
#define realOf(bits) float(bits)
vec2 cosineAndSine(float turns) {
  float angle = 6.2831853 * (turns - floor(turns + 0.5));
  return vec2(cos(angle), sin(angle));
}

vec3 srgb(vec3 linear) {
  vec3 curve = 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055;
  return mix(curve, 12.92 * linear, lessThanEqual(linear, vec3(0.0031308)));
}

uniform sampler2D foamMap;       // numbers of [0, 1], equally frequent; by mip level
uniform sampler2D dome;          // paraboloid sky, mip levels blur it
uniform sampler2D rippleMap;     // slopes of unit mean square, by mip level
uniform sampler2D fresnelTable;  // (reflectance, tilt, area) by √cosine and slope deviation
uniform float roughestSlope;     // slope deviation at the table's end

vec3 skyTexel(vec2 coordinate, float level) {
  return skyIsOn ? textureLod(dome, coordinate, level).rgb : skyLight;
}

vec3 rippleMoments(vec2 coordinate, float level) {
  float whole = floor(clamp(level, 0.0, rippleLastLevel));
  float here = rippleKept[int(whole)];
  float kept = mix(here, rippleKept[int(whole) + 1], clamp(level, 0.0, rippleLastLevel) - whole);
  return vec3(textureLod(rippleMap, coordinate, whole).xy * sqrt(kept / max(here, 1e-6)), kept);
}

vec2 foamTexel(vec2 coordinate, float level) {
  float whole = floor(clamp(level, 0.0, foamLastLevel));
  float here = foamKept[int(whole)];
  float kept = mix(here, foamKept[int(whole) + 1], clamp(level, 0.0, foamLastLevel) - whole);
  return vec2(textureLod(foamMap, coordinate, whole).x, kept);
}

vec3 roughFresnel(float rootCosine, float deviation) {
  vec2 size = vec2(textureSize(fresnelTable, 0));
  vec2 part = vec2(rootCosine, deviation / roughestSlope);
  return texture(fresnelTable, (part * (size - 1.0) + 0.5) / size).xyz;
}
vec2 roughMirror(float rootCosine, float deviation) {
  return roughFresnel(rootCosine, deviation).xy;
}
float roughArea(float rootCosine, float deviation) {
  return roughFresnel(rootCosine, deviation).z;
}

uniform sampler2D mirrorMap, belowMap;  // LocalImage: top row first

vec4 localTexel(sampler2D map, vec2 at, vec2 size) {
  bool inside = all(greaterThanEqual(at, vec2(0.0))) && all(lessThan(at, size));
  return inside ? texelFetch(map, ivec2(at), 0) : vec4(0.0);
}
vec3 localLight(sampler2D map, vec2 at, vec2 size, inout float part) {
  vec2 place = clamp(at, vec2(-2.0), size + 1.0), low = floor(place);
  vec3 light = vec3(0.0);
  part = 0.0;
  for (int i = 0; i < 4; ++i) {
    vec2 step = vec2(float(i & 1), float(i >> 1));
    vec4 texel = localTexel(map, low + step, size);
    vec2 weights = abs(place - low - (1.0 - step));
    float shown = texel.w > 0.0 ? weights.x * weights.y : 0.0;
    light += texel.rgb * shown;
    part += shown;
  }
  return light;
}
float mirrorNearness(vec2 pixel) {
  return localTexel(mirrorMap, floor(pixel + 0.5) - mirrorLeast, mirrorSize).w;
}
// Whether what is mirrored may show between two pixels.
bool mirrorMayShow(vec2 from, vec2 to, float asked) { return asked > 0.0; }
vec3 mirrorLight(vec2 pixel, inout float part) {
  return localLight(mirrorMap, pixel - mirrorLeast, mirrorSize, part);
}
float belowNearness(vec2 pixel) {
  return localTexel(belowMap, floor(pixel + 0.5) - belowLeast, belowSize).w;
}
vec3 belowLight(vec2 pixel, inout float part) {
  return localLight(belowMap, pixel - belowLeast, belowSize, part);
}

uniform sampler2D windowMap, depthsMap;  // the same
vec3 windowLight(vec2 pixel, inout float part) {
  return localLight(windowMap, pixel - windowLeast, windowSize, part);
}
float depthsNearness(vec2 pixel) {
  return localTexel(depthsMap, floor(pixel + 0.5) - depthsLeast, depthsSize).w;
}
vec3 depthsLight(vec2 pixel, inout float part) {
  return localLight(depthsMap, pixel - depthsLeast, depthsSize, part);
}

uniform sampler2D shadowMap;     // ShadowMaps
uniform sampler2D waterlineMap;  // Waterline: top row first
// Whether a shadow may fall on a place of map i.
bool shadowMayFall(int i, vec2 at, float asked) { return asked > 0.0; }
float shadowHeight(float column, float row) {
  return texelFetch(shadowMap, ivec2(column, row), 0).r;
}
float waterlineHeight(float column, float row) {
  return texelFetch(waterlineMap, ivec2(column, row), 0).r;
}
