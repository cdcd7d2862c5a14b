#pragma once

#include <cstddef>

#include "render/gl/frame_targets.h"
#include "render/gl/gl_objects.h"
#include "render/gl/shading_textures.h"
#include "render/local_light.h"
#include "render/shading/shading_constants.h"
#include "render/shading/sky_dome.h"
#include "render/shadow_maps.h"

namespace seaway::render {

/// What shading needs to know beside the geometry framebuffer.
struct ShadingInput {
  ShadingConstants constants;
  const SkyDome* sky = nullptr;       ///< null: the sky is switched off
  const LocalLight* local = nullptr;  ///< read where the constants say so, as the next two
  const ShadowMaps* shadows = nullptr;
  GLuint waterline = 0;  ///< texture of the waterline's heights
  bool waterIsOn = false;
  bool objectsAreOn = false;
};

/// Binds what water is shaded with beside the sky, from unit 4 on.
void setWaterTextures(const GlProgram& program, ShadingTextures& textures,
                      const ShadingInput& input);

/// Binds what the processor has drawn of scene objects, from unit 15 down; shadows are filled in
/// where `anew`.
void setSceneTextures(const GlProgram& program, ShadingTextures& textures,
                      const ShadingInput& input, bool anew);

/// Sets the uniforms of shading_prelude.glsl.
void setShadingConstants(const GlProgram& program, const ShadingConstants& constants);

/// From geometry to an image: shades every pixel once with sea_shading.glsl.h, maps tones. Needs an
/// empty vertex array to be bound.
class ShadingPass {
 public:
  ShadingPass();
  void shade(const FrameTargets& targets, const ShadingInput& input);
  void mapTones(const FrameTargets& targets, const ShadingInput& input);

  std::size_t skyMemoryBytes() const { return textures_.skyMemoryBytes(); }
  /// Tables that only water needs; 0 until water is drawn.
  std::size_t waterMemoryBytes() const { return textures_.waterMemoryBytes(); }

 private:
  void shadeClass(const GlProgram& program, StencilClass which, const FrameTargets& targets,
                  const ShadingInput& input);

  GlProgram sky_, toneMap_;
  GlProgram object_, water_, underside_;  // made when first needed
  ShadingTextures textures_;
};

}  // namespace seaway::render
