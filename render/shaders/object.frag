in vec3 normal;
in vec3 colour;

layout(location = 0) out vec4 surface;
layout(location = 1) out vec4 albedo;
layout(location = 2) out float signedDistance;

void main() {
  surface = vec4(gl_FrontFacing ? normal : -normal, 0.0);
  albedo = vec4(colour, 1.0);
  signedDistance = -1.0 / gl_FragCoord.w;
}
