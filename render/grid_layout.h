#pragma once

#include <algorithm>
#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "render/band_limit.h"
#include "render/projector.h"

namespace seaway::render {

/// Radii of a grid of rings: 0, then innermost + growth·i⁴ for i = 0, 1, … (Kryachko 2005, GPU Gems
/// 2, chapter 18, whose rings leave the centre open).
struct RingLaw {
  double innermost = 0.1;  ///< m
  double growth = 1e-5;    ///< m

  double radius(int ring) const;
};

/// Where the vertices of a grid on the sea plane lie, and which waves each row carries.
///
/// A row carries what its spacing allows (BandLimit), between rows heights are interpolated: by
/// this the grid, and the reference that it is compared with, draw the same band-limited sea.
struct GridLayout {
  struct Row {
    glm::dvec2 start{0.0}, step{0.0};  ///< m, relative to the camera's foot point
    BandLimit::Plan plan;
  };
  glm::ivec2 size{0};
  std::vector<Row> rows;
  Projector::GridFromPlane fromPlane;
  /// Where there is one, rows are rings about `fromPlane.foot` and have no start and step; columns
  /// lie along `spokes`, unit vectors of which the last is the first again.
  std::optional<RingLaw> rings;
  std::vector<glm::dvec2> spokes;
  /// Height, m (1 σ), that the displacement of vertices may leave out: the smaller octaves'. Slopes
  /// are those of all. Of rings at the camera's foot, see displacementToleranceAt.
  double displacementTolerance = 0.0;
  /// What of it a row may leave out: nothing within a metre, where the eye may be in the surface,
  /// and beyond at most a fiftieth of the way from there.
  double displacementToleranceAt(int row) const {
    if (!rings) return displacementTolerance;
    return std::clamp(0.02 * (rings->radius(row) - 1.0), 0.0, displacementTolerance);
  }

  /// Of a vertex, relative to the camera's foot point, m.
  glm::dvec2 place(int row, int column) const {
    if (rings) return fromPlane.foot + rings->radius(row) * spokes[column];
    return rows[row].start + rows[row].step * static_cast<double>(column);
  }

  /// Row coordinate of a place relative to the foot point, [0, size.y − 1]; not of rings.
  double rowAt(glm::dvec2 place) const;
};

/// The projected grid.
GridLayout projectedLayout(const Projector& projector, const WaveField& waves, glm::ivec2 size);

/// A plain grid of the sea plane, `side` m wide, around the camera's foot point: what projecting
/// the grid is better than.
GridLayout naiveLayout(const WaveField& waves, double side, glm::ivec2 size);

/// How a grid of rings lies.
struct RingOptions {
  glm::ivec2 size{257, 256};  ///< spokes and one more, rings with the centre; ≥ 4 and ≥ 3
  double innermost = 0.1;     ///< radius of the first ring, m, > 0
  double displacement = 1.0;  ///< share of the waves' variance that displaces vertices, (0, 1]
};

/// Rings out to `reach` m about `centre` (m from the camera's foot point).
GridLayout radialLayout(const WaveField& waves, glm::dvec2 centre, double reach,
                        const RingOptions& options);

}  // namespace seaway::render
