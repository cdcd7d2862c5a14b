#include <algorithm>

#include "render/grid_placement.h"
#include "render/sea_grid.h"
#include "render/software/sea_spans.h"
#include "render/software/strip_technique.h"
#include "render/surf.h"
#include "surface/input_error.h"

namespace seaway::render {
namespace {

/// A grid of vertices rastered on the processor; how the grid lies on the sea is left open.
class SoftwareGridTechnique : public StripTechnique {
 protected:
  void placeGrid(const View& view, const GridLayout& layout, double bound = 0.0) {
    const std::optional<Surf> surf = surfOf(view);
    grid_.fill(view.water->at(view.time), view.camera, layout, bound, surf ? &*surf : nullptr);
  }
  SeaPlacement placement(const Camera& camera) const {
    return {grid_.largestHeight(), grid_.vertexCount(), grid_.verticesInFrustum(camera)};
  }
  void project(const View& view, const GridLayout& layout) {
    screen_.fill(grid_, view.camera);
    slopes_.fill(grid_, layout);
  }
  void rasterSea(const View&, Strip& strip) override { render::rasterSea(screen_, strip); }
  void fillSeaSpan(const View& view, const float* inverse, int, int, bool underWater,
                   PixelSpan& span) const override {
    slopes_.fillSpan(inverse, view.camera, underWater, span);
  }
  std::size_t seaMemoryBytes() const override {
    return grid_.memoryBytes() + screen_.memoryBytes() + slopes_.memoryBytes();
  }

 private:
  SeaGrid grid_;
  ScreenGrid screen_;
  SeaSlopes slopes_;
};

class SoftwareProjectedGrid final : public SoftwareGridTechnique {
 public:
  explicit SoftwareProjectedGrid(const ProjectedGridOptions& options) : options_(options) {
    validate(options_);
  }
  std::string name() const override { return "projected_grid"; }

 private:
  bool placeSea(const View& view, FrameStats& stats) override {
    stats.variant = gridVariantName(GridVariant::software);
    GridLayout layout;
    const auto place = [&](const Projector& projector) {
      layout = projectedLayout(projector, view.water->waves(), options_.grid);
      placeGrid(view, layout);
      return placement(view.camera);
    };
    if (!render::placeSea(view, options_.projectorElevation, place, stats)) return false;
    project(view, layout);
    return true;
  }
  ProjectedGridOptions options_;
};

class NaiveGrid final : public SoftwareGridTechnique {
 public:
  explicit NaiveGrid(const NaiveGridOptions& options) : options_(options) {
    validate(ProjectedGridOptions{.grid = options.grid});
  }
  std::string name() const override { return "naive_grid"; }

 private:
  bool placeSea(const View& view, FrameStats& stats) override {
    const bool called = view.water != nullptr;
    if (!view.effects->decide(Effect::water, called, "a grid lies around the camera") || !called) {
      return false;
    }
    const GridLayout layout = naiveLayout(view.water->waves(), options_.side, options_.grid);
    placeGrid(view, layout);
    const SeaPlacement placed = placement(view.camera);
    stats.vertices = placed.vertices;
    stats.vertexEfficiency =
        static_cast<double>(placed.verticesInFrustum) / static_cast<double>(placed.vertices);
    project(view, layout);
    return true;
  }
  NaiveGridOptions options_;
};

class RadialGrid final : public SoftwareGridTechnique {
 public:
  explicit RadialGrid(const RadialGridOptions& options) : options_(options) {
    validateRings("radial grid", options.grid, options.innermost);
    if (!(options.displacement > 0.0 && options.displacement <= 1.0)) {
      throw InputError("radial grid: displacement must be above 0 and at most 1");
    }
  }
  std::string name() const override { return "radial_grid"; }

 private:
  bool placeSea(const View& view, FrameStats& stats) override {
    GridLayout layout;
    double bound = view.water ? view.water->heightBound(view.time) : 0.0;
    const auto place = [&](const Projector& projector) {
      const Camera& aim = view.gridCamera ? *view.gridCamera : view.camera;
      const glm::dvec2 centre(aim.position - view.camera.position);
      layout = radialLayout(view.water->waves(), centre, projector.reach(),
                            {.size = {options_.grid.x + 1, options_.grid.y},
                             .innermost = options_.innermost,
                             .displacement = options_.displacement});
      placeGrid(view, layout, bound);
      const SeaPlacement placed = placement(view.camera);
      bound = std::max(bound, 1.05 * placed.largestHeight);
      return placed;
    };
    if (!render::placeSea(view, 1.0, place, stats)) return false;
    project(view, layout);
    return true;
  }
  RadialGridOptions options_;
};

}  // namespace

std::unique_ptr<RenderTechnique> makeRadialGrid(const RadialGridOptions& options) {
  return std::make_unique<RadialGrid>(options);
}

std::unique_ptr<RenderTechnique> makeSoftwareGrid(const ProjectedGridOptions& options) {
  return std::make_unique<SoftwareProjectedGrid>(options);
}

std::unique_ptr<RenderTechnique> makeNaiveGrid(const NaiveGridOptions& options) {
  return std::make_unique<NaiveGrid>(options);
}

}  // namespace seaway::render
