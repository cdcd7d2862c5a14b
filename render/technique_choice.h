#pragma once

#include <memory>
#include <span>
#include <string>

#include "render/render_technique.h"

namespace seaway::render {

/// A technique by its names, as on the command line.
struct TechniqueChoice {
  std::string technique =
      "projected_grid";  ///< or radial_grid, post_process, naive_grid, reference
  /// Of the projected grid: automatic, or a name of gridVariantName. Automatic is the fastest: all
  /// on the processor where OpenGL would be software, a marched picture on a graphics card.
  std::string variant = "automatic";
  glm::ivec2 grid{256, 256};
  std::string backend = "osmesa";  ///< of variants that draw through OpenGL
};

/// Names that TechniqueChoice takes.
std::span<const std::string_view> techniqueNames();
std::span<const std::string_view> variantNames();

/// Makes the technique and the context it needs, if any, with whatever lens a view has (lens.h).
/// Throws InputError for an unknown name, with those that are known.
std::unique_ptr<RenderTechnique> makeTechnique(const TechniqueChoice& choice);

}  // namespace seaway::render
