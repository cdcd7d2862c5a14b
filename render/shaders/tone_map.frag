// Writes the top row first, as images are stored. The framebuffer encodes sRGB, unless what it would
// round is dithered here.
uniform sampler2D radianceMap;

layout(location = 0) out vec4 display;

void main() {
  ivec2 place = ivec2(gl_FragCoord.xy), pixel = place;
  pixel.y = textureSize(radianceMap, 0).y - 1 - pixel.y;
  vec3 shown = toneMapped(texelFetch(radianceMap, pixel, 0).rgb);
  if (dithers) shown = srgb(shown) + (ditherAt(float(place.x), float(place.y)) - 0.5) / 255.0;
  display = vec4(shown, 1.0);
}
