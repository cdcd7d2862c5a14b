#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "render/band_limit.h"
#include "render/projector.h"

namespace seaway::render {

/// Where the vertices of a grid on the sea plane lie, and which waves each row carries.
///
/// A row carries what its spacing allows (BandLimit), between rows heights are interpolated: by this
/// the grid, and the reference that it is compared with, draw the same band-limited sea.
struct GridLayout {
  struct Row {
    glm::dvec2 start{0.0}, step{0.0};  ///< m, relative to the camera's foot point
    BandLimit::Plan plan;
  };
  glm::ivec2 size{0};
  std::vector<Row> rows;
  Projector::GridFromPlane fromPlane;

  /// Row coordinate of a place relative to the foot point, [0, size.y − 1].
  double rowAt(glm::dvec2 place) const;
};

/// The projected grid.
GridLayout projectedLayout(const Projector& projector, const WaveField& waves, glm::ivec2 size);

/// A plain grid of the sea plane, `side` m wide, around the camera's foot point: what projecting
/// the grid is better than.
GridLayout naiveLayout(const WaveField& waves, double side, glm::ivec2 size);

}  // namespace seaway::render
