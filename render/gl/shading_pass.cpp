#include "render/gl/shading_pass.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "render/fresnel.h"

namespace seaway::render {
namespace {

constexpr int fresnelColumns = 128, fresnelRows = 32;
constexpr int rippleSide = 256, rippleLevels = 9;

void drawFullScreen(const GlProgram& program, GLuint framebuffer, glm::ivec2 size) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, size.x, size.y);
  glUseProgram(program);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void setLight(const GlProgram& program, const ShadingInput& input) {
  program.setTexture("dome", 0, input.skyDome);
  program.set("skyIsOn", input.skyDome != 0 ? 1 : 0);
  program.set("sunIsOn", input.sunIsOn ? 1 : 0);
  program.set("sunDirection", input.sunDirection);
}

void setCamera(const GlProgram& program, const Camera& camera) {
  const double halfHeight = std::tan(0.5 * camera.verticalFieldOfView);
  program.set("forward", glm::vec3(camera.forward()));
  program.set("right", glm::vec3(-camera.left() * (halfHeight * camera.aspectRatio())));
  program.set("up", glm::vec3(camera.up() * halfHeight));
  program.set("pixelAngle", static_cast<float>(2.0 * halfHeight / camera.size.y));
}

GlProgram makeShader(std::string_view fragment) {
  return GlProgram({"atmosphere.glsl", "lighting.glsl", "lit.vert"},
                   {"atmosphere.glsl", "lighting.glsl", "shading.glsl", fragment});
}

}  // namespace

ShadingPass::ShadingPass()
    : sky_(makeShader("shade_sky.frag")),
      toneMap_({"atmosphere.glsl", "lighting.glsl", "lit.vert"},
               {"atmosphere.glsl", "lighting.glsl", "tone_map.frag"}) {}

ShadingPass::WaterTables::WaterTables()
    : fresnel(makeTexture(GL_RGBA32F, {fresnelColumns, fresnelRows}, GL_LINEAR)),
      ripples(makeTexture(GL_RGBA32F, {rippleSide, rippleSide}, GL_LINEAR, rippleLevels)) {
  const std::vector<glm::vec4> table = fresnelTable(fresnelColumns, fresnelRows);
  glTextureSubImage2D(fresnel, 0, 0, 0, fresnelColumns, fresnelRows, GL_RGBA, GL_FLOAT,
                      table.data());
  const std::vector<glm::vec3> patch = rippleTexture(rippleSide);
  glTextureSubImage2D(ripples, 0, 0, 0, rippleSide, rippleSide, GL_RGB, GL_FLOAT, patch.data());
  glTextureParameteri(ripples, GL_TEXTURE_WRAP_S, GL_REPEAT);
  glTextureParameteri(ripples, GL_TEXTURE_WRAP_T, GL_REPEAT);
  glGenerateTextureMipmap(ripples);
}

void ShadingPass::setWater(const ShadingInput& input) {
  if (!waterTables_) waterTables_.emplace();
  const View& view = *input.view;
  const Ripples ripples = ripplesFor(view.water->waves(), view.light.windSpeed);
  water_.setTexture("fresnelTable", 4, waterTables_->fresnel);
  water_.setTexture("rippleMap", 5, waterTables_->ripples);
  water_.set("roughestSlope", static_cast<float>(fresnelTableRoughest));
  water_.set("ripplesAreOn", ripples.layerSlope > 0.0 ? 1 : 0);
  water_.set("rippleSlope", static_cast<float>(ripples.layerSlope));
  water_.set("hairSlope", static_cast<float>(ripples.hairSlope));
  water_.set("rippleTexels", static_cast<float>(rippleSide));
  const char* matrices[] = {"rippleFromWorld[0]", "rippleFromWorld[1]"};
  const char* origins[] = {"rippleOrigin[0]", "rippleOrigin[1]"};
  for (int layer = 0; layer < 2; ++layer) {
    water_.set(matrices[layer], glm::mat2(ripples.textureFromWorld[layer]));
    water_.set(origins[layer], glm::vec2(ripples.textureCoordinate(
                                   layer, glm::dvec2(view.camera.position), view.time)));
  }
  water_.set("crestHeight", static_cast<float>(0.5 * view.water->waves().significantWaveHeight()));
}

void ShadingPass::shadeClass(const GlProgram& program, StencilClass which,
                             const FrameTargets& targets, const ShadingInput& input) {
  setLight(program, input);
  setCamera(program, input.view->camera);
  program.setTexture("surfaceMap", 1, targets.surface);
  program.setTexture("albedoMap", 2, targets.albedo);
  program.setTexture("distanceMap", 3, targets.distance);
  program.set("cameraIsUnderWater", input.cameraIsUnderWater ? 1 : 0);
  glStencilFunc(GL_EQUAL, which, 0xFF);
  drawFullScreen(program, targets.shading, targets.size);
}

void ShadingPass::shade(const FrameTargets& targets, const ShadingInput& input) {
  glEnable(GL_STENCIL_TEST);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  shadeClass(sky_, stencilSky, targets, input);
  if (input.waterIsOn) {
    if (water_ == 0) water_ = makeShader("shade_water.frag");
    if (underside_ == 0) underside_ = makeShader("shade_underside.frag");
    setWater(input);
    shadeClass(water_, stencilWater, targets, input);
    shadeClass(underside_, stencilUnderside, targets, input);
  }
  if (input.objectsAreOn) {
    if (object_ == 0) object_ = makeShader("shade_object.frag");
    shadeClass(object_, stencilObject, targets, input);
  }
  glDisable(GL_STENCIL_TEST);
}

void ShadingPass::mapTones(const FrameTargets& targets, const ShadingInput& input) {
  setLight(toneMap_, input);
  toneMap_.setTexture("radianceMap", 1, targets.radiance);
  glEnable(GL_FRAMEBUFFER_SRGB);
  drawFullScreen(toneMap_, targets.toneMapping, targets.size);
  glDisable(GL_FRAMEBUFFER_SRGB);
}

std::size_t ShadingPass::waterMemoryBytes() const {
  if (!waterTables_) return 0;
  return fresnelColumns * fresnelRows * 16 + rippleSide * rippleSide * 16 * 4 / 3;
}

}  // namespace seaway::render
