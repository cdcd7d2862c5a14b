layout(location = 0) in vec3 place;  // relative to the camera, m

uniform mat4 clipFromRelativeWorld;

out vec3 relative;

void main() {
  gl_Position = clipFromRelativeWorld * vec4(place, 1.0);
  relative = place;
}
