void main() {
  vec3 relative = relativePosition();
  vec3 reflectance = texelFetch(albedoMap, ivec2(gl_FragCoord.xy), 0).rgb;
  write(objectRadiance(relative, length(relative), surfaceHere().xyz, reflectance, relative));
}
