void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 relative = pixelRay() * abs(texelFetch(distanceMap, pixel, 0).r);
  float distance = length(relative);
  vec3 normal = texelFetch(surfaceMap, pixel, 0).xyz;
  vec3 reflectance = texelFetch(albedoMap, pixel, 0).rgb;

  vec3 ambient = blurredSky(normalize(normal + vec3(0.0, 0.0, 1.2)), 7.0);
  vec3 bounced = 0.06 * skyLight;
  vec3 light = mix(bounced, ambient, 0.5 + 0.5 * normal.z) +
               sunLight * max(dot(normal, sunDirection), 0.0) / pi;
  vec3 colour = reflectance * light;
  write(cameraIsUnderWater ? throughWater(colour, distance)
                           : hazed(colour, relative / distance, distance));
}
