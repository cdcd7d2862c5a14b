// Full-screen triangle with the light that is the same for every pixel.
out vec2 screen;  // [-1, 1]
flat out vec3 sunLight;  // irradiance on a plane that faces the sun
flat out vec3 skyLight;  // mean radiance of the upper hemisphere

void main() {
  screen = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  gl_Position = vec4(screen, 0.0, 1.0);
  sunLight = sunIsOn ? sunIrradiance(sunDirection) : vec3(0.0);
  skyLight = skyIsOn ? textureLod(dome, vec2(0.5), 16.0).rgb : plainSky;
}
