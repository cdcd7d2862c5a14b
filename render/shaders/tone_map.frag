// Writes the top row first, as images are stored; the framebuffer encodes sRGB.
uniform sampler2D radianceMap;
flat in vec3 sunLight;
flat in vec3 skyLight;

layout(location = 0) out vec4 display;

// Narkowicz' fit of the ACES curve.
vec3 filmic(vec3 x) {
  return clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
}

void main() {
  // Exposed for the light that falls on the scene, as a hand-held meter would; at night the eye
  // does not follow all the way.
  vec3 light = skyLight + 0.25 * sunLight * max(sunDirection.z, 0.0) / pi;
  float exposure = 0.46 / (dot(light, vec3(0.2126, 0.7152, 0.0722)) + 0.02);
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  pixel.y = textureSize(radianceMap, 0).y - 1 - pixel.y;
  display = vec4(filmic(exposure * texelFetch(radianceMap, pixel, 0).rgb), 1.0);
}
