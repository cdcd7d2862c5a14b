#include <tbb/parallel_for.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <vector>

#include "render/grid_cover.h"
#include "render/grid_placement.h"
#include "render/reference/band_limited_sea.h"
#include "render/software/strip_technique.h"
#include "render/surf.h"
#include "surface/curvature.h"

namespace seaway::render {
namespace {

/// One ray a pixel against the same sea, shaded like all others.
class ReferenceTechnique final : public StripTechnique {
 public:
  explicit ReferenceTechnique(const ProjectedGridOptions& options) : options_(options) {
    validate(options_);
  }
  std::string name() const override { return "reference"; }

 private:
  bool placeSea(const View& view, FrameStats& stats) override;
  void rasterSea(const View& view, Strip& strip) override;
  void fillSeaSpan(const View& view, const float* inverse, int row, int first, bool underWater,
                   PixelSpan& span) const override;
  std::size_t seaMemoryBytes() const override {
    return points_.capacity() * sizeof(BandLimitedSea::Point) +
           cover_.capacity() * sizeof(glm::vec3);
  }
  BandLimitedSea sea(const View& view) const {
    return {*water_, wakes_, layout_, glm::dvec2(view.camera.position)};
  }

  const Surf* surf() const { return surf_ ? &*surf_ : nullptr; }

  ProjectedGridOptions options_;
  std::optional<SurfaceAtTime> water_;
  std::optional<Surf> surf_;
  WakesInView wakes_;
  GridLayout layout_;
  double reach_ = 0.0;
  std::vector<BandLimitedSea::Point> points_;  // one a pixel
  std::vector<glm::vec3> cover_;               // the same; empty: nothing lies on the water
};

bool ReferenceTechnique::placeSea(const View& view, FrameStats& stats) {
  const auto place = [&](const Projector& projector) {
    layout_ = projectedLayout(projector, view.water->waves(), options_.grid);
    reach_ = projector.reach();
    return SeaPlacement{0.0, 1, 0};
  };
  const bool placed = render::placeSea(view, options_.projectorElevation, place, stats).has_value();
  stats.vertices = 0;
  stats.vertexEfficiency = 0.0;
  if (!placed) return false;
  water_.emplace(view.water->at(view.time));
  wakes_.fill(water_->disturbances(), view.time, glm::dvec2(view.camera.position), layout_);
  points_.resize(static_cast<std::size_t>(view.camera.size.x) * view.camera.size.y);
  surf_ = surfOf(view);
  cover_.resize(mayHaveCover(water_->extras(), surf()) ? points_.size() : 0);
  return true;
}

void ReferenceTechnique::rasterSea(const View& view, Strip& strip) {
  const BandLimitedSea surface = sea(view);
  const Camera& camera = view.camera;
  tbb::parallel_for(0, strip.rows, [&](int line) {
    const int row = strip.top + line;
    for (int column = 0; column < strip.width; ++column) {
      const glm::dvec3 ray = camera.rayThrough({column, row});
      const double cosine = glm::dot(ray, camera.forward());
      const double level = std::max(glm::length(glm::dvec2(ray)), 1e-9);
      // As far as the sea may be seen, or through all its depth of waves.
      const double farthest =
          std::min(reach_ / level, 2.0 * reach_ + 4.0 * std::abs(camera.position.z));
      const auto distance =
          surface.distance(camera.position.z, ray, camera.nearDistance / cosine, farthest);
      if (!distance) continue;
      strip.inverse[static_cast<std::size_t>(line) * strip.stride + column] =
          static_cast<float>(1.0 / (*distance * cosine));
      const std::size_t pixel = static_cast<std::size_t>(row) * strip.width + column;
      const glm::dvec2 place = glm::dvec2(ray) * *distance;
      points_[pixel] = surface.at(place);
      if (cover_.empty()) continue;
      cover_[pixel] = coverAt(*water_, surf(), glm::dvec2(camera.position) + place);
    }
  });
}

void ReferenceTechnique::fillSeaSpan(const View& view, const float* inverse, int row, int first,
                                     bool underWater, PixelSpan& span) const {
  span.hasCover = !cover_.empty();
  for (int i = 0; i < span.count; ++i) {
    span.kind[i] = ShadedAs::sky;
    span.axial[i] = 1.0f;
    if (inverse[i] == 0.0f) continue;
    const std::size_t pixel = static_cast<std::size_t>(row) * view.camera.size.x + first + i;
    for (int c = 0; span.hasCover && c < 3; ++c) span.cover[c][i] = cover_[pixel][c];
    const BandLimitedSea::Point& point = points_[pixel];
    const glm::vec2 slope(point.slope);
    span.kind[i] = underWater ? ShadedAs::underside : ShadedAs::water;
    span.axial[i] = 1.0f / inverse[i];
    span.slopeX[i] = slope.x;
    span.slopeY[i] = slope.y;
    span.missingSlope[i] = static_cast<float>(point.missingSlope);
    span.height[i] = static_cast<float>(point.height);
  }
}

}  // namespace

std::unique_ptr<RenderTechnique> makeReference(const ProjectedGridOptions& options) {
  return std::make_unique<ReferenceTechnique>(options);
}

}  // namespace seaway::render
