void main() {
  vec3 relative = relativePosition();
  vec4 surface = surfaceHere();
  write(undersideRadiance(relative, length(relative), surface.xy, surface.z));
}
