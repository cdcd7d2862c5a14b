// Writes the top row first, as images are stored; the framebuffer encodes sRGB.
uniform sampler2D radianceMap;

layout(location = 0) out vec4 display;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  pixel.y = textureSize(radianceMap, 0).y - 1 - pixel.y;
  display = vec4(filmic(texelFetch(radianceMap, pixel, 0).rgb), 1.0);
}
