#include "render/grid_skip.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "surface/curvature.h"

namespace seaway::render {
namespace {

/// Inward normals of the frustum's sides through the eye, and how deep a point must lie: beyond
/// where dot(normal, p) < least.
struct Side {
  glm::dvec3 normal;
  double least;
};

std::array<Side, 5> sidesOf(const Camera& camera, double bound) {
  const glm::dvec2 half = camera.halfPicture(), middle = camera.pictureMiddle();
  const glm::dvec3 f = camera.forward(), l = camera.left(), u = camera.up();
  std::array<Side, 5> sides{{{f, camera.nearDistance},
                             {(half.x + middle.x) * f + l, 0.0},
                             {(half.x - middle.x) * f - l, 0.0},
                             {(half.y - middle.y) * f + u, 0.0},
                             {(half.y + middle.y) * f - u, 0.0}}};
  for (Side& side : sides) side.least -= bound * std::abs(side.normal.z);
  return sides;
}

}  // namespace

std::vector<std::uint8_t> batchesInView(const GridLayout& layout, const Camera& camera,
                                        double bound, int batch) {
  const int batches = (layout.size.x - 2) / batch + 1;
  const auto sides = sidesOf(camera, bound);
  std::vector<std::uint8_t> seen(static_cast<std::size_t>(layout.size.y - 1) * batches);
  // A bit for each side that a vertex is within; a batch is seen where no bit is missing in all.
  tbb::parallel_for(0, layout.size.y - 1, [&](int row) {
    for (int b = 0; b < batches; ++b) {
      const int first = b * batch, last = std::min(first + batch, layout.size.x - 1);
      unsigned within = 0;
      for (const int line : {row, row + 1}) {
        for (int column = first; column <= last; ++column) {
          const glm::dvec2 place = layout.place(line, column);
          const glm::dvec3 vertex(place, -seaDrop(glm::length(place)) - camera.position.z);
          for (std::size_t s = 0; s < sides.size(); ++s) {
            within |= unsigned{glm::dot(sides[s].normal, vertex) >= sides[s].least} << s;
          }
        }
      }
      seen[static_cast<std::size_t>(row) * batches + b] = within == (1u << sides.size()) - 1u;
    }
  });
  return seen;
}

}  // namespace seaway::render
