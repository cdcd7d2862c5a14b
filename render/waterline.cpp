#include "render/waterline.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "render/grid_placement.h"

namespace seaway::render {
namespace {

/// Heights of the near plane above the water, m; ashore it is above.
std::vector<float> heightsOf(const View& view) {
  const Camera& camera = view.camera;
  constexpr int side = Waterline::cells + 1;
  const glm::dvec3 right = camera.rightHalf() * camera.nearDistance;
  const glm::dvec3 up = camera.upperHalf() * camera.nearDistance;
  const glm::dvec3 middle = camera.position + camera.middleRay() * camera.nearDistance;
  std::vector<glm::dvec2> points;
  std::vector<double> levels;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const glm::dvec3 p = middle + right * (2.0 * column / Waterline::cells - 1.0) +
                           up * (1.0 - 2.0 * row / Waterline::cells);
      points.emplace_back(p);
      levels.push_back(p.z);
    }
  }
  std::vector<SurfaceSample> samples(points.size());
  view.water->sample(points, view.time, samples, {.derivatives = false});
  std::vector<float> heights;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double above = levels[i] - samples[i].height;
    heights.push_back(std::isfinite(above) ? static_cast<float>(above) : 1.0f);
  }
  return heights;
}

/// Whether the surface may pass within `reach` m of the eye: it is nowhere steeper than 3.
bool isNear(const View& view, double reach) {
  const glm::dvec3 eye = view.camera.position;
  const double height = view.water->sample(glm::dvec2(eye), view.time).height;
  return !std::isfinite(height) || std::abs(eye.z - height) <= 4.0 * reach;
}

}  // namespace

void Waterline::fill(const View& view, bool waterIsShown) {
  allUnder_ = false;
  heights_ = {};
  const auto tell = [&](const char* reason) {
    return view.effects->decide(Effect::underWater, anyUnder(), reason);
  };
  if (!waterIsShown || !view.water) {
    tell("no water in the picture");
    return;
  }
  const Camera& camera = view.camera;
  // No point of the near plane is farther from the eye.
  const glm::dvec2 farthest = camera.halfPicture() + glm::abs(camera.pictureMiddle());
  const double reach = camera.nearDistance * std::hypot(1.0, farthest.x, farthest.y);
  const double bound = view.water->heightBound(view.time) + reach;
  if (view.effects->isOff(Effect::underWater)) {
    allUnder_ = cameraIsUnderWater(view);
    return;
  }
  if (camera.position.z > bound) {
    tell("the camera is above all waves");
    return;
  }
  if (camera.position.z < -bound) {
    allUnder_ = true;
  } else if (!isNear(view, reach)) {
    allUnder_ = cameraIsUnderWater(view);
  } else {
    heights_ = heightsOf(view);
    const auto [least, most] = std::minmax_element(heights_.begin(), heights_.end());
    allUnder_ = *most < 0.0f;
    if (*least >= 0.0f || allUnder_) heights_ = {};
  }
  perPixel_ = static_cast<float>(cells) / glm::vec2(camera.size);
  tell(allUnder_   ? "the camera is under water"
       : isSplit() ? "the surface cuts the view"
                   : "the camera is above the water");
  if (!anyUnder()) return;
  view.effects->chargeInside(Effect::underWater, Effect::water);
  view.effects->holdMemory(Effect::underWater, heights_.capacity() * sizeof(float));
}

bool Waterline::isUnder(glm::vec2 pixel) const {
  if (!isSplit()) return allUnder_;
  const glm::vec2 at = glm::clamp((pixel + 0.5f) * perPixel_, 0.0f, static_cast<float>(cells));
  const glm::ivec2 low = glm::min(glm::ivec2(at), cells - 1);
  const glm::vec2 part = at - glm::vec2(low);
  const float* here = &heights_[static_cast<std::size_t>(low.y) * (cells + 1) + low.x];
  return glm::mix(glm::mix(here[0], here[1], part.x),
                  glm::mix(here[cells + 1], here[cells + 2], part.x), part.y) < 0.0f;
}

void Waterline::fillSpan(int row, int first, PixelSpan& span) const {
  if (!isSplit()) return;
  for (int i = 0; i < span.count; ++i) {
    if (span.kind[i] != ShadedAs::water && span.kind[i] != ShadedAs::underside) continue;
    span.kind[i] = isUnder(glm::vec2(first + i, row)) ? ShadedAs::underside : ShadedAs::water;
  }
}

void Waterline::setConstants(ShadingConstants& c) const {
  c.cameraIsUnderWater = allUnder_;
  c.waterlineIsOn = isSplit();
  c.waterlinePerPixel = perPixel_;
}

}  // namespace seaway::render
