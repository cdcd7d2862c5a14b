#include "render/gl/compute_shading.h"

namespace seaway::render {

ComputeShading::ComputeShading()
    : program_(GlProgram::compute({"shading_prelude.glsl", "rain_rings.glsl.h", "optics.glsl.h",
                                   "waterline.glsl.h", "shadows.glsl.h", "night_lights.glsl.h",
                                   "sea_shading.glsl.h", "under_water.glsl.h", "shade.comp"})) {}

void ComputeShading::shade(FrameTargets& targets, const ShadingInput& input, bool wantsRadiance) {
  setShadingConstants(program_, input.constants);
  if (input.sky) program_.setTexture("dome", 0, textures_.dome(*input.sky));
  program_.setTexture("surfaceMap", 1, targets.surface);
  program_.setTexture("albedoMap", 2, targets.albedo);
  program_.setTexture("distanceMap", 3, targets.distance);
  if (input.waterIsOn) setWaterTextures(program_, textures_, input);
  setSceneTextures(program_, textures_, input, true);
  glBindImageTexture(0, targets.displayBytes(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA8);
  program_.set("radianceIsWanted", wantsRadiance ? 1 : 0);
  glBindImageTexture(3, targets.radiance, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA16F);
  glUseProgram(program_);
  glDispatchCompute(static_cast<GLuint>((targets.size.x + 15) / 16),
                    static_cast<GLuint>((targets.size.y + 7) / 8), 1);
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
                  GL_FRAMEBUFFER_BARRIER_BIT);
}

}  // namespace seaway::render
