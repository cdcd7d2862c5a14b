void main() {
  vec3 relative = relativePosition();
  write(undersideRadiance(relative, length(relative), surfaceHere().xy));
}
