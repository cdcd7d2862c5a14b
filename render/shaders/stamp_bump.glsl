// A smooth round hump: (1 − r²)³, with its derivatives.
vec3 stampShape(vec2 local) {
  float inside = max(1.0 - dot(local, local), 0.0);
  return vec3(inside * inside * inside, -6.0 * inside * inside * local);
}
