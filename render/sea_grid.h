#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "render/band_limit.h"
#include "render/camera.h"
#include "render/projector.h"
#include "surface/water_surface.h"

namespace seaway::render {

/// Largest distance in m between neighbours at a row of a grid of `columns` over a projector's range:
/// along it, and to the next row (or the one before the last). `rows` as Projector::rows gives them.
double gridSpacing(const Projector& projector, const std::vector<double>& rows, int row,
                   int columns);

/// A vertex of the drawn sea, as it goes into the vertex buffer.
struct SeaVertex {
  glm::vec3 position;         ///< relative to the camera, sea-plane axes, curved sea, m
  glm::vec2 slope;            ///< of the waves the grid carries
  float height = 0.0f;        ///< of the waves above still water, m
  float missingSlope = 0.0f;  ///< mean-square slope that the grid does not carry
};

/// The projected grid's vertices and the triangles that can be in the picture.
class SeaGrid {
 public:
  /// Fills the grid from `water` at `time`; memory is reused between calls.
  void fill(const WaterSurface& water, double time, const Camera& camera,
            const Projector& projector, glm::ivec2 size);

  const std::vector<SeaVertex>& vertices() const { return vertices_; }
  const std::vector<std::uint32_t>& indices() const { return indices_; }

  /// Largest |height| of all vertices, m.
  double largestHeight() const { return largestHeight_; }
  /// Vertices inside the camera's frustum.
  std::size_t verticesInFrustum() const { return verticesInFrustum_; }

  std::size_t memoryBytes() const;

 private:
  void fillRow(const WaterSurface& water, double time, const Camera& camera,
               const BandLimit::Plan& plan, int row);
  void markOutside(const Camera& camera);
  void connectVisible();

  glm::ivec2 size_{0};
  std::vector<SeaVertex> vertices_;
  std::vector<std::uint32_t> indices_;
  std::vector<std::uint8_t> outside_;      // bits: behind the near plane, left, right, below, above
  std::vector<glm::dvec2> base_, points_;  // of a row: relative to the foot point, in the plane
  std::vector<SurfaceSample> full_, partial_;  // of a row
  double largestHeight_ = 0.0;
  std::size_t verticesInFrustum_ = 0;
};

}  // namespace seaway::render
