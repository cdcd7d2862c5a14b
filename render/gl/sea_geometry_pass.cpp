#include "render/gl/sea_geometry_pass.h"

#include "render/gl/cpu_vertices_pass.h"
#include "render/gl/gpu_normals_pass.h"
#include "render/gl/gpu_vertices_pass.h"
#include "render/gl/marched_pass.h"
#include "surface/input_error.h"

namespace seaway::render {

void setWaterStencil(bool cameraIsUnderWater) {
  glStencilFunc(GL_ALWAYS, cameraIsUnderWater ? stencilUnderside : stencilWater, 0xFF);
}

std::unique_ptr<SeaGeometryPass> makeSeaGeometryPass(GridVariant variant) {
  switch (variant) {
    case GridVariant::cpuVertices:
      return std::make_unique<CpuVerticesPass>();
    case GridVariant::gpu:
      return std::make_unique<GpuVerticesPass>();
    case GridVariant::cpuVerticesGpuNormals:
      return std::make_unique<GpuNormalsPass>();
    case GridVariant::marched:
      return std::make_unique<MarchedPass>();
    case GridVariant::software:
      break;
  }
  throw InputError("projected grid: variant '" + std::string(gridVariantName(variant)) +
                   "' does not draw through OpenGL");
}

}  // namespace seaway::render
