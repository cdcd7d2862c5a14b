in vec2 screen;
uniform vec3 sunDirection;
layout(location = 0) out vec4 colour;

void main() {
  // Outside the unit disc lies what is below the horizon; filtering needs it to go on smoothly.
  float squared = min(dot(screen, screen), 1.0);
  vec2 inside = screen / max(length(screen), 1.0);
  colour = vec4(skyWithClouds(vec3(2.0 * inside, 1.0 - squared) / (1.0 + squared), sunDirection),
                1.0);
}
