layout(location = 0) in vec3 position;  // relative to the camera, m
layout(location = 1) in vec2 slope;
layout(location = 2) in vec2 heightAndMissingSlope;
layout(location = 3) in vec3 cover;  // foam, smoothed water, oil

uniform mat4 clipFromRelativeWorld;

out vec2 waveSlope;
out vec2 waveHeightAndMissingSlope;
out vec3 waterCover;

void main() {
  gl_Position = clipFromRelativeWorld * vec4(position, 1.0);
  waveSlope = slope;
  waveHeightAndMissingSlope = heightAndMissingSlope;
  waterCover = cover;
}
