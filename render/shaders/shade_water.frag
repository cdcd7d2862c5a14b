void main() {
  vec3 relative = relativePosition();
  vec4 surface = surfaceHere();
  write(waterRadiance(relative, length(relative), surface.xy, surface.z, surface.w,
                      texelFetch(albedoMap, ivec2(gl_FragCoord.xy), 0).rgb));
}
