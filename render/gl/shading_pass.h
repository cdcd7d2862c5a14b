#pragma once

#include <cstddef>
#include <optional>

#include "render/gl/frame_targets.h"
#include "render/gl/gl_objects.h"
#include "render/render_technique.h"
#include "render/ripples.h"

namespace seaway::render {

/// What shading needs to know beside the geometry framebuffer.
struct ShadingInput {
  const View* view = nullptr;
  glm::vec3 sunDirection{0.0f, 0.0f, 1.0f};
  bool sunIsOn = false;
  GLuint skyDome = 0;  ///< 0: the sky is switched off
  bool waterIsOn = false;
  bool objectsAreOn = false;
  bool cameraIsUnderWater = false;
};

/// From geometry to an image: shades every pixel once, maps tones. Needs an empty
/// vertex array to be bound.
class ShadingPass {
 public:
  ShadingPass();
  void shade(const FrameTargets& targets, const ShadingInput& input);
  void mapTones(const FrameTargets& targets, const ShadingInput& input);

  /// Tables that only water needs; 0 until water is drawn.
  std::size_t waterMemoryBytes() const;

 private:
  void setWater(const ShadingInput& input);
  void shadeClass(const GlProgram& program, StencilClass which, const FrameTargets& targets,
                  const ShadingInput& input);

  GlProgram sky_, toneMap_;
  GlProgram object_, water_, underside_;  // made when first needed
  struct WaterTables {
    WaterTables();
    GlTexture fresnel, ripples;
  };
  std::optional<WaterTables> waterTables_;
};

}  // namespace seaway::render
