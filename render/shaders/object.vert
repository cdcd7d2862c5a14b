layout(location = 0) in vec3 bodyPosition;
layout(location = 1) in vec3 bodyNormal;
layout(location = 2) in vec3 reflectance;

uniform mat4 clipFromRelativeWorld;
uniform mat3 rotation;  // world from body
uniform vec3 position;  // of the body's origin relative to the camera, m

out vec3 normal;
out vec3 colour;

void main() {
  gl_Position = clipFromRelativeWorld * vec4(rotation * bodyPosition + position, 1.0);
  normal = rotation * bodyNormal;
  colour = reflectance;
}
