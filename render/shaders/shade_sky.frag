void main() {
  vec3 direction = normalize(pixelRay());
  write(cameraIsUnderWater ? 1.6 * deepWater()
                           : blurredSky(direction, 0.0) + sunDisc(direction));
}
