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

}  // namespace

void LocalLight::fill(const View& view, const Shown& shown, const ShadingConstants& constants,
                      const std::uint32_t* skyTexels) {
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
                                                : "no vessel is near enough to show";
    if (!view.effects->decide(effect, called, called ? yes : no) || !called) {
      image = {};
      return;
    }
    draw(triangles_, view.camera.size, constants, skyTexels, image);
    if (side == WaterSide::mirrored) std::tie(nearest_, farthest_) = triangles_.axialRange();
    hold(view, effect, image);
  };
  decide(Effect::reflection, WaterSide::mirrored, "water mirrors a vessel", mirrored_);
  if (mayShow) forgetFar(view, farthestBelow, levels);
  decide(Effect::refraction, WaterSide::below, "a vessel's wet part is in view", below_);
  if (!mayShow) triangles_ = {};
}

void LocalLight::draw(const ObjectTriangles& triangles, glm::ivec2 picture,
                      const ShadingConstants& constants, const std::uint32_t* skyTexels,
                      LocalImage& image) const {
  const PixelBox box = triangles.boxIn(picture);
  image.least = box.least;
  image.size = box.end - box.least;
  image.texels.resize(static_cast<std::size_t>(image.size.x) * image.size.y);
  ShadingConstants lit = constants;
  lit.hazeIsOn = false;
  lit.lampCount = 0;  // places are not known here
  const int pieces = (image.size.y + rowsPerPiece - 1) / rowsPerPiece;
  tbb::parallel_for(0, pieces, [&](int piece) {
    Strip strip;
    const int top = box.least.y + piece * rowsPerPiece;
    strip.clear(top, std::min(rowsPerPiece, box.end.y - top), picture.x, true);
    triangles.raster(strip);
    PixelSpan span;
    glm::vec4 radiance[pixelsPerSpan + 16];
    for (int line = 0; line < strip.rows; ++line) {
      const std::size_t row = static_cast<std::size_t>(line) * strip.stride;
      for (int first = box.least.x; first < box.end.x; first += pixelsPerSpan) {
        span.count = std::min(pixelsPerSpan, box.end.x - first);
        std::fill_n(span.kind, pixelsPerSpan, ShadedAs::ground);
        std::fill_n(span.axial, pixelsPerSpan, 1.0f);
        const float* inverse = strip.inverse.data() + row + first;
        triangles.fillSpan(strip.object.data() + row + first, inverse, span);
        span.firstRay = lit.forward;
        span.rayStep = glm::vec3(0.0f);
        if (span.hasObjects) shadeSpan(ShadingSources{lit, skyTexels}, span, radiance);
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
  constants.mirrorLeast = glm::vec2(mirrored_.least);
  constants.mirrorSize = glm::vec2(mirrored_.size);
  constants.belowLeast = glm::vec2(below_.least);
  constants.belowSize = glm::vec2(below_.size);
  // Between steps a ray passes a twentieth of its way over the picture at most, on slopes of 0.15.
  const float part = farthest_ > 0.0f ? 1.0f - nearest_ / farthest_ : 0.0f;
  constants.mirrorSteps = std::clamp(static_cast<int>(std::ceil(10.0f * part)), 2, 6);
  constants.mirrorNearest = 0.99f * nearest_;
  constants.mirrorFarthest = 1.01f * farthest_;
}

}  // namespace seaway::render
