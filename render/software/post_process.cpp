#include <algorithm>

#include "render/grid_placement.h"
#include "render/software/sea_march.h"
#include "render/software/sea_spans.h"
#include "render/software/strip_technique.h"
#include "render/surf.h"
#include "surface/input_error.h"

namespace seaway::render {
namespace {

class PostProcess final : public StripTechnique {
 public:
  explicit PostProcess(const PostProcessOptions& options) : options_(options) {
    validateRings("post-process", options.grid, innermost);
    if (options.steps < 2 || options.steps > 1024) {
      throw InputError("post-process: " + std::to_string(options.steps) +
                       " steps are not allowed; there must be 2 to 1024");
    }
  }
  std::string name() const override { return "post_process"; }

 private:
  static constexpr double innermost = 0.1;  // m, as the radial grid's

  bool placeSea(const View& view, FrameStats& stats) override {
    GridLayout layout;
    double bound = view.water ? view.water->heightBound(view.time) : 0.0;
    const auto place = [&](const Projector& projector) {
      layout =
          radialLayout(view.water->waves(), {}, projector.reach(),
                       {.size = {options_.grid.x + 1, options_.grid.y}, .innermost = innermost});
      const std::optional<Surf> surf = surfOf(view);
      grid_.fill(view.water->at(view.time), view.camera, layout, bound, surf ? &*surf : nullptr);
      bound = std::max(bound, 1.05 * grid_.largestHeight());
      return SeaPlacement{grid_.largestHeight(), grid_.vertexCount(),
                          grid_.verticesInFrustum(view.camera)};
    };
    if (!render::placeSea(view, 1.0, place, stats)) return false;
    slopes_.fill(grid_, layout);
    march_.fill(grid_, layout, view.camera, bound, options_.steps);
    return true;
  }

  RayStart rayStart() const {
    return waterline().isSplit()    ? RayStart::either
           : waterline().allUnder() ? RayStart::below
                                    : RayStart::above;
  }

  void rasterSea(const View&, Strip& strip) override {
    if (strip.object.empty()) {
      march_.march(nullptr, rayStart(), strip);
      return;
    }
    Strip scene;
    scene.clear(strip.top, strip.rows, strip.width, true);
    objects().raster(scene);
    march_.march(&scene, rayStart(), strip);
  }

  void fillSeaSpan(const View& view, const float* inverse, int, int, bool underWater,
                   PixelSpan& span) const override {
    slopes_.fillSpan(inverse, view.camera, underWater, span);
    march_.fillSlopes(span);
  }

  std::size_t seaMemoryBytes() const override {
    return grid_.memoryBytes() + slopes_.memoryBytes();
  }

  PostProcessOptions options_;
  SeaGrid grid_;
  SeaSlopes slopes_;
  SeaMarch march_;
};

}  // namespace

std::unique_ptr<RenderTechnique> makePostProcess(const PostProcessOptions& options) {
  return std::make_unique<PostProcess>(options);
}

}  // namespace seaway::render
