#include "render/grid_placement.h"

#include <cmath>
#include <sstream>

#include "surface/input_error.h"

namespace seaway::render {

std::optional<Projector> placeSea(const View& view, double projectorElevation,
                                  const std::function<SeaPlacement(const Projector&)>& place,
                                  FrameStats& stats) {
  if (!view.water) return std::nullopt;
  const ProjectorOptions options{.elevation = projectorElevation};
  const Camera& aim = view.gridCamera ? *view.gridCamera : view.camera;
  double bound = view.water->heightBound(view.time);
  std::optional<Projector> projector;
  for (int attempt = 0; attempt < 4; ++attempt) {
    projector = Projector::aimedAt(aim, bound, options);
    if (projector) projector->measureFrom(glm::dvec2(view.camera.position - aim.position));
    const bool runs = view.effects->decide(
        Effect::water, projector.has_value(),
        projector ? "the waves' volume meets the camera's view" : "no water in the camera's view");
    if (!runs || !projector) return std::nullopt;
    const SeaPlacement placed = place(*projector);
    stats.vertices = placed.vertices;
    stats.vertexEfficiency =
        static_cast<double>(placed.verticesInFrustum) / static_cast<double>(placed.vertices);
    if (placed.largestHeight <= bound) break;
    bound = 1.05 * placed.largestHeight;
    ++stats.boundRedraws;
  }
  return projector;
}

bool cameraIsUnderWater(const View& view) {
  const glm::dvec3 eye = view.camera.position;
  return view.water && eye.z < view.water->sample(glm::dvec2(eye), view.time).height;
}

void validatePlain(const View& view) {
  validate(view.camera);
  if (view.camera.distortion && !view.camera.distortion->isNone()) {
    throw InputError("camera: this technique draws pinholes; distortion is not allowed");
  }
  if (view.samplesPerSide != 1) {
    throw InputError("camera: this technique sees each pixel once; " +
                     std::to_string(view.samplesPerSide) + " samples a side are not allowed");
  }
}

void validate(const ProjectedGridOptions& options) {
  if (options.grid.x < 2 || options.grid.y < 2) {
    std::ostringstream message;
    message << "projected grid: " << options.grid.x << " x " << options.grid.y
            << " vertices are not allowed; there must be at least 2 each way";
    throw InputError(message.str());
  }
  if (!(options.projectorElevation > 0.0 && std::isfinite(options.projectorElevation))) {
    throw InputError("projected grid: projector elevation must be above 0 m and finite");
  }
}

void validateRings(const std::string& technique, glm::ivec2 grid, double innermost) {
  if (grid.x < 3 || grid.y < 3) {
    std::ostringstream message;
    message << technique << ": " << grid.x << " spokes and " << grid.y
            << " rings are not allowed; there must be at least 3 of each";
    throw InputError(message.str());
  }
  if (!(innermost > 0.0 && std::isfinite(innermost))) {
    throw InputError(technique + ": the first ring's radius must be above 0 m and finite");
  }
}

}  // namespace seaway::render
