in vec2 mapCoordinate;

uniform sampler2D waveMap;
uniform sampler2D coverMap;
uniform bool coverIsOn;

layout(location = 0) out vec4 surface;
layout(location = 1) out vec4 cover;
layout(location = 2) out float signedDistance;

void main() {
  vec4 waves = textureLod(waveMap, mapCoordinate, 0.0);
  // As in water.frag.
  vec2 alongX = dFdx(waves.yz), alongY = dFdy(waves.yz);
  float withinPixel = (dot(alongX, alongX) + dot(alongY, alongY)) / 12.0;
  surface = vec4(waves.yz, waves.w + min(withinPixel, 0.05), waves.x);
  cover = coverIsOn ? textureLod(coverMap, mapCoordinate, 0.0) : vec4(0.0);
  signedDistance = 1.0 / gl_FragCoord.w;
}
