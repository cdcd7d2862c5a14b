#pragma once

#include <cstddef>
#include <span>

#include "render/frame.h"
#include "render/gl/gl_objects.h"
#include "render/render_technique.h"
#include "render/shading/shading_constants.h"

namespace seaway::render {

/// How a pixel is shaded.
enum StencilClass : GLint { stencilSky = 0, stencilWater, stencilUnderside, stencilObject };

/// The framebuffers a frame passes through, for one image size.
///
/// Geometry leaves in `surface` and `albedo` what shading needs, and the axial distance with the
/// pixel's class as its sign: 0 sky, > 0 water, < 0 object. The stencil tells apart what is shaded
/// in different ways: on a software context that skips whole blocks, where a branch would not.
struct FrameTargets {
  explicit FrameTargets(glm::ivec2 imageSize);

  glm::ivec2 size;
  GlTexture surface;   ///< water: slope, missing slope, height; object: normal
  GlTexture albedo;    ///< object: reflectance
  GlTexture distance;  ///< axial distance, m, signed by class
  GlTexture depth;     ///< with stencil, a StencilClass
  GlTexture radiance;  ///< linear, scene referred
  GlTexture display;   ///< sRGB, top row first
  GlFramebuffer geometry, shading, toneMapping;

  /// The display's bytes as a compute shader can write them: no sRGB. Made when first asked for.
  GLuint displayBytes();

  std::size_t memoryBytes() const;

 private:
  GlTexture displayBytes_;
};

/// Copies what `frame` has room for beside colour, depth, classes and normals: radiance, instances
/// of `objects`, foam as `constants` shade it. To be called after readBack.
void readContents(const FrameTargets& targets, std::span<const SceneObject> objects,
                  const ShadingConstants& constants, Frame& frame);

/// Copies `display` and `distance` into a frame of that size. Ground is an object without alpha in
/// `albedo`: looked for where `groundIsShown`.
void readBack(const FrameTargets& targets, bool groundIsShown, Frame& frame);

}  // namespace seaway::render
