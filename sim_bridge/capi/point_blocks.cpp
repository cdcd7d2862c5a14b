#include "sim_bridge/capi/point_blocks.h"

#include <algorithm>

namespace seaway::bridge::capi {

void requirePoints(const seaway_points* points) {
  requireStruct(points, "points");
  requireThat(points->frame == SEAWAY_SEA_PLANE || points->frame == SEAWAY_GEODETIC, [&] {
    return "points.frame is " + std::to_string(points->frame) +
           "; must be SEAWAY_SEA_PLANE (0) or SEAWAY_GEODETIC (1)";
  });
  if (points->count == 0) return;
  require(points->first, "points.first");
  require(points->second, "points.second");
}

std::size_t fill(PointBlock& block, const seaway_points& points, std::size_t next, std::size_t end,
                 PlanePlacer* placer) {
  block.count = 0;
  block.first = next;
  block.everyPoint = points.wanted == nullptr;
  block.geodetic = points.frame == SEAWAY_GEODETIC;
  if (block.everyPoint && !block.geodetic) {
    block.count = std::min(pointsPerBlock, end - next);
    for (std::size_t i = 0; i < block.count; ++i) {
      block.points[i] = {points.first[next + i], points.second[next + i]};
    }
    return next + block.count;
  }
  for (; next < end && block.count < pointsPerBlock; ++next) {
    if (!block.everyPoint && points.wanted[next] == 0) continue;
    const std::size_t i = block.count++;
    block.rows[i] = next;
    if (block.geodetic) {
      block.placed[i] = placer->place(points.first[next], points.second[next]);
      block.points[i] = block.placed[i].position;
    } else {
      block.points[i] = {points.first[next], points.second[next]};
    }
  }
  return next;
}

PointBlock& threadsBlock() {
  thread_local PointBlock block;
  return block;
}

}  // namespace seaway::bridge::capi
