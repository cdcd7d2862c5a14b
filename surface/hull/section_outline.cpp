#include "surface/hull/section_outline.h"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_point.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

namespace seaway {

std::vector<glm::dvec2> sectionOutline(const TriangleMesh& mesh, double z) {
  namespace bg = boost::geometry;
  using Point = bg::model::d2::point_xy<double>;
  bg::model::multi_point<Point> cuts;
  for (const auto& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const glm::dvec3 &a = mesh.vertices[t[i]], &b = mesh.vertices[t[(i + 1) % 3]];
      if ((a.z < z) == (b.z < z)) continue;
      const glm::dvec3 cut = a + (z - a.z) / (b.z - a.z) * (b - a);
      cuts.emplace_back(cut.x, cut.y);
    }
  }
  if (cuts.size() < 3) return {};
  bg::model::polygon<Point, false, false> hull;
  bg::convex_hull(cuts, hull);
  std::vector<glm::dvec2> outline;
  for (const Point& point : hull.outer()) outline.emplace_back(point.x(), point.y());
  return outline;
}

}  // namespace seaway
