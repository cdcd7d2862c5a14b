#include "render/software/strip_technique.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "render/edge_smoothing.h"
#include "render/grid_placement.h"
#include "render/pass_timer.h"
#include "render/shown_objects.h"

namespace seaway::render {
namespace {

constexpr int rowsPerStrip = 32;

/// Depth, class and, where asked for, normal of a span's pixels.
void store(const PixelSpan& span, std::size_t at, Frame& frame) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (int i = 0; i < span.count; ++i) {
    const bool isSky = span.kind[i] == ShadedAs::sky;
    frame.depth.metres[at + i] = isSky ? infinity : span.axial[i];
    frame.classes[at + i] = isSky                              ? PixelClass::sky
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
  edges_.resize(shown.objects ? count : 0);
  groundStrips_.resize(ground_.empty() ? 0 : count);
  tbb::parallel_for(0, count, [&](int i) {
    const int top = i * rowsPerStrip;
    const int rows = std::min(rowsPerStrip, size.y - top);
    const bool hasObjects =
        shown.objects && top < objectBox_.end.y && top + rows > objectBox_.least.y;
    strips_[i].clear(top, rows, size.x, hasObjects);
    if (shown.water) rasterSea(view, strips_[i]);
    if (!hollows_.empty()) cutHollows(hollows_, view.camera, strips_[i]);
    if (!groundStrips_.empty()) {
      groundStrips_[i].clear(top, strips_[i].rows, size.x, false);
      ground_.raster(groundStrips_[i]);
    }
    if (shown.objects) edges_[i].fill(objects_, strips_[i]);
    if (!hasObjects) return;
    objects_.raster(strips_[i]);
  });
}

/// Makes ready to shade `span.count` pixels of a row from `first` on: the sea by its 1/axial
/// distance in `sea`, before it objects `which` by theirs in `objects`.
void StripTechnique::fillSpan(const ShadedRow& r, int first, const float* sea,
                              const std::uint32_t* which, const float* objects,
                              PixelSpan& span) const {
  const glm::vec2 perPixel = 2.0f / glm::vec2(r.view.camera.size);
  const float upwards = 1.0f - (static_cast<float>(r.row) + 0.5f) * perPixel.y;
  const float across = (static_cast<float>(first) + 0.5f) * perPixel.x - 1.0f;
  span.first = {first, r.row};
  span.rayStep = r.constants.right * perPixel.x;
  span.firstRay = r.constants.middleRay + across * r.constants.right + upwards * r.constants.up;
  if (r.shown.water) {
    fillSeaSpan(r.view, sea, r.row, first, r.shown.cameraIsUnderWater, span);
    waterline_.fillSpan(r.row, first, span);
  } else {
    std::fill_n(span.kind, pixelsPerSpan, ShadedAs::sky);
    std::fill_n(span.axial, pixelsPerSpan, 1.0f);
  }
  span.hasObjects = span.hasPlaces = false;
  const bool besideObjects = r.row < objectBox_.least.y || r.row >= objectBox_.end.y ||
                             first >= objectBox_.end.x || first + span.count <= objectBox_.least.x;
  if (which && !besideObjects) objects_.fillSpan(which, objects, span);
  if (shore_) shore_->fillSpan(span);
  if (groundStrips_.empty()) return;
  const Strip& ground = groundStrips_[r.row / rowsPerStrip];
  const std::size_t at = static_cast<std::size_t>(r.row - ground.top) * ground.stride + first;
  terrain_.fillSpan(r.view.camera, ground.inverse.data() + at, TerrainSide::direct, span);
}

/// What labels tell of a span's pixels.
void StripTechnique::storeLabels(const ShadedRow& r, const PixelSpan& span,
                                 const std::uint32_t* which, std::size_t at, Frame& frame) const {
  alignas(64) float white[pixelsPerSpan + 16];
  foamParts(ShadingSources{r.constants}, span, white);
  for (int i = 0; i < span.count; ++i) {
    frame.foam[at + i] = static_cast<std::uint8_t>(255.0f * white[i] + 0.5f);
    const bool isObject = which && span.kind[i] == ShadedAs::object;
    frame.instances[at + i] = isObject ? objects_.instanceOf(which[i]) : std::uint16_t{0};
  }
}

ShadingSources StripTechnique::sourcesFor(const ShadingConstants& constants) const {
  return {.constants = constants,
          .sky = constants.skyIsOn ? sky_->texels().data() : nullptr,
          .mirrored = &local_.mirrored(),
          .below = &local_.below(),
          .window = &local_.window(),
          .depths = &local_.depths(),
          .shadows = shadows_.texels().data(),
          .shadowWidth = shadows_.size().x,
          .shadowTiles = shadows_.tiles(),
          .waterline = waterline_.heights().data()};
}

/// Colours of a span's pixels, and their radiance unless that is null.
void StripTechnique::colour(const ShadedRow& r, const PixelSpan& span, std::uint8_t* rgb,
                            glm::vec3* radiance) const {
  const ShadingSources sources = sourcesFor(r.constants);
  if (!radiance) {
    shadeSpan(sources, span, rgb);
    return;
  }
  glm::vec4 shaded[pixelsPerSpan + 16];
  shadeSpan(sources, span, shaded);
  for (int i = 0; i < span.count; ++i) radiance[i] = glm::vec3(shaded[i]);
  const Light& light = r.view.light;
  mapTones({radiance, static_cast<std::size_t>(span.count)},
           {r.constants.exposure, light.toneCurve, light.dithers}, span.first, rgb);
}

void StripTechnique::shadeRow(const ShadedRow& r, Frame& frame) {
  const Strip& strip = strips_[r.row / rowsPerStrip];
  const int width = r.view.camera.size.x;
  const std::size_t stripRow = static_cast<std::size_t>(r.row - strip.top) * strip.stride;
  PixelSpan span;
  for (int first = 0; first < width; first += pixelsPerSpan) {
    span.count = std::min(pixelsPerSpan, width - first);
    const float* inverse = strip.inverse.data() + stripRow + first;
    const std::uint32_t* which =
        strip.object.empty() ? nullptr : strip.object.data() + stripRow + first;
    fillSpan(r, first, inverse, which, inverse, span);
    const std::size_t at = static_cast<std::size_t>(r.row) * width + first;
    colour(r, span, frame.colour.rgb.data() + 3 * at,
           frame.radiance.empty() ? nullptr : &frame.radiance[at]);
    store(span, at, frame);
    if (!frame.foam.empty()) {
      storeLabels(r, span, which, at, frame);
    }
  }
  if (r.shown.objects) softenObjects(r, frame);
}

/// Where objects cover a part of a pixel, mixes what its centre does not show into its colour.
void StripTechnique::softenObjects(const ShadedRow& r, Frame& frame) {
  const Strip& strip = strips_[r.row / rowsPerStrip];
  const ObjectEdges& edges = edges_[r.row / rowsPerStrip];
  if (edges.left() == edges.right() || strip.object.empty()) return;
  const int line = r.row - strip.top;
  const ObjectEdges::Row row = edges.row(line);
  const std::uint32_t* centre = strip.object.data() + static_cast<std::size_t>(line) * strip.stride;
  const auto otherSamples = [&](int x) {
    const int covered = row.covered(x - edges.left());
    return centre[x] != 0 ? ObjectEdges::samples - covered : covered;
  };
  PixelSpan span;
  std::uint32_t which[pixelsPerSpan];
  std::uint8_t other[3 * pixelsPerSpan];
  for (int first = edges.left(); first < edges.right(); first += span.count) {
    while (first < edges.right() && otherSamples(first) == 0) ++first;
    span.count = 0;
    for (int x = first; x < edges.right() && span.count < pixelsPerSpan; ++x, ++span.count) {
      if (otherSamples(x) == 0) break;
      which[span.count] = centre[x] != 0 ? 0 : row.object[x - edges.left()];
    }
    if (span.count == 0) return;
    const int at = first - edges.left();
    fillSpan(r, first, row.sea + at, which, row.inverse + at, span);
    glm::vec3 otherRadiance[pixelsPerSpan];
    const bool hasRadiance = !frame.radiance.empty();
    colour(r, span, other, hasRadiance ? otherRadiance : nullptr);
    const std::size_t pixel = static_cast<std::size_t>(r.row) * strip.width + first;
    std::fill_n(&isSoftened_[pixel], span.count, std::uint8_t{1});
    for (int i = 0; hasRadiance && i < span.count; ++i) {
      const float part = static_cast<float>(otherSamples(first + i)) / ObjectEdges::samples;
      frame.radiance[pixel + i] = glm::mix(frame.radiance[pixel + i], otherRadiance[i], part);
    }
    std::uint8_t* rgb = &frame.colour.rgb[3 * pixel];
    for (int i = 0; i < 3 * span.count; ++i) {
      const int weight = otherSamples(first + i / 3);
      rgb[i] = static_cast<std::uint8_t>((rgb[i] * (ObjectEdges::samples - weight) +
                                          other[i] * weight + ObjectEdges::samples / 2) /
                                         ObjectEdges::samples);
    }
  }
}

void StripTechnique::shade(const View& view, const Shown& shown, const Lighting& lighting,
                           Frame& frame) {
  isSoftened_.assign(shown.objects ? frame.classes.size() : 0, 0);
  ShadingConstants constants = shadingConstants(view, lighting);
  waterline_.setConstants(constants);
  shadows_.setConstants(constants);
  local_.fill(view, shown, sourcesFor(constants), terrain_);
  local_.setConstants(constants);
  frame.exposure = constants.exposure;
  tbb::parallel_for(0, view.camera.size.y, [&](int row) {
    shadeRow({view, constants, shown, row}, frame);
  });
}

void StripTechnique::prepareTerrain(const View& view, Shown& shown) {
  terrain_.prepare(view, shown);
  shown.terrain = terrain_.isShown();
  ground_.clear();
  if (!shown.terrain) {
    groundStrips_ = {};
    return;
  }
  ground_.fill(terrain_.corners(), view.camera);
}

void StripTechnique::drawInto(const View& given, Frame& frame) {
  const View view = withoutSwitchedOff(given, kept_);
  validatePlain(view);
  prepare(frame, view.camera.size, view.contents());
  FrameStats& stats = frame.stats;
  stats.technique = name();
  stats.backend = "none";
  stats.renderer = "processor";
  PassTimer timer(view, stats);
  Shown shown;
  shown.water = placeSea(view, stats);
  waterline_.fill(view, shown.water);
  shown.cameraIsUnderWater = waterline_.allUnder();
  shown.anyUnderWater = waterline_.anyUnder();
  const auto water = shown.water ? std::optional(Effect::water) : std::nullopt;
  timer.finish("vertices", water);
  const std::optional<Effect> meshes = decideObjects(view);
  shown.objects = meshes.has_value();
  if (shown.objects) {
    objects_.fill(view.objects, view.camera);
    objectBox_ = objects_.boxIn(view.camera.size);
    timer.finish("objects", meshes);
  }
  prepareTerrain(view, shown);
  if (shown.terrain) timer.finish("terrain", Effect::terrain);
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
  shadows_.fill(view, shown, lighting);
  if (shadows_.size().x > 0) timer.finish("shadows", Effect::shadows);
  shade(view, shown, lighting, frame);
  const auto payer = shown.water ? water : lighting.sky ? std::optional(Effect::sky) : std::nullopt;
  timer.finish("shading", payer);
  if (lighting.sunIsOn && payer) view.effects->chargeInside(Effect::sun, *payer);
  smoothEdges(frame.colour, frame.depth, frame.classes, isSoftened_);
  timer.finish("smoothing", std::nullopt);
  if (seaMemoryBytes() > 0) view.effects->holdMemory(Effect::water, seaMemoryBytes());
  if (sky_) view.effects->holdMemory(Effect::sky, sky_->memoryBytes());
  std::size_t objects = objects_.memoryBytes() + isSoftened_.capacity();
  for (const ObjectEdges& edges : edges_) objects += edges.memoryBytes();
  if (objects > 0) view.effects->holdMemory(meshes.value_or(Effect::vesselMeshes), objects);
  if (!shown.terrain) return;
  std::size_t terrain = terrain_.memoryBytes() + ground_.memoryBytes();
  for (const Strip& strip : groundStrips_) terrain += strip.inverse.capacity() * sizeof(float);
  view.effects->holdMemory(Effect::terrain, terrain);
}

}  // namespace seaway::render
