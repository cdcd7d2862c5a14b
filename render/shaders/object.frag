in vec3 normal;
in vec3 colour;

uniform float tag;  // what alpha tells the object by, (0, 1]

layout(location = 0) out vec4 surface;
layout(location = 1) out vec4 albedo;
layout(location = 2) out float signedDistance;

void main() {
  surface = vec4(gl_FrontFacing ? normal : -normal, 0.0);
  albedo = vec4(colour, tag);
  signedDistance = -1.0 / gl_FragCoord.w;
}
