// Height and slope of what a row carries, at a point from the camera's foot.
vec3 wavesAt(vec2 point, vec4 band) {
  exact vec3 sum = vec3(0.0);
  int i = 0;
  for (; i < counts.x; ++i) {
    float part = carriedPart(octaves[i].second.w, band);
    if (part > 0.0) sum = groupOctave(octaves[i], point) * part + sum;
  }
  for (; i < counts.x + counts.y; ++i) {
    float part = carriedPart(octaves[i].second.w, band);
    if (part > 0.0) sum = perlinOctave(octaves[i], point) * part + sum;
  }
  for (; i < counts.x + counts.y + counts.z; ++i) {
    float part = carriedPart(octaves[i].second.w, band);
    if (part > 0.0) sum = regularOctave(octaves[i], point) * part + sum;
  }
  return sum;
}
