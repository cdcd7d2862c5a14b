#include "render/terrain/terrain_in_view.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/fresnel.h"
#include "surface/curvature.h"

namespace seaway::render {
namespace {

/// Crests that run up a beach are higher than the mean of the highest third.
constexpr double runUpPerWaveHeight = 0.6;
constexpr double leastRunUp = 0.15;  // m

/// By way of the water no grain is seen that is finer than this many pixels.
constexpr float blurByWater = 3.0f;

}  // namespace

bool mapMayShow(const TerrainMap& map, const Camera& camera) {
  const glm::dvec2 middle = 0.5 * (map.least() + map.most());
  const double radius = 0.5 * glm::length(map.most() - map.least());
  const glm::dvec2 off = middle - glm::dvec2(camera.position);
  const double away = glm::length(off), farthest = away + radius;
  // Below the camera's horizon, to the top of it.
  const double top = std::max(map.highest(), 0.0);
  if (away - radius > crestReach(std::max(camera.position.z, 0.0), top)) return false;
  const glm::dvec3 centre(off, -seaDrop(away) - camera.position.z);
  const double ball =
      std::hypot(radius, std::max(std::abs(map.lowest()), top) + seaDrop(farthest) - seaDrop(away));
  const double axial = glm::dot(centre, camera.forward());
  const glm::dvec2 half = camera.halfPicture(), shift = camera.pictureMiddle();
  const auto reaches = [&](double outwards, double tangent) {
    return outwards - axial * tangent <= ball * std::hypot(1.0, tangent);
  };
  const double right = -glm::dot(centre, camera.left()), up = glm::dot(centre, camera.up());
  return axial >= camera.nearDistance - ball && reaches(right, half.x + shift.x) &&
         reaches(-right, half.x - shift.x) && reaches(up, half.y + shift.y) &&
         reaches(-up, half.y - shift.y);
}

void TerrainInView::decide(const View& view, bool called, const char* reason) {
  if (view.effects->decide(Effect::terrain, called, reason) && called) return;
  map_ = nullptr;
  corners_ = {};
}

void TerrainInView::prepare(const View& view, const Shown& shown) {
  map_ = view.water ? view.water->terrain() : nullptr;
  if (!map_) {
    kept_.reset();
    lod_.reset();
    skin_.reset();
    return decide(view, false, "the scene has no terrain");
  }
  if (!mapMayShow(*map_, view.camera)) {
    return decide(view, false, "the terrain is out of the camera's view");
  }
  if (kept_.get() != map_) {
    kept_ = view.water->sharedTerrain();
    lod_.emplace(*map_);
    skin_.emplace(*map_);
  }
  const double waves = view.water->waves().significantWaveHeight();
  heightBound_ = view.water->heightBound(view.time);
  wetHeight_ = static_cast<float>(leastRunUp + runUpPerWaveHeight * waves);
  pixelAngle_ = static_cast<float>(view.camera.pixelAngle());
  TerrainSelection selection;
  // Water hides what lies deeper than its troughs.
  if (shown.water && !shown.cameraIsUnderWater) selection.lowest = -heightBound_ - 0.1;
  corners_.clear();
  lod_->select(*map_, view.camera, selection, corners_);
  bendToSea(view.camera, corners_);
  decide(view, true, "ground or sea bed may be in the camera's view");
}

void TerrainInView::fill(const Camera& camera, TerrainSide side, float extinction,
                         Triangles& triangles) const {
  triangles.clear();
  if (!map_) return;
  TerrainSelection selection;
  selection.side = side;
  // There and back: what comes up has gone down before.
  if (side == TerrainSide::below) {
    selection.lowest = std::log(0.01) / (2.0 * std::max(static_cast<double>(extinction), 1e-3));
    selection.highest = heightBound_ + 0.1;
  }
  std::vector<glm::vec3> corners;
  lod_->select(*map_, camera, selection, corners);
  bendToSea(camera, corners);
  triangles.fill(corners, camera);
}

void TerrainInView::Triangles::fill(std::span<const glm::vec3> corners, const Camera& camera) {
  clear();
  const ScreenProjection projection(camera);
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const glm::vec3 places[3] = {corners[i], corners[i + 1], corners[i + 2]};
    ScreenTriangle projected[2];
    const int count = projectTriangle(places, projection, projected);
    triangles_.insert(triangles_.end(), projected, projected + count);
  }
}

void TerrainInView::Triangles::raster(Strip& strip) const {
  for (const ScreenTriangle& triangle : triangles_) {
    const auto [high, low] = std::minmax({triangle.y[0], triangle.y[1], triangle.y[2]});
    if (low < strip.top - 1.0 || high > strip.top + strip.rows) continue;
    rasterTriangle(triangle, strip);
  }
}

void TerrainInView::fillSpan(const Camera& camera, const float* inverse, TerrainSide side,
                             PixelSpan& span) const {
  const glm::vec2 foot(glm::dvec2(camera.position) - map_->least());
  const auto eyeHeight = static_cast<float>(camera.position.z);
  constexpr auto deepened = static_cast<float>(seaWaterIndex);
  const bool isMoved = side != TerrainSide::direct;
  span.hasPlaces = span.hasPlaces || isMoved;
  const float footprintAngle = (side == TerrainSide::direct ? 1.0f : blurByWater) * pixelAngle_;
  for (int i = 0; i < span.count; ++i) {
    if (inverse[i] == 0.0f) continue;
    const float axial = 1.0f / inverse[i];
    if (span.kind[i] != ShadedAs::sky && span.axial[i] <= axial) continue;
    const glm::vec3 relative = (span.firstRay + static_cast<float>(i) * span.rayStep) * axial;
    const glm::vec2 level(relative);
    float height = relative.z + eyeHeight + static_cast<float>(seaDrop(glm::length(level)));
    if (side == TerrainSide::mirrored) height = -height;
    const GroundPixel ground = groundPixel(
        *skin_, foot + level, footprintAngle * glm::length(relative), height, wetHeight_);
    if (isMoved) {
      span.placeLevel[i] = -eyeHeight - static_cast<float>(seaDrop(glm::length(level)));
      span.placeScale[i] = side == TerrainSide::mirrored ? -1.0f : deepened;
    }
    span.hasObjects = true;
    span.kind[i] = ShadedAs::ground;
    span.axial[i] = axial;
    for (int c = 0; c < 3; ++c) {
      span.normal[c][i] = ground.normal[c];
      span.reflectance[c][i] = ground.reflectance[c];
    }
  }
}

std::size_t TerrainInView::memoryBytes() const {
  if (!kept_) return 0;
  return kept_->memoryBytes() + lod_->memoryBytes() + skin_->memoryBytes() +
         corners_.capacity() * sizeof(glm::vec3);
}

}  // namespace seaway::render
