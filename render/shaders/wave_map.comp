layout(local_size_x = 32, local_size_y = 4) in;
layout(rgba32f, binding = 0) writeonly uniform image2D waveImage;

shared uint groupLargest;
shared uint groupInFrustum;
shared uint groupSlope;

void main() {
  if (gl_LocalInvocationIndex == 0u) {
    groupLargest = 0u;
    groupInFrustum = 0u;
    groupSlope = 0u;
  }
  barrier();
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (all(lessThan(texel, imageSize(waveImage)))) {
    vec4 waves = waveTexel(texel);
    imageStore(waveImage, texel, waves);
    atomicMax(groupLargest, floatBitsToUint(abs(waves.x)));
    atomicMax(groupSlope, floatBitsToUint(length(waves.yz)));
    if (isInFrustum(texel, waves.x)) atomicAdd(groupInFrustum, 1u);
  }
  barrier();
  if (gl_LocalInvocationIndex == 0u) {
    atomicMax(largestHeight, groupLargest);
    atomicAdd(verticesInFrustum, groupInFrustum);
    atomicMax(largestSlope, groupSlope);
  }
}
