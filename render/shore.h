#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/pixel_box.h"
#include "render/render_technique.h"
#include "render/shading/pixel_shader.h"
#include "surface/outline/water_outline.h"

/// Land around a water with an outline: flat ground at still-water level. Techniques flatten the
/// sea outside the outline and leave out those patches of a grid that lie wholly outside; then each
/// pixel is told water from ground by where in the sea plane it lies, not by the grid.
namespace seaway::render {

/// Linear reflectance of the ground.
inline constexpr glm::vec3 groundReflectance{0.21f, 0.18f, 0.13f};

/// Decides on the `outline` effect with the view's ledger: the outline where ground is drawn, else
/// null. `waterIsShown`: ground can be seen only where still-water level can.
const WaterOutline* decideOutline(const View& view, bool waterIsShown);

/// Pixels that water of an outline may cover, waves up to ±`heightBound` m; all of the picture
/// where the outline's box reaches behind the camera.
PixelBox pixelsOf(const WaterOutline& outline, const Camera& camera, double heightBound);

/// Tells water from ground, pixel by pixel. shaders/ground.frag is its twin.
class Shore {
 public:
  Shore(const WaterOutline& outline, const Camera& camera);

  /// Makes pixels of a span ground: sea outside the outline, and all that lies behind the ground.
  /// Objects must be in the span already.
  void fillSpan(PixelSpan& span) const;

 private:
  void makeGround(PixelSpan& span, int i, float axial) const;

  const WaterOutline& outline_;
  glm::dvec2 foot_;
  double eyeHeight_, nearest_;
};

}  // namespace seaway::render
