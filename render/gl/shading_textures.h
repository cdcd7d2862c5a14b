#pragma once

#include <cstddef>
#include <optional>

#include "render/gl/gl_objects.h"
#include "render/local_image.h"
#include "render/shading/sky_dome.h"
#include "render/shadow_maps.h"

namespace seaway::render {

/// The sky and the tables of shading as textures: the same texels that the processor shades with.
class ShadingTextures {
 public:
  /// The sky's texture, filled again when the dome was drawn anew.
  GLuint dome(const SkyDome& sky);
  /// Made when water is first shaded.
  GLuint fresnel();
  GLuint ripples();
  /// Made when foam is first shaded.
  GLuint foam();

  /// A picture of LocalLight, filled anew by each call.
  GLuint mirrored(const LocalImage& image) { return fill(image, mirrored_); }
  GLuint below(const LocalImage& image) { return fill(image, below_); }
  GLuint window(const LocalImage& image) { return fill(image, window_); }
  GLuint depths(const LocalImage& image) { return fill(image, depths_); }
  /// The sun's maps, filled in where `anew`.
  GLuint shadows(const ShadowMaps& maps, bool anew);

  std::size_t skyMemoryBytes() const;
  std::size_t waterMemoryBytes() const;

 private:
  struct Local {
    GlTexture texture;
    glm::ivec2 size{0};
  };
  static GLuint fill(const LocalImage& image, Local& local);

  GlTexture dome_, fresnel_, ripples_, foam_;
  Local mirrored_, below_, window_, depths_, shadows_;
  int domeVersion_ = 0;
};

}  // namespace seaway::render
