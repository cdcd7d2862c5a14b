#pragma once

#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>

#include "render/grid_placement.h"
#include "render/sea_grid.h"
#include "render/software/raster.h"
#include "render/software/sea_spans.h"
#include "tests/render/seas.h"

/// The software grid's pixels of water before they are shaded.
namespace seaway::render::test {

class WaterPicture {
 public:
  WaterPicture(const WaterSurface& water, const Camera& camera, glm::ivec2 grid, double time)
      : camera_(camera) {
    EffectLedger effects;
    View view;
    view.water = &water;
    view.time = time;
    view.camera = camera;
    view.effects = &effects;
    FrameStats stats;
    const auto place = [&](const Projector& projector) {
      layout_ = projectedLayout(projector, water.waves(), grid);
      grid_.fill(water.at(time), camera, layout_, 0.0);
      return SeaPlacement{grid_.largestHeight(), grid_.vertexCount(), 0};
    };
    shows_ = placeSea(view, 1.0, place, stats).has_value();
    screen_.fill(grid_, camera);
    slopes_.fill(grid_, layout_);
    constants_ = shadingConstants(view, {.waterIsOn = true});
  }

  const ShadingConstants& constants() const { return constants_; }

  /// Calls `each(span)` for all pieces of rows, sky among them.
  template <class Each>
  void forEachSpan(Each each) const {
    if (!shows_) return;
    const glm::vec2 perPixel = 2.0f / glm::vec2(camera_.size);
    for (int row = 0; row < camera_.size.y; ++row) {
      Strip strip;
      strip.clear(row, 1, camera_.size.x, false);
      rasterSea(screen_, strip);
      for (int first = 0; first < camera_.size.x; first += pixelsPerSpan) {
        PixelSpan span;
        span.count = std::min(pixelsPerSpan, camera_.size.x - first);
        const float upwards = 1.0f - (static_cast<float>(row) + 0.5f) * perPixel.y;
        const float across = (static_cast<float>(first) + 0.5f) * perPixel.x - 1.0f;
        span.rayStep = constants_.right * perPixel.x;
        span.firstRay = constants_.forward + across * constants_.right + upwards * constants_.up;
        slopes_.fillSpan(strip.inverse.data() + first, camera_, false, span);
        each(span);
      }
    }
  }

 private:
  Camera camera_;
  GridLayout layout_;
  SeaGrid grid_;
  ScreenGrid screen_;
  SeaSlopes slopes_;
  ShadingConstants constants_;
  bool shows_ = false;
};

}  // namespace seaway::render::test
