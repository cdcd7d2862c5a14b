// The surface from below: the sky through Snell's window, the deep around it.
void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 relative = pixelRay() * texelFetch(distanceMap, pixel, 0).r;
  float distance = length(relative);
  vec3 direction = relative / distance;
  vec3 normal = normalize(vec3(texelFetch(surfaceMap, pixel, 0).xy, -1.0));  // downwards
  float cosine = max(dot(normal, -direction), 0.0);
  vec3 refracted = refract(direction, normal, 1.34);
  vec3 above = vec3(0.0);
  if (dot(refracted, refracted) > 0.0) {
    above = blurredSky(refracted, 3.0) + 0.15 * sunDisc(normalize(refracted));
  }
  vec3 colour = mix(above, 1.6 * deepWater(), fresnel(cosine, 1.0 / 1.34));
  write(throughWater(colour, distance));
}
