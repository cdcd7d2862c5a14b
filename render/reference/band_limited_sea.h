#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "render/grid_layout.h"
#include "render/wakes_in_view.h"
#include "surface/water_surface.h"

namespace seaway::render {

/// The sea that a grid of finite rows but endlessly many columns would draw, without its chords:
/// at each place the waves that the rows before and behind carry, interpolated between them.
///
/// A grid and a ray-cast are compared on this surface, so that what differs is the drawing, not the
/// band limit. Refers to surface, wakes and layout, which must outlive it. Thread-safe.
class BandLimitedSea {
 public:
  /// `wakes` are those of `water` that `layout` meets.
  BandLimitedSea(const SurfaceAtTime& water, const WakesInView& wakes, const GridLayout& layout,
                 glm::dvec2 foot);

  struct Point {
    double height = 0.0;  ///< m above still water
    glm::dvec2 slope{0.0};
    double missingSlope = 0.0;  ///< mean square
  };
  /// At a place relative to the camera's foot point, m.
  Point at(glm::dvec2 place) const;

  /// Distance in m along a ray from the camera, `height` m above still water at the foot point, to
  /// the curved sea, from above or below: the first hit; empty where there is none before
  /// `farthest`. `direction` is a unit vector.
  ///
  /// Steps follow the height above water over six standard deviations of the slope that is carried
  /// there, never less than 5e-4 of the distance: a crest thinner than that may be missed. A
  /// crossing is bisected to 1e-7 of its distance or 1e-6 m.
  std::optional<double> distance(double height, glm::dvec3 direction, double nearest,
                                 double farthest) const;

 private:
  Point row(int index, glm::dvec2 point) const;
  void addExtras(glm::dvec2 point, double keptWavelength, Point& carried) const;
  double carriedSlope(glm::dvec2 place) const;

  const SurfaceAtTime& water_;
  const WakesInView& wakes_;
  const GridLayout& layout_;
  glm::dvec2 foot_;
  double totalSlope_;  // mean square
  double steepestWake_;
  double bound_;  // m
};

}  // namespace seaway::render
