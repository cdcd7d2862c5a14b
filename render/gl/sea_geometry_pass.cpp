#include "render/gl/sea_geometry_pass.h"

#include "render/gl/cpu_vertices_pass.h"
#include "surface/input_error.h"

namespace seaway::render {

std::unique_ptr<SeaGeometryPass> makeSeaGeometryPass(GridVariant variant) {
  switch (variant) {
    case GridVariant::cpuVertices:
      return std::make_unique<CpuVerticesPass>();
    case GridVariant::software:
      break;
  }
  throw InputError("projected grid: variant '" + std::string(gridVariantName(variant)) +
                   "' does not draw through OpenGL");
}

}  // namespace seaway::render
