#pragma once

#include <span>
#include <vector>

#include "render/render_technique.h"
#include "render/shading/pixel_shader.h"

namespace seaway::render {

/// Which pixels of a view are under water: those whose point on the camera's near plane lies below
/// the water's surface there.
///
/// Heights of the near plane over the water are taken at 65 × 65 places of it and, between them,
/// interpolated: waves of 0.5 m and steepness 0.4 bend by less than 0.02 mm between two that are
/// 3 mm apart (near plane at 0.1 m, 60°).
class Waterline {
 public:
  static constexpr int cells = ShadingConstants::waterlineCells;

  /// Decides with the view's ledger. Switched off, the eye's place counts for all pixels.
  /// `waterIsShown`: else all are above.
  void fill(const View& view, bool waterIsShown);

  bool allUnder() const { return allUnder_; }
  bool isSplit() const { return !heights_.empty(); }
  bool anyUnder() const { return allUnder_ || isSplit(); }
  /// Whether a pixel is under water, (0, 0) the centre of the top left one.
  bool isUnder(glm::vec2 pixel) const;
  /// Corrects the kind of water in pixels of row `row` from `first` on.
  void fillSpan(int row, int first, PixelSpan& span) const;

  /// Of the near plane above the water, m, row by row from the picture's top left corner to its
  /// bottom right one; empty unless isSplit().
  std::span<const float> heights() const { return heights_; }
  glm::vec2 perPixel() const { return perPixel_; }  ///< cells
  void setConstants(ShadingConstants& constants) const;

 private:
  bool allUnder_ = false;
  glm::vec2 perPixel_{0.0f};
  std::vector<float> heights_;
};

}  // namespace seaway::render
