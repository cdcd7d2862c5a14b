// The pixel that is shaded.
in vec2 screen;

uniform sampler2D surfaceMap;
uniform sampler2D albedoMap;
uniform sampler2D distanceMap;

layout(location = 0) out vec4 radiance;

vec3 pixelRay() { return middleRay + screen.x * right + screen.y * up; }

vec3 relativePosition() {
  return pixelRay() * abs(texelFetch(distanceMap, ivec2(gl_FragCoord.xy), 0).r);
}
vec4 surfaceHere() { return texelFetch(surfaceMap, ivec2(gl_FragCoord.xy), 0); }

void write(vec3 colour) { radiance = vec4(min(colour, vec3(6e4)), 1.0); }
