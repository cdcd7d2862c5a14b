// Where there is water: the index of surface/outline/water_outline.h, single precision. Places are
// relative to the camera's foot point, m.
uniform bool outlineIsOn;
uniform vec2 outlineFoot;  // of the camera, from the index's lower corner
uniform vec2 outlineCellSize;
uniform ivec2 outlineCellCount;

layout(std430, binding = 2) readonly buffer OutlineCells { ivec4 outlineCells[]; };
layout(std430, binding = 3) readonly buffer OutlineEdges { vec4 outlineEdges[]; };

int isLeftOf(vec4 edge, vec2 point) {
  vec2 along = edge.zw - edge.xy, off = point - edge.xy;
  return along.x * off.y - along.y * off.x > 0.0 ? 1 : 0;
}

bool isWater(vec2 place) {
  vec2 point = outlineFoot + place, inCells = point / outlineCellSize;
  if (!(all(greaterThanEqual(inCells, vec2(0.0))) &&
        all(lessThanEqual(inCells, vec2(outlineCellCount))))) {
    return false;
  }
  ivec2 at = min(ivec2(inCells), outlineCellCount - 1);
  ivec4 cell = outlineCells[at.y * outlineCellCount.x + at.x];
  vec2 middle = (vec2(at) + 0.5) * outlineCellSize, corner = vec2(middle.x, point.y);
  int winding = cell.z;
  for (int i = cell.x; i < cell.x + cell.y; ++i) {
    vec4 edge = outlineEdges[i];
    int beside = isLeftOf(edge, corner);
    if ((edge.x <= middle.x) != (edge.z <= middle.x)) winding += beside - isLeftOf(edge, middle);
    if ((edge.y <= point.y) != (edge.w <= point.y)) winding += isLeftOf(edge, point) - beside;
  }
  return winding > 0;
}
