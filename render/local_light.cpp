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
  view.effects->holdMemory(effect, image.texels.capacity() * sizeof(glm::vec4));
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

void LocalLight::fill(const View& view, const Shown& shown, const ShadingSources& sources) {
  fillAbove(view, shown, sources);
  fillUnder(view, shown, sources);
}

void LocalLight::fillAbove(const View& view, const Shown& shown, const ShadingSources& sources) {
  mirrored_.size = below_.size = {0, 0};
  const bool mayShow = shown.water && !shown.cameraIsUnderWater && !view.objects.empty();
  std::vector<double> levels;
  if (mayShow) levels = levelsAt(view);
  const auto decide = [&](Effect effect, WaterSide side, const char* yes, LocalImage& image) {
    triangles_.clear();
    if (mayShow) triangles_.fill(view.objects, view.camera, side, levels);
    const bool called = !triangles_.empty();
    const char* no = !shown.water               ? "no water in the picture"
                     : shown.cameraIsUnderWater ? "the camera is under water"
                     : view.objects.empty()     ? "there is nothing but water"
                                                : "nothing is near enough to show";
    if (!view.effects->decide(effect, called, called ? yes : no) || !called) {
      image = {};
      return;
    }
    draw(view.camera.size, sources, image);
    if (side == WaterSide::mirrored) std::tie(nearest_, farthest_) = triangles_.axialRange();
    hold(view, effect, image);
  };
  decide(Effect::reflection, WaterSide::mirrored, "water mirrors something", mirrored_);
  if (mayShow) forgetFar(view, farthestBelow, levels);
  decide(Effect::refraction, WaterSide::below, "something's wet part is in view", below_);
  if (!mayShow) triangles_ = {};
}

void LocalLight::fillUnder(const View& view, const Shown& shown, const ShadingSources& sources) {
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
    draw(view.camera.size,
         {constants, sources.sky, nullptr, nullptr, nullptr, nullptr, sources.shadows,
          sources.shadowWidth},
         image);
  };
  triangles_.fillWindow(view.objects, view.camera, depth, levels);
  fill(unshadowed, window_);
  forgetFar(view, farthestBelow, levels);
  triangles_.fill(view.objects, view.camera, WaterSide::depths, levels);
  fill(sources.constants, depths_);
  triangles_.clear();
  const std::size_t texels = window_.texels.capacity() + depths_.texels.capacity();
  view.effects->holdMemory(Effect::underWater, texels * sizeof(glm::vec4));
}

void LocalLight::draw(glm::ivec2 picture, const ShadingSources& sources, LocalImage& image) const {
  const PixelBox box = triangles_.boxIn(picture);
  image.least = box.least;
  image.size = box.end - box.least;
  image.texels.resize(static_cast<std::size_t>(image.size.x) * image.size.y);
  ShadingConstants lit = sources.constants;
  lit.airExtinction = 0.0f;
  lit.cameraIsUnderWater = lit.waterlineIsOn = false;
  const ShadingSources light{lit,     sources.sky, nullptr,         nullptr,
                             nullptr, nullptr,     sources.shadows, sources.shadowWidth};
  const int pieces = (image.size.y + rowsPerPiece - 1) / rowsPerPiece;
  tbb::parallel_for(0, pieces, [&](int piece) {
    Strip strip;
    const int top = box.least.y + piece * rowsPerPiece;
    strip.clear(top, std::min(rowsPerPiece, box.end.y - top), picture.x, true);
    triangles_.raster(strip);
    PixelSpan span;
    glm::vec4 radiance[pixelsPerSpan + 16];
    for (int line = 0; line < strip.rows; ++line) {
      const std::size_t row = static_cast<std::size_t>(line) * strip.stride;
      for (int first = box.least.x; first < box.end.x; first += pixelsPerSpan) {
        span.count = std::min(pixelsPerSpan, box.end.x - first);
        std::fill_n(span.kind, pixelsPerSpan, ShadedAs::ground);
        std::fill_n(span.axial, pixelsPerSpan, 1.0f);
        const float* inverse = strip.inverse.data() + row + first;
        triangles_.fillSpan(strip.object.data() + row + first, inverse, span);
        setRays(lit, picture, {first, top + line}, span);
        if (span.hasObjects) shadeSpan(light, span, radiance);
        glm::vec4* to =
            &image.texels[static_cast<std::size_t>(top + line - box.least.y) * image.size.x +
                          (first - box.least.x)];
        for (int i = 0; i < span.count; ++i) {
          to[i] =
              inverse[i] > 0.0f ? glm::vec4(glm::vec3(radiance[i]), inverse[i]) : glm::vec4(0.0f);
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
  constants.mirrorNearest = 0.99f * nearest_;
  constants.mirrorFarthest = 1.01f * farthest_;
}

}  // namespace seaway::render
