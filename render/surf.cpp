#include "render/surf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

#include "render/grid_cover.h"
#include "render/render_technique.h"
#include "render/terrain/terrain_in_view.h"

namespace seaway::render {
namespace {

constexpr double breakerIndex = 0.42;
constexpr double leastHeight = 0.02;  // m, H_m0: ripples leave no foam

}  // namespace

Surf::Surf(std::shared_ptr<const TerrainMap> terrain, const WaveField& waves)
    : terrain_(std::move(terrain)),
      allBreak_(waves.significantWaveHeight() / (std::sqrt(2.0) * breakerIndex)),
      deepest_(allBreak_ * std::pow(255.0, 0.25)),
      perHeight_(static_cast<float>(0.25 / waves.standardDeviation())) {}

double Surf::breaking(double depth) const {
  if (depth <= allBreak_) return 1.0;
  const double part = allBreak_ / depth;
  return part * part * part * part;
}

bool Surf::addTo(const SurfaceAtTime& water, std::span<const double> x, std::span<const double> y,
                 double keptWavelength, std::span<float> foam) const {
  std::array<float, gridChunk> part;
  bool any = false;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double depth = -terrain_->heightAt({x[i], y[i]});
    part[i] = depth < deepest_ ? static_cast<float>(breaking(depth)) : 0.0f;
    any = any || part[i] > 0.0f;
  }
  if (!any) return false;
  std::array<float, gridChunk> height;
  water.waves().sample(
      x, y, {.height = std::span(height).first(x.size()), .slopeX = {}, .slopeY = {}, .rate = {}},
      {.shortestWavelength = keptWavelength, .derivatives = false});
  for (std::size_t i = 0; i < x.size(); ++i) {
    const float white = part[i] * std::clamp(0.5f + height[i] * perHeight_, 0.0f, 1.0f);
    foam[i] += (1.0f - foam[i]) * white;
  }
  return true;
}

std::optional<Surf> surfOf(const View& view) {
  const TerrainMap* terrain = view.water ? view.water->terrain() : nullptr;
  if (!terrain || view.water->waves().significantWaveHeight() < leastHeight ||
      view.effects->isOff(Effect::foam) || view.effects->isOff(Effect::terrain) ||
      !mapMayShow(*terrain, view.camera)) {
    return std::nullopt;
  }
  return Surf(view.water->sharedTerrain(), view.water->waves());
}

}  // namespace seaway::render
