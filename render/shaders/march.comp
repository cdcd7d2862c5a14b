// The sea's surface, a ray for each pixel: marches over the wave map from row to row, then meets
// the field itself.
layout(local_size_x = 16, local_size_y = 8) in;
layout(rgba16f, binding = 0) writeonly uniform image2D surfaceImage;
layout(r32f, binding = 1) writeonly uniform image2D distanceImage;
layout(rgba8, binding = 2) writeonly uniform image2D coverImage;

layout(std430, binding = 1) readonly buffer TallyBlock {
  uint largestHeight;
  uint verticesInFrustum;
  uint largestSlope;
};

uniform sampler2D waveMap;
uniform sampler2D stamps;
uniform bool stampsAreOn;
uniform sampler2D extras;
uniform bool extrasAreOn;
uniform sampler2D coverMap;
uniform bool coverIsOn;
uniform vec3 middleRay, right, up;  // of a picture at 1 m: its middle, to its right and upper edge
uniform float nearDistance;

shared vec3 slopes[gl_WorkGroupSize.y][gl_WorkGroupSize.x];

// The ray at t m of axial distance: point t·level from the camera's foot, t·sink above the eye.
struct Ray {
  vec2 level;
  float sink;
  float bend;  // how the curved sea falls away below it, 1/m
};

float aboveStillWater(Ray ray, float t) {
  return eyeHeight + t * (ray.sink + t * ray.bend);
}

// Roots of aboveStillWater(t) = level, nearest first; negative where there is none.
vec2 crossings(Ray ray, float level) {
  float c = eyeHeight - level;
  float under = ray.sink * ray.sink - 4.0 * ray.bend * c;
  if (under < 0.0) return vec2(-1.0);
  // The form without cancellation; bend may be 0.
  float q = -0.5 * (ray.sink + (ray.sink < 0.0 ? -1.0 : 1.0) * sqrt(under));
  float a = q / max(ray.bend, 1e-30), b = q != 0.0 ? c / q : 0.0;
  return vec2(min(a, b), max(a, b));
}

// Part of the ray between the bounds ±height: first and last t; empty where last < first.
vec2 withinBounds(Ray ray, float height) {
  vec2 top = crossings(ray, height), bottom = crossings(ray, -height);
  float first = nearDistance, last = 1e9;
  if (eyeHeight > height) {
    if (top.x <= 0.0) return vec2(1.0, 0.0);
    first = max(first, top.x);
    last = top.y;
  } else if (top.y > 0.0) {
    last = top.x > 0.0 ? top.x : top.y;
  }
  if (eyeHeight < -height) {
    float enter = bottom.x > 0.0 ? bottom.x : bottom.y;
    if (enter <= 0.0) return vec2(1.0, 0.0);
    return vec2(max(nearDistance, enter), last);
  }
  if (bottom.x > 0.0) last = min(last, bottom.x);
  return vec2(first, last);
}

// Which row a point lies beyond, and the rows' line and share there.
struct Place {
  int row;
  float share;
  vec4 line;
};

vec2 away;   // unit, across the rows, in the direction of their numbers
int lastRow;

float rowDistance(int row) { return dot(rows[row].line.xy, away); }

int rowBefore(float distance) {
  int low = 0, high = lastRow - 1;
  while (low < high) {
    int middle = (low + high + 1) / 2;
    if (rowDistance(middle) <= distance) low = middle; else high = middle - 1;
  }
  return low;
}

Place placeAt(vec2 point, int row) {
  float here = rowDistance(row), next = rowDistance(row + 1);
  float share = clamp((dot(point, away) - here) / max(next - here, 1e-12), 0.0, 1.0);
  return Place(row, share, mix(rows[row].line, rows[row + 1].line, share));
}

float columnOf(Place place, vec2 point) {
  vec2 stepAlong = place.line.zw;
  return dot(point - place.line.xy, stepAlong) / dot(stepAlong, stepAlong);
}

vec2 mapCoordinate(Place place, vec2 point) {
  return (vec2(columnOf(place, point), float(place.row) + place.share) + 0.5) /
         vec2(textureSize(waveMap, 0));
}

// Above the map's surface at t.
float aboveMap(Ray ray, float t, int row) {
  vec2 point = t * ray.level;
  return aboveStillWater(ray, t) - textureLod(waveMap, mapCoordinate(placeAt(point, row), point), 0.0).x;
}

struct Hit {
  float t;  // < 0: none
  int row;
};

Hit march(Ray ray) {
  // Wider by the rounding of heights along the ray, or a thin layer of waves could be stepped over.
  float end = rowDistance(lastRow);
  float rounding = 1e-5 + 1e-6 * (abs(eyeHeight) + end * end * curvature);
  float bound = uintBitsToFloat(largestHeight) * 1.0001 + rounding;
  vec2 span = withinBounds(ray, bound);
  float paceAway = dot(ray.level, away);
  float steepest = 1.05 * uintBitsToFloat(largestSlope) * length(ray.level) + abs(ray.sink) + 1e-9;
  // Past the last row no crest shows; before the first, but for rounding, there is none in view.
  if (paceAway > 0.0) {
    span.y = min(span.y, end / paceAway);
  } else {
    span.y = min(span.y, (min(rowDistance(0), 0.0) - 0.01) / min(paceAway, -1e-12));
  }
  if (span.y < span.x) return Hit(-1.0, 0);
  float t = span.x;
  int row = rowBefore(t * paceAway);
  float height = aboveMap(ray, t, row);
  float side = height < 0.0 ? -1.0 : 1.0;
  for (int i = 0; i < 4 * lastRow && t < span.y; ++i) {
    // To the next row, but not across more than two columns; farther where the water is far.
    float target = paceAway > 0.0 ? rowDistance(row + 1) : rowDistance(row);
    if (paceAway < 0.0 && row > 0 && t * paceAway <= target) target = rowDistance(row - 1);
    float toRow = abs(paceAway) > 1e-12 ? target / paceAway - t : 1e9;
    vec2 stepAlong = rows[row].line.zw;
    float columns = abs(dot(ray.level, stepAlong)) / dot(stepAlong, stepAlong);
    float pace = max(min(max(toRow, 1e-6 * t), 2.0 / max(columns, 1e-12)),
                     side * height / (steepest + 2.0 * t * ray.bend));
    float next = min(t + pace, span.y);
    int nextRow = row;
    float along = next * paceAway * (1.0 + 1e-6);
    while (nextRow + 1 < lastRow && rowDistance(nextRow + 1) <= along) ++nextRow;
    while (nextRow > 0 && rowDistance(nextRow) > along) --nextRow;
    float nextHeight = aboveMap(ray, next, nextRow);
    if (side * nextHeight <= 0.0) {
      float share = height / (height - nextHeight);
      t += (next - t) * clamp(share, 0.0, 1.0);
      int at = nextRow;
      while (at > 0 && rowDistance(at) > t * paceAway) --at;
      while (at + 1 < lastRow && rowDistance(at + 1) <= t * paceAway) ++at;
      return Hit(t, at);
    }
    t = next;
    row = nextRow;
    height = nextHeight;
  }
  return Hit(-1.0, 0);
}

// The field between two rows: what each octave's two parts come to.
vec3 wavesBetween(vec2 point, vec4 bandBefore, vec4 bandAfter, float share) {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < counts.x + counts.y + counts.z; ++i) {
    float wavelength = octaves[i].second.w;
    float part = mix(carriedPart(wavelength, bandBefore), carriedPart(wavelength, bandAfter), share);
    if (part <= 0.0) continue;
    if (i < counts.x) {
      sum += part * groupOctave(octaves[i], point);
    } else if (i < counts.x + counts.y) {
      sum += part * perlinOctave(octaves[i], point);
    } else {
      sum += part * regularOctave(octaves[i], point);
    }
  }
  return sum;
}

// One step of Newton's method on the field; slope, height and slope left out there.
vec4 meet(Ray ray, inout float t, int row) {
  vec2 point = t * ray.level;
  Place place = placeAt(point, row);
  bool dry = outlineIsOn && !isWater(point);
  vec3 waves = dry ? vec3(0.0) : wavesBetween(point, rows[row].band, rows[row + 1].band, place.share);
  float missing = mix(rows[row].band.w, rows[row + 1].band.w, place.share);
  if (stampsAreOn && !dry) {
    vec4 stamp = textureLod(stamps, mapCoordinate(place, point), 0.0);
    waves += stamp.xyz;
    missing += stamp.w;
  }
  if (extrasAreOn && !dry) waves += textureLod(extras, mapCoordinate(place, point), 0.0).xyz;
  float off = aboveStillWater(ray, t) - waves.x;
  float rate = ray.sink + 2.0 * t * ray.bend - dot(waves.yz, ray.level);
  // Where the ray slides along a crest the step has no meaning; the map's crossing stands.
  float correction = -off / rate;
  float room = 0.5 * length(place.line.zw) / max(length(ray.level), 1e-6) + 1e-3 * t;
  if (abs(correction) < room) t += correction;
  return vec4(waves.yz, missing, aboveStillWater(ray, t));
}

// Of two neighbours (slope, t) on one face of a wave.
vec2 slopeChange(vec3 a, vec3 b) {
  return min(a.z, b.z) > 0.9 * max(a.z, b.z) ? b.xy - a.xy : vec2(0.0);
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 size = imageSize(distanceImage);
  ivec2 local = ivec2(gl_LocalInvocationID.xy);
  lastRow = textureSize(waveMap, 0).y - 1;
  vec2 across = normalize(rows[0].line.zw);
  away = vec2(-across.y, across.x);
  if (rowDistance(lastRow) < rowDistance(0)) away = -away;

  vec2 screen = (vec2(pixel) + 0.5) / vec2(size) * 2.0 - 1.0;
  vec3 direction = middleRay + screen.x * right + screen.y * up;
  Ray ray = Ray(direction.xy, direction.z, dot(direction.xy, direction.xy) * curvature);
  Hit hit = march(ray);
  vec4 surface = vec4(0.0);
  float t = hit.t;
  if (t > 0.0) surface = meet(ray, t, hit.row);
  slopes[local.y][local.x] = vec3(surface.xy, t);
  barrier();
  if (any(greaterThanEqual(pixel, size)) || t <= 0.0) return;
  // Slope that changes within a pixel is roughness to that pixel, as in water.frag.
  ivec2 even = local & ~1;
  vec2 alongX = slopeChange(slopes[local.y][even.x], slopes[local.y][even.x + 1]);
  vec2 alongY = slopeChange(slopes[even.y][local.x], slopes[even.y + 1][local.x]);
  surface.z += min((dot(alongX, alongX) + dot(alongY, alongY)) / 12.0, 0.05);
  imageStore(surfaceImage, pixel, surface);
  imageStore(distanceImage, pixel, vec4(t));
  if (coverIsOn) {
    vec2 point = t * ray.level;
    imageStore(coverImage, pixel,
               textureLod(coverMap, mapCoordinate(placeAt(point, hit.row), point), 0.0));
  }
}
