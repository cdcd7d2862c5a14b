// Shading and tone mapping of a whole picture, for cards whose fragment shaders are slow. Writes the
// top row first, as images are stored.
layout(local_size_x = 16, local_size_y = 8) in;
layout(rgba8, binding = 0) writeonly uniform image2D displayImage;

layout(rgba16f, binding = 3) writeonly uniform image2D radianceImage;
uniform bool radianceIsWanted;

uniform sampler2D surfaceMap;
uniform sampler2D albedoMap;
uniform sampler2D distanceMap;  // 0 sky, > 0 water, < 0 object

vec3 pixelRadiance(ivec2 pixel, vec3 ray) {
  float distanceHere = texelFetch(distanceMap, pixel, 0).r;
  if (distanceHere == 0.0) return skyPixel(normalize(ray));
  vec3 relative = ray * abs(distanceHere);
  float range = length(relative);
  vec4 surface = texelFetch(surfaceMap, pixel, 0);
  if (distanceHere < 0.0) {
    return objectRadiance(relative, range, surface.xyz, texelFetch(albedoMap, pixel, 0).rgb,
                          relative);
  }
  if (submerged(relative) > 0.5) return undersideRadiance(relative, range, surface.xy, surface.z);
  return waterRadiance(relative, range, surface.xy, surface.z, surface.w,
                       texelFetch(albedoMap, pixel, 0).rgb);
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 size = imageSize(displayImage);
  if (any(greaterThanEqual(pixel, size))) return;
  vec2 screen = (vec2(pixel) + 0.5) / vec2(size) * 2.0 - 1.0;
  vec3 radiance = pixelRadiance(pixel, middleRay + screen.x * right + screen.y * up);
  radiance = min(radiance, vec3(6e4));
  if (radianceIsWanted) imageStore(radianceImage, pixel, vec4(radiance, 1.0));
  vec3 display = srgb(toneMapped(radiance));
  ivec2 place = ivec2(pixel.x, size.y - 1 - pixel.y);
  if (dithers) display += (ditherAt(float(place.x), float(place.y)) - 0.5) / 255.0;
  imageStore(displayImage, place, vec4(display, 1.0));
}
