#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "render/edge_smoothing.h"
#include "render/grid_placement.h"
#include "render/lighting_decision.h"
#include "render/pass_timer.h"
#include "render/render_technique.h"
#include "render/sea_grid.h"
#include "render/software/object_triangles.h"
#include "render/software/raster.h"
#include "render/software/sea_spans.h"

namespace seaway::render {
namespace {

constexpr int rowsPerStrip = 32;

/// Everything on the processor: heights, raster and shading, in strips of the picture that threads
/// share. No graphics context.
class SoftwareGridTechnique final : public RenderTechnique {
 public:
  explicit SoftwareGridTechnique(const ProjectedGridOptions& options) : options_(options) {
    validate(options_);
  }

  std::string name() const override { return "projected_grid"; }
  void drawInto(const View& view, Frame& frame) override;

 private:
  void placeGrid(const View& view, Shown& shown, FrameStats& stats);
  void raster(const View& view, const Shown& shown);
  void shade(const View& view, const Shown& shown, const Lighting& lighting, Frame& frame) const;
  void shadeRow(const ShadingConstants& constants, const Shown& shown, const Camera& camera,
                const Strip& strip, int row, Frame& frame) const;
  void holdMemory(EffectLedger& effects) const;

  ProjectedGridOptions options_;
  SeaGrid grid_;
  ScreenGrid screen_;
  SeaSlopes slopes_;
  ObjectTriangles objects_;
  std::vector<Strip> strips_;
  std::optional<SkyDome> sky_;
};

void SoftwareGridTechnique::placeGrid(const View& view, Shown& shown, FrameStats& stats) {
  std::optional<SurfaceAtTime> water;
  if (view.water) water.emplace(view.water->at(view.time));
  const auto place = [&](const Projector& projector) {
    grid_.fill(*water, view.camera, projector, options_.grid);
    return SeaPlacement{grid_.largestHeight(), grid_.vertexCount(),
                        grid_.verticesInFrustum(view.camera)};
  };
  const auto projector = placeSea(view, options_.projectorElevation, place, stats);
  shown.water = projector.has_value();
  if (!projector) return;
  shown.cameraIsUnderWater = cameraIsUnderWater(view);
  screen_.fill(grid_, view.camera);
  slopes_.fill(grid_, *projector);
}

void SoftwareGridTechnique::raster(const View& view, const Shown& shown) {
  const glm::ivec2 size = view.camera.size;
  const int count = (size.y + rowsPerStrip - 1) / rowsPerStrip;
  strips_.resize(count);
  tbb::parallel_for(
      0, count,
      [&](int i) {
        const int top = i * rowsPerStrip;
        strips_[i].clear(top, std::min(rowsPerStrip, size.y - top), size.x, shown.objects);
        if (shown.water) rasterSea(screen_, strips_[i]);
        if (shown.objects) objects_.raster(strips_[i]);
      },
      tbb::simple_partitioner());
}

void SoftwareGridTechnique::shadeRow(const ShadingConstants& constants, const Shown& shown,
                                     const Camera& camera, const Strip& strip, int row,
                                     Frame& frame) const {
  const std::size_t stripRow = static_cast<std::size_t>(row - strip.top) * strip.stride;
  const glm::vec2 perPixel = 2.0f / glm::vec2(camera.size);
  const float upwards = 1.0f - (static_cast<float>(row) + 0.5f) * perPixel.y;
  PixelSpan span;
  span.rayStep = constants.right * perPixel.x;
  for (int first = 0; first < camera.size.x; first += pixelsPerSpan) {
    span.count = std::min(pixelsPerSpan, camera.size.x - first);
    const float across = (static_cast<float>(first) + 0.5f) * perPixel.x - 1.0f;
    span.firstRay = constants.forward + across * constants.right + upwards * constants.up;
    const float* inverse = strip.inverse.data() + stripRow + first;
    slopes_.fillSpan(inverse, static_cast<float>(camera.position.z), constants.pixelAngle,
                     shown.cameraIsUnderWater, span);
    if (shown.objects) objects_.fillSpan(strip.object.data() + stripRow + first, inverse, span);
    const std::size_t at = static_cast<std::size_t>(row) * camera.size.x + first;
    shadeSpan(constants, sky_ && constants.skyIsOn ? sky_->texels().data() : nullptr, span,
              frame.colour.rgb.data() + 3 * at);
    for (int i = 0; i < span.count; ++i) {
      const bool isSky = span.kind[i] == ShadedAs::sky;
      frame.depth.metres[at + i] =
          isSky ? std::numeric_limits<float>::infinity() : span.axial[i];
      frame.classes[at + i] = isSky                                ? PixelClass::sky
                              : span.kind[i] == ShadedAs::object ? PixelClass::object
                                                                   : PixelClass::water;
    }
  }
}

void SoftwareGridTechnique::shade(const View& view, const Shown& shown, const Lighting& lighting,
                                  Frame& frame) const {
  const ShadingConstants constants = shadingConstants(view, lighting);
  tbb::parallel_for(0, view.camera.size.y, [&](int row) {
    shadeRow(constants, shown, view.camera, strips_[row / rowsPerStrip], row, frame);
  });
}

void SoftwareGridTechnique::holdMemory(EffectLedger& effects) const {
  const std::size_t water =
      grid_.memoryBytes() + screen_.memoryBytes() + slopes_.memoryBytes();
  if (water > 0) effects.holdMemory(Effect::water, water);
  if (sky_) effects.holdMemory(Effect::sky, sky_->memoryBytes());
  if (objects_.memoryBytes() > 0) {
    effects.holdMemory(Effect::vesselMeshes, objects_.memoryBytes());
  }
}

void SoftwareGridTechnique::drawInto(const View& view, Frame& frame) {
  validate(view.camera);
  prepare(frame, view.camera.size);
  frame.stats.technique = name();
  frame.stats.variant = gridVariantName(GridVariant::software);
  frame.stats.backend = "none";
  frame.stats.renderer = "software";
  PassTimer timer(view, frame.stats);
  Shown shown;
  placeGrid(view, shown, frame.stats);
  timer.finish("vertices", shown.water ? std::optional(Effect::water) : std::nullopt);
  shown.objects = decideObjects(view);
  if (shown.objects) {
    objects_.fill(view.objects, view.camera);
    timer.finish("objects", Effect::vesselMeshes);
  }
  raster(view, shown);
  timer.finish("water", shown.water ? std::optional(Effect::water) : std::nullopt);
  const Lighting lighting = decideLighting(view, shown, sky_);
  if (lighting.sky) timer.finish("sky", Effect::sky);
  shade(view, shown, lighting, frame);
  timer.finish("shading", shown.water    ? std::optional(Effect::water)
                          : lighting.sky ? std::optional(Effect::sky)
                                         : std::nullopt);
  smoothEdges(frame.colour, frame.depth, frame.classes);
  timer.finish("smoothing", std::nullopt);
  holdMemory(*view.effects);
}

}  // namespace

std::unique_ptr<RenderTechnique> makeSoftwareGrid(const ProjectedGridOptions& options) {
  return std::make_unique<SoftwareGridTechnique>(options);
}

}  // namespace seaway::render
