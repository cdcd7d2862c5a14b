in vec2 waveSlope;
in vec2 waveHeightAndMissingSlope;
in vec3 waterCover;

layout(location = 0) out vec4 surface;
layout(location = 1) out vec4 cover;
layout(location = 2) out float signedDistance;

void main() {
  // Slope that changes within a pixel is roughness to that pixel; as sharp normals it would sparkle.
  vec2 alongX = dFdx(waveSlope), alongY = dFdy(waveSlope);
  float withinPixel = (dot(alongX, alongX) + dot(alongY, alongY)) / 12.0;
  surface = vec4(waveSlope, waveHeightAndMissingSlope.y + min(withinPixel, 0.05),
                 waveHeightAndMissingSlope.x);
  cover = vec4(waterCover, 0.0);
  signedDistance = 1.0 / gl_FragCoord.w;
}
