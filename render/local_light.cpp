#include "render/local_light.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <tuple>

#include "render/scene_object.h"

namespace seaway::render {
namespace {

/// Beyond, no red and little else comes back from under water: the wet part of a hull is not seen.
constexpr double farthestBelow = 400.0;  // m
constexpr int rowsPerPiece = 16;

/// The water's height at each object without waves shorter than it, m; NaN ashore.
std::vector<double> levelsAt(const View& view) {
  std::vector<double> levels;
  for (const SceneObject& object : view.objects) {
    const double length = object.mesh ? 2.0 * object.mesh->boundingRadius : 0.0;
    const SurfaceSample sample =
        view.water->sample(glm::dvec2(object.position), view.time, {.shortestWavelength = length});
    levels.push_back(sample.height);
  }
  return levels;
}

/// Of those objects that the camera is nearer than `farthest` to.
void forgetFar(const View& view, double farthest, std::vector<double>& levels) {
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const double away = glm::length(view.objects[i].position - view.camera.position);
    if (away > farthest) levels[i] = std::numeric_limits<double>::quiet_NaN();
  }
}

void hold(const View& view, Effect effect, const LocalImage& image) {
  view.effects->chargeInside(effect, Effect::water);
  view.effects->holdMemory(effect, image.memoryBytes());
}

/// Rays of a row's pixels from `first` on.
void setRays(const ShadingConstants& c, glm::ivec2 picture, glm::ivec2 first, PixelSpan& span) {
  const glm::vec2 perPixel = 2.0f / glm::vec2(picture);
  const float upwards = 1.0f - (static_cast<float>(first.y) + 0.5f) * perPixel.y;
  const float across = (static_cast<float>(first.x) + 0.5f) * perPixel.x - 1.0f;
  span.rayStep = c.right * perPixel.x;
  span.firstRay = c.middleRay + across * c.right + upwards * c.up;
}

}  // namespace

void LocalLight::fill(const View& view, const Shown& shown, const ShadingSources& sources,
                      const TerrainInView& terrain) {
  fillAbove(view, shown, sources, terrain);
  fillUnder(view, shown, sources, terrain);
}

void LocalLight::fillAbove(const View& view, const Shown& shown, const ShadingSources& sources,
                           const TerrainInView& terrain) {
  mirrored_.size = below_.size = {0, 0};
  const bool isWanted =
      !view.effects->isOff(Effect::reflection) || !view.effects->isOff(Effect::refraction);
  const bool mayShow = isWanted && shown.water && !shown.cameraIsUnderWater &&
                       (!view.objects.empty() || terrain.isShown());
  shoreHardness_ = 0.0f;
  std::vector<double> levels;
  if (mayShow) levels = levelsAt(view);
  const auto decide = [&](Effect effect, WaterSide side, const char* yes, LocalImage& image) {
    triangles_.clear();
    ground_.clear();
    if (mayShow && !view.effects->isOff(effect)) {
      triangles_.fill(view.objects, view.camera, side, levels);
      terrain.fill(view.camera,
                   side == WaterSide::below ? TerrainSide::below : TerrainSide::mirrored,
                   sources.constants.waterExtinction.z, ground_);
    }
    const bool called = !triangles_.empty() || !ground_.empty();
    const char* no = !shown.water               ? "no water in the picture"
                     : shown.cameraIsUnderWater ? "the camera is under water"
                     : !mayShow                 ? "there is nothing but water"
                                                : "nothing is near enough to show";
    if (!view.effects->decide(effect, called, called ? yes : no) || !called) {
      image = {};
      return;
    }
    draw({view.camera, terrain, side}, sources, image);
    if (side == WaterSide::mirrored) {
      image.tiles.fill(image.nearness.data(), image.size, static_cast<std::size_t>(image.size.x));
      const auto objects = triangles_.axialRange(), land = ground_.axialRange();
      nearest_ = std::min(objects.first, land.first);
      farthest_ = std::max(objects.second, land.second);
      mirrorBend_ = ground_.empty() ? 0.0f : 1.0f;
    } else if (!ground_.empty()) {
      shoreHardness_ = static_cast<float>(terrain.map().look().shoreHardness);
    }
    hold(view, effect, image);
  };
  decide(Effect::reflection, WaterSide::mirrored, "water mirrors what stands in or by it",
         mirrored_);
  if (mayShow) forgetFar(view, farthestBelow, levels);
  decide(Effect::refraction, WaterSide::below, "a vessel's wet part or the sea bed is in view",
         below_);
  if (!mayShow) triangles_ = {};
  if (!terrain.isShown()) ground_ = {};
}

void LocalLight::fillUnder(const View& view, const Shown& shown, const ShadingSources& sources,
                           const TerrainInView& terrain) {
  const bool shows = shown.water && shown.anyUnderWater && !view.objects.empty() &&
                     !view.effects->isOff(Effect::underWater);
  if (!shows) {
    window_ = depths_ = {};
    return;
  }
  std::vector<double> levels = levelsAt(view);
  const glm::dvec3 eye = view.camera.position;
  const double surface = view.water->sample(glm::dvec2(eye), view.time).height;
  // With the eye in the surface or above it, as just below it.
  const double depth = std::isfinite(surface) ? std::max(surface - eye.z, 1e-3) : 1e-3;
  ShadingConstants unshadowed = sources.constants;  // the window's places are not kept
  unshadowed.shadowCount = 0;
  const auto fill = [&](const ShadingConstants& constants, LocalImage& image) {
    image.size = {0, 0};
    if (triangles_.empty()) return;
    draw({view.camera, terrain, WaterSide::depths},
         {.constants = constants,
          .sky = sources.sky,
          .shadows = sources.shadows,
          .shadowWidth = sources.shadowWidth},
         image);
  };
  ground_.clear();
  triangles_.fillWindow(view.objects, view.camera, depth, levels);
  fill(unshadowed, window_);
  forgetFar(view, farthestBelow, levels);
  triangles_.fill(view.objects, view.camera, WaterSide::depths, levels);
  fill(sources.constants, depths_);
  triangles_.clear();
  constexpr std::size_t side = ShadingConstants::waterlineCells + 1;
  const std::size_t line = sources.constants.waterlineIsOn ? side * side * sizeof(float) : 0;
  view.effects->holdMemory(Effect::underWater,
                           window_.memoryBytes() + depths_.memoryBytes() + line);
}

/// Makes a span of a row of the two strips ready to be shaded: the nearer of objects and ground.
void LocalLight::fillSpan(const Drawn& drawn, const Strip& objects, const Strip& ground, int line,
                          int first, const ShadingConstants& constants, PixelSpan& span) const {
  const std::size_t at = static_cast<std::size_t>(line) * objects.stride + first;
  const float* inverse = objects.inverse.data() + at;
  std::fill_n(span.kind, pixelsPerSpan, ShadedAs::ground);
  std::fill_n(span.axial, pixelsPerSpan, 1.0f);
  triangles_.fillSpan(objects.object.data() + at, inverse, span);
  setRays(constants, drawn.camera.size, {first, objects.top + line}, span);
  if (ground_.empty()) return;
  for (int i = 0; i < span.count; ++i) {
    if (inverse[i] == 0.0f) span.kind[i] = ShadedAs::sky;
  }
  const bool mirrored = drawn.side == WaterSide::mirrored;
  drawn.terrain.fillSpan(drawn.camera, ground.inverse.data() + at,
                         mirrored ? TerrainSide::mirrored : TerrainSide::below, span);
  for (int i = 0; i < span.count; ++i) {
    if (span.kind[i] == ShadedAs::sky) span.kind[i] = ShadedAs::ground;
  }
}

void LocalLight::draw(const Drawn& drawn, const ShadingSources& sources, LocalImage& image) const {
  const glm::ivec2 picture = drawn.camera.size;
  const PixelBox ofObjects = triangles_.boxIn(picture), ofGround = ground_.boxIn(picture);
  PixelBox box = ground_.empty() ? ofObjects : ofGround;
  if (!ground_.empty() && !triangles_.empty()) {
    box = {glm::min(ofObjects.least, ofGround.least), glm::max(ofObjects.end, ofGround.end)};
  }
  image.least = box.least;
  image.size = box.end - box.least;
  image.resize();
  ShadingConstants lit = sources.constants;
  lit.hazeIsOn = false;
  lit.lampCount = 0;  // places are not known here
  lit.cameraIsUnderWater = lit.waterlineIsOn = false;
  const ShadingSources with{.constants = lit,
                            .sky = sources.sky,
                            .shadows = sources.shadows,
                            .shadowWidth = sources.shadowWidth};
  const int pieces = (image.size.y + rowsPerPiece - 1) / rowsPerPiece;
  tbb::parallel_for(0, pieces, [&](int piece) {
    Strip strip, ground;
    const int top = box.least.y + piece * rowsPerPiece;
    strip.clear(top, std::min(rowsPerPiece, box.end.y - top), picture.x, true);
    triangles_.raster(strip);
    if (!ground_.empty()) {
      ground.clear(top, strip.rows, picture.x, false);
      ground_.raster(ground);
    }
    PixelSpan span;
    std::uint32_t light[pixelsPerSpan + 16];
    for (int line = 0; line < strip.rows; ++line) {
      const std::size_t row = static_cast<std::size_t>(line) * strip.stride;
      for (int first = box.least.x; first < box.end.x; first += pixelsPerSpan) {
        span.count = std::min(pixelsPerSpan, box.end.x - first);
        fillSpan(drawn, strip, ground, line, first, lit, span);
        const float* inverse = strip.inverse.data() + row + first;
        const float* land = ground_.empty() ? inverse : ground.inverse.data() + row + first;
        if (span.hasObjects) shadeSpan(with, span, light);
        const std::size_t to = static_cast<std::size_t>(top + line - box.least.y) * image.size.x +
                               (first - box.least.x);
        for (int i = 0; i < span.count; ++i) {
          const float nearer = std::max(inverse[i], land[i]);
          image.nearness[to + i] = nearer;
          image.light[to + i] = nearer > 0.0f ? light[i] : 0u;
        }
      }
    }
  });
}

void LocalLight::setConstants(ShadingConstants& constants) const {
  constants.mirrorIsOn = !mirrored_.empty();
  constants.belowIsOn = !below_.empty();
  constants.windowIsOn = !window_.empty();
  constants.depthsAreOn = !depths_.empty();
  constants.windowLeast = glm::vec2(window_.least);
  constants.windowSize = glm::vec2(window_.size);
  constants.depthsLeast = glm::vec2(depths_.least);
  constants.depthsSize = glm::vec2(depths_.size);
  constants.mirrorLeast = glm::vec2(mirrored_.least);
  constants.mirrorSize = glm::vec2(mirrored_.size);
  constants.belowLeast = glm::vec2(below_.least);
  constants.belowSize = glm::vec2(below_.size);
  // Between steps a ray passes a twentieth of its way over the picture at most, on slopes of 0.15.
  const float part = farthest_ > 0.0f ? 1.0f - nearest_ / farthest_ : 0.0f;
  constants.mirrorSteps = std::clamp(static_cast<int>(std::ceil(10.0f * part)), 2, 6);
  constants.shoreHardness = below_.empty() ? 0.0f : shoreHardness_;
  constants.mirrorBend = mirrorBend_;
  constants.mirrorNearest = 0.99f * nearest_;
  constants.mirrorFarthest = 1.01f * farthest_;
}

}  // namespace seaway::render
