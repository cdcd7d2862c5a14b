#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "render/camera.h"
#include "render/visible_shadow.h"

namespace seaway::render {

/// Where the ends of a grid's rows lie.
enum class RowEnds {
  visible,   ///< at the sides of what the camera sees there: row_fit.h
  rectangle  ///< on the thesis' rectangle in projector space, around all that it sees
};

struct ProjectorOptions {
  /// Least height of the projector above the highest wave, m, > 0.
  double elevation = 1.0;
  /// Share of the rows that are spread evenly in the logarithm of distance, [0, 1]; the others are
  /// even in projector space as in the thesis. Even rows alone spend nearly all on the first
  /// metres when the camera is among high waves, and leave none for waves that rise in front of
  /// the horizon.
  double logarithmicRows = 0.5;
  RowEnds rowEnds = RowEnds::visible;
};

/// Places a grid on the sea plane so that it covers what a camera sees of the sea.
///
/// Johanson 2004, "The proposed algorithm": a projector of its own, kept above all waves, mirrored
/// above when the camera is below, aimed at the plane so that it never backfires, with its range
/// fitted to the visible volume. Pure mathematics, no GL. Points are m in the sea plane's axes
/// relative to the camera's foot point, so that they keep their precision far from the anchor.
///
/// The projector's roll is level. All points of a grid row then have the same homogeneous
/// coordinate, the horizon is a line of constant v, and there is no direction of view without an
/// up vector. Rows are straight and evenly divided, so that each can end where the picture does:
/// over the thesis' kind of views this lifts the median vertex efficiency from 0.7 to 0.9
/// (tests/bench/efficiency_bench.cpp). `tests/render/projector_test.cpp` shows the coverage.
class Projector {
 public:
  /// `heightBound` m ≥ 0. Empty where no water can be in the picture. Camera and options must be
  /// in their ranges (`validate` in camera.h).
  static std::optional<Projector> aimedAt(const Camera& camera, double heightBound,
                                          const ProjectorOptions& options = {});

  /// From here on gives points relative to a place that lies `offset` m from the camera's foot.
  void measureFrom(glm::dvec2 offset) { origin_ = offset; }

  /// Point of the still-water plane at (u, v) ∈ [0, 1]² of the range: the four homogeneous corners
  /// interpolated bilinearly, divided last. v grows with distance.
  glm::dvec2 basePoint(double u, double v) const;

  /// v of `count` ≥ 2 rows from 0 to 1, growing.
  std::vector<double> rows(int count) const;

  /// A row of the grid from its left end to its right one, as seen along the axis.
  struct Line {
    glm::dvec2 left{0.0}, right{0.0};
  };
  /// The rows of a grid, `count` ≥ 2, from the nearest: what lies between neighbours covers all
  /// that the camera may see of the sea.
  std::vector<Line> lines(int count) const;

  /// Which row a place of the sea plane lies on, as constants for a kernel: with
  /// offset = place − foot, along = offset·azimuth, axial = along·cosine + heightSine:
  ///   v = ((along·sine − heightCosine)/axial − leastY)·perY,
  ///   log = (asinh((along − back)/scale) − first)·perLog,
  ///   row/(rows − 1) = v·(1 − logarithmic) + log·logarithmic.
  /// It inverts `rows`. Columns follow from the row's line: across = offset·(azimuth.y,
  /// −azimuth.x).
  struct GridFromPlane {
    glm::dvec2 foot{0.0}, azimuth{1.0, 0.0};
    double cosine = 1.0, sine = 0.0, heightSine = 0.0, heightCosine = 0.0;
    double leastY = 0.0, perY = 1.0;
    double back = 0.0, perScale = 1.0, first = 0.0, perLog = 1.0, logarithmic = 0.0;
  };
  GridFromPlane gridFromPlane() const;

  /// Projector position relative to the camera's foot point; z above still water, m.
  glm::dvec3 position() const { return position_; }
  /// Angle of its axis below the horizontal, rad, (0, π/2].
  double depression() const { return depression_; }
  /// Horizontal distance from the foot point to which the sea is drawn, m: from above none farther
  /// shows; the underside, which has no horizon, ends there too.
  double reach() const { return reach_; }

 private:
  struct Range {
    glm::dvec2 least{0.0}, most{0.0};
  };
  /// Position in projector space of a point of the base plane.
  glm::dvec2 projectorFromBase(glm::dvec2 point) const;
  glm::dvec3 rayThrough(glm::dvec2 projectorPoint) const;
  /// Distance along the azimuth from the projector's foot, the same all along a row.
  double along(double v) const;
  /// Logarithm of distance in which rows are partly even.
  double logarithm(double v) const;
  glm::dvec2 withinReach(glm::dvec2 point) const;
  void standBack(const std::vector<glm::dvec2>& basePoints);
  void fitRange(const std::vector<glm::dvec2>& basePoints);

  glm::dvec2 origin_{0.0};  // of the points given, from the camera's foot
  glm::dvec3 position_{0.0};
  glm::dvec2 azimuth_{1.0, 0.0};  // horizontal direction of the axis, unit
  double depression_ = 0.0;
  double reach_ = 0.0;
  double logarithmicRows_ = 0.0;
  RowEnds rowEnds_ = RowEnds::visible;
  VisibleShadow shadow_;
  double rowScale_ = 1.0;  // m: rows are even nearer than this, logarithmic beyond
  Range range_;
  std::array<glm::dvec3, 4> corners_{};  // homogeneous (x, y, w) at uv = 00, 10, 01, 11
};

}  // namespace seaway::render
