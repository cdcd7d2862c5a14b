#include "render/software/strip_technique.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "render/edge_smoothing.h"
#include "render/grid_placement.h"
#include "render/pass_timer.h"

namespace seaway::render {
namespace {

constexpr int rowsPerStrip = 32;

/// Depth, class and, where asked for, normal of a span's pixels.
void store(const PixelSpan& span, std::size_t at, Frame& frame) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (int i = 0; i < span.count; ++i) {
    const bool isSky = span.kind[i] == ShadedAs::sky;
    frame.depth.metres[at + i] = isSky ? infinity : span.axial[i];
    frame.classes[at + i] = isSky                                ? PixelClass::sky
                            : span.kind[i] == ShadedAs::object ? PixelClass::object
                            : span.kind[i] == ShadedAs::ground ? PixelClass::ground
                                                                 : PixelClass::water;
  }
  if (frame.normals.empty()) return;
  for (int i = 0; i < span.count; ++i) {
    glm::vec3 normal(0.0f);
    if (span.kind[i] == ShadedAs::object || span.kind[i] == ShadedAs::ground) {
      normal = {span.normal[0][i], span.normal[1][i], span.normal[2][i]};
    } else if (span.kind[i] != ShadedAs::sky) {
      normal = glm::normalize(glm::vec3(-span.slopeX[i], -span.slopeY[i], 1.0f));
    }
    frame.normals[at + i] = normal;
  }
}

}  // namespace

void StripTechnique::raster(const View& view, const Shown& shown) {
  const glm::ivec2 size = view.camera.size;
  const int count = (size.y + rowsPerStrip - 1) / rowsPerStrip;
  strips_.resize(count);
  tbb::parallel_for(0, count, [&](int i) {
    const int top = i * rowsPerStrip;
    strips_[i].clear(top, std::min(rowsPerStrip, size.y - top), size.x, shown.objects);
    if (shown.water) rasterSea(view, strips_[i]);
    if (!hollows_.empty()) cutHollows(hollows_, view.camera, strips_[i]);
    if (shown.objects) objects_.raster(strips_[i]);
  });
}

void StripTechnique::shadeRow(const View& view, const ShadingConstants& constants,
                              const Shown& shown, int row, Frame& frame) const {
  const Strip& strip = strips_[row / rowsPerStrip];
  const glm::ivec2 size = view.camera.size;
  const std::size_t stripRow = static_cast<std::size_t>(row - strip.top) * strip.stride;
  const glm::vec2 perPixel = 2.0f / glm::vec2(size);
  const float upwards = 1.0f - (static_cast<float>(row) + 0.5f) * perPixel.y;
  PixelSpan span;
  span.rayStep = constants.right * perPixel.x;
  for (int first = 0; first < size.x; first += pixelsPerSpan) {
    span.count = std::min(pixelsPerSpan, size.x - first);
    const float across = (static_cast<float>(first) + 0.5f) * perPixel.x - 1.0f;
    span.firstRay = constants.forward + across * constants.right + upwards * constants.up;
    const float* inverse = strip.inverse.data() + stripRow + first;
    if (shown.water) {
      fillSeaSpan(view, inverse, row, first, shown.cameraIsUnderWater, span);
    } else {
      std::fill_n(span.kind, pixelsPerSpan, ShadedAs::sky);
      std::fill_n(span.axial, pixelsPerSpan, 1.0f);
    }
    if (shown.objects) objects_.fillSpan(strip.object.data() + stripRow + first, inverse, span);
    if (shore_) shore_->fillSpan(span);
    const std::size_t at = static_cast<std::size_t>(row) * size.x + first;
    shadeSpan(constants, constants.skyIsOn ? sky_->texels().data() : nullptr, span,
              frame.colour.rgb.data() + 3 * at);
    store(span, at, frame);
  }
}

void StripTechnique::shade(const View& view, const Shown& shown, const Lighting& lighting,
                           Frame& frame) const {
  const ShadingConstants constants = shadingConstants(view, lighting);
  tbb::parallel_for(0, view.camera.size.y,
                    [&](int row) { shadeRow(view, constants, shown, row, frame); });
}

void StripTechnique::drawInto(const View& view, Frame& frame) {
  validate(view.camera);
  prepare(frame, view.camera.size, view.wantsNormals);
  FrameStats& stats = frame.stats;
  stats.technique = name();
  stats.backend = "none";
  stats.renderer = "processor";
  PassTimer timer(view, stats);
  Shown shown;
  shown.water = placeSea(view, stats);
  shown.cameraIsUnderWater = shown.water && cameraIsUnderWater(view);
  const auto water = shown.water ? std::optional(Effect::water) : std::nullopt;
  timer.finish("vertices", water);
  shown.objects = decideObjects(view);
  if (shown.objects) {
    objects_.fill(view.objects, view.camera);
    timer.finish("objects", Effect::vesselMeshes);
  }
  shore_.reset();
  if (const WaterOutline* outline = decideOutline(view, shown.water)) {
    shore_.emplace(*outline, view.camera);
    view.effects->chargeInside(Effect::outline, Effect::water);
    view.effects->holdMemory(Effect::outline, outline->memoryBytes());
  }
  hollows_ = decideHollows(view, shown.water);
  if (!hollows_.empty()) view.effects->chargeInside(Effect::hullMask, Effect::water);
  raster(view, shown);
  if (shown.water) timer.finish("water", water);
  const Lighting lighting = decideLighting(view, shown, sky_);
  if (lighting.sky) timer.finish("sky", Effect::sky);
  shade(view, shown, lighting, frame);
  const auto payer = shown.water    ? water
                     : lighting.sky ? std::optional(Effect::sky)
                                    : std::nullopt;
  timer.finish("shading", payer);
  if (lighting.sunIsOn && payer) view.effects->chargeInside(Effect::sun, *payer);
  smoothEdges(frame.colour, frame.depth, frame.classes);
  timer.finish("smoothing", std::nullopt);
  if (seaMemoryBytes() > 0) view.effects->holdMemory(Effect::water, seaMemoryBytes());
  if (sky_) view.effects->holdMemory(Effect::sky, sky_->memoryBytes());
  const std::size_t objects = objects_.memoryBytes();
  if (objects > 0) view.effects->holdMemory(Effect::vesselMeshes, objects);
}

}  // namespace seaway::render
