#include "render/shore.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "surface/constants.h"
#include "surface/curvature.h"

namespace seaway::render {
namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();

/// Axial distance at which a ray first meets the curved plane of still water: the least root above
/// `nearest` of height + t·sink + t²·bend = 0.
double stillWaterAlong(double height, double sink, double bend, double nearest) {
  const double under = sink * sink - 4.0 * bend * height;
  if (under < 0.0) return nowhere;
  const double q = -0.5 * (sink + std::copysign(std::sqrt(under), sink));  // without cancellation
  double first = nowhere;
  for (const double root : {q / bend, height / q}) {
    if (root > nearest && root < first) first = root;
  }
  return first;
}

}  // namespace

const WaterOutline* decideOutline(const View& view, bool waterIsShown) {
  const WaterOutline* outline = view.water ? view.water->outline() : nullptr;
  const bool called = outline && waterIsShown;
  const char* reason = !outline       ? "the sea has no outline"
                       : waterIsShown ? "the sea has an outline"
                                      : "neither water nor ground in the camera's view";
  return view.effects->decide(Effect::outline, called, reason) && called ? outline : nullptr;
}

PixelBox pixelsOf(const WaterOutline& outline, const Camera& camera, double heightBound) {
  const glm::dvec2 least = outline.origin() - glm::dvec2(camera.position);
  const glm::dvec2 extent = outline.cellSize() * glm::dvec2(outline.cellCount());
  // Between corners the curved sea stands higher than they do.
  const double bulge = seaDrop(0.5 * glm::length(extent));
  const glm::dvec2 half = camera.halfPicture(), middle = camera.pictureMiddle();
  glm::dvec2 low(nowhere), high(-nowhere);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec2 place = least + extent * glm::dvec2(corner & 1, corner >> 1 & 1);
    const double up = corner & 4 ? heightBound + bulge : -heightBound;
    const glm::dvec3 p(place, up - seaDrop(glm::length(place)) - camera.position.z);
    const double axial = glm::dot(p, camera.forward());
    if (axial <= camera.nearDistance) return {{0, 0}, camera.size};
    const glm::dvec2 onScreen((-glm::dot(p, camera.left()) / axial - middle.x) / half.x,
                              (-glm::dot(p, camera.up()) / axial + middle.y) / half.y);
    low = glm::min(low, onScreen);
    high = glm::max(high, onScreen);
  }
  const glm::dvec2 size(camera.size);
  const auto pixels = [&](glm::dvec2 part) {
    return glm::clamp(0.5 * (part + 1.0), 0.0, 1.0) * size;
  };
  return {glm::ivec2(glm::floor(pixels(low))), glm::ivec2(glm::ceil(pixels(high)))};
}

Shore::Shore(const WaterOutline& outline, const Camera& camera)
    : outline_(outline),
      foot_(camera.position),
      eyeHeight_(camera.position.z),
      nearest_(camera.nearDistance) {}

void Shore::makeGround(PixelSpan& span, int i, float axial) const {
  span.hasObjects = true;
  span.kind[i] = ShadedAs::ground;
  span.axial[i] = axial;
  for (int c = 0; c < 3; ++c) {
    span.normal[c][i] = c == 2 ? 1.0f : 0.0f;
    span.reflectance[c][i] = groundReflectance[c];
  }
}

void Shore::fillSpan(PixelSpan& span) const {
  for (int i = 0; i < span.count; ++i) {
    const glm::dvec3 ray(span.firstRay + static_cast<float>(i) * span.rayStep);
    const glm::dvec2 level(ray);
    const bool sea = span.kind[i] == ShadedAs::water || span.kind[i] == ShadedAs::underside;
    const bool dry = sea && !outline_.contains(foot_ + level * static_cast<double>(span.axial[i]));
    const double still = stillWaterAlong(
        eyeHeight_, ray.z, glm::dot(level, level) * (0.5 / earthMeanRadius), nearest_);
    const double shown = span.kind[i] == ShadedAs::sky || dry ? nowhere : span.axial[i];
    if (still < shown && !outline_.contains(foot_ + level * still)) {
      makeGround(span, i, static_cast<float>(still));
    } else if (dry) {
      makeGround(span, i, span.axial[i]);
    }
  }
}

}  // namespace seaway::render
