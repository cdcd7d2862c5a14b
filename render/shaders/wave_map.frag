layout(location = 0) out vec4 waves;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  waves = waveTexel(texel);
  atomicMax(largestHeight, floatBitsToUint(abs(waves.x)));
  atomicMax(largestSlope, floatBitsToUint(length(waves.yz)));
  if (isInFrustum(texel, waves.x)) atomicAdd(verticesInFrustum, 1u);
}
