// Light shared by all that is shaded.

uniform sampler2D dome;  // paraboloid sky, mip levels blur it
uniform bool skyIsOn;
uniform bool sunIsOn;
uniform vec3 sunDirection;

const vec3 plainSky = vec3(1.2);  // where the sky is switched off

vec3 blurredSky(vec3 direction, float level) {
  return skyIsOn ? textureLod(dome, domeFromDirection(direction), level).rgb : plainSky;
}
