// A pixel of ground: the twin of TerrainInView::fillSpan and groundPixel.
in vec3 relative;

uniform sampler2D colourMap;  // √ of reflectance
uniform sampler2D slopeMap;   // over mostSlope
uniform vec2 mapFoot;         // the camera's foot from the map's origin, m
uniform vec2 mapExtent;       // m
uniform float texelSize, mostSlope, lastLevel;
uniform float pixelAngle, eyeHeight, curvature, wetHeight;

layout(location = 0) out vec4 surface;
layout(location = 1) out vec4 albedo;
layout(location = 2) out float signedDistance;

void main() {
  vec2 place = mapFoot + relative.xy;
  float footprint = pixelAngle * length(relative);
  float level = clamp(log2(max(footprint / texelSize, 1.0)), 0.0, lastLevel);
  vec3 root = textureLod(colourMap, place / mapExtent, level).rgb;
  vec2 slope = textureLod(slopeMap, place / mapExtent, level).rg * mostSlope;
  float height = relative.z + eyeHeight + dot(relative.xy, relative.xy) * curvature;
  surface = vec4(normalize(vec3(-slope, 1.0)), 0.0);
  albedo = vec4(groundReflectance(root * root, height, wetHeight, groundGrain(place, footprint)), 0.0);
  signedDistance = -1.0 / gl_FragCoord.w;
}
