#include <algorithm>
#include <string>
#include <vector>

#include "render/ordinary_views.h"
#include "render/projector.h"
#include "render/sea_grid.h"
#include "sim_bridge/cost/study.h"
#include "sim_bridge/scene/sea.h"

namespace seaway::bridge {
namespace {

using render::GridLayout;
using render::Projector;
using render::RowEnds;

/// Share of a grid's vertices outside the picture, over `count` ordinary views of a sea.
std::vector<double> wastedShares(const WaterSurface& water, RowEnds rowEnds, unsigned count) {
  std::vector<double> shares;
  render::SeaGrid grid;
  for (unsigned i = 0; i < count; ++i) {
    const render::Camera camera = render::ordinaryView(i).camera;
    const auto projector = Projector::aimedAt(camera, water.heightBound(), {.rowEnds = rowEnds});
    if (!projector) continue;
    grid.fill(water.at(0.0), camera, projectedLayout(*projector, water.waves(), {64, 128}));
    shares.push_back(1.0 - static_cast<double>(grid.verticesInFrustum(camera)) /
                               static_cast<double>(grid.vertexCount()));
  }
  return shares;
}

Timing timePlacing(const WaterSurface& water, RowEnds rowEnds, int repetitions) {
  constexpr unsigned views = 20;
  Timing timing = timeRepeated(
      [&] {
        for (unsigned i = 0; i < views; ++i) {
          const auto projector = Projector::aimedAt(render::ordinaryView(i).camera,
                                                    water.heightBound(), {.rowEnds = rowEnds});
          if (projector) projectedLayout(*projector, water.waves(), {256, 512});
        }
      },
      repetitions);
  timing.median /= views;
  timing.spread /= views;
  return timing;
}

}  // namespace

Study studyVertexEfficiency(const Sea& sea, const StudyOptions& options) {
  Study study{"image_wasted_vertices",
              "share of the grid's vertices outside the picture, median over ordinary views of the "
              "scene's sea (render/ordinary_views.h); cost of placing 256x512 vertices",
              "1",
              "ms/frame",
              {}};
  for (const auto& [name, rowEnds] : {std::pair{"rectangle", RowEnds::rectangle},
                                      std::pair{"rows to sides of view", RowEnds::visible}}) {
    std::vector<double> shares = wastedShares(sea.surface, rowEnds, options.quick ? 60 : 400);
    if (shares.empty()) continue;
    const auto middle = shares.begin() + static_cast<std::ptrdiff_t>(shares.size() / 2);
    std::nth_element(shares.begin(), middle, shares.end());
    const Timing timing = timePlacing(sea.surface, rowEnds, options.quick ? 3 : 9);
    study.points.push_back({name, *middle, 1e3 * timing.median, 1e3 * timing.spread});
  }
  return study;
}

}  // namespace seaway::bridge
