#include "render/gl/shading_pass.h"

#include <string>
#include <string_view>

#include "render/fresnel.h"

namespace seaway::render {
namespace {

void drawFullScreen(const GlProgram& program, GLuint framebuffer, glm::ivec2 size) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, size.x, size.y);
  glUseProgram(program);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

GlProgram makeShader(std::string_view fragment) {
  return GlProgram({"full_screen.vert"},
                   {"shading_prelude.glsl", "rain_rings.glsl.h", "optics.glsl.h",
                    "waterline.glsl.h", "shadows.glsl.h", "night_lights.glsl.h",
                    "sea_shading.glsl.h", "under_water.glsl.h", "shading_inputs.glsl", fragment});
}

std::string element(const char* name, int i) {
  return std::string(name) + '[' + std::to_string(i) + ']';
}

void setLight(const GlProgram& program, const ShadingConstants& c) {
  program.set("sunIsOn", c.sunIsOn ? 1 : 0);
  program.set("skyIsOn", c.skyIsOn ? 1 : 0);
  program.set("sunDirection", c.sunDirection);
  program.set("sunLight", c.sunLight);
  program.set("skyLight", c.skyLight);
  program.set("seaDeviation", c.seaDeviation);
  program.set("sunlitFacets", c.sunlitFacets);
  program.set("levelSun", c.levelSun);
  program.set("horizonRayleigh", c.horizonRayleigh);
  program.set("horizonAerosol", c.horizonAerosol);
  program.set("horizonOften", c.horizonOften);
  program.set("aerosolShape", c.aerosolShape);
  program.set("airExtinction", c.airExtinction);
  program.set("exposure", c.exposure);
  program.set("toneCurve", c.toneCurve);
  program.set("dithers", c.dithers ? 1 : 0);
  program.set("hazeIsOn", c.hazeIsOn ? 1 : 0);
  program.set("specular", c.specular);
  program.set("extinctionIsLinear", c.extinctionIsLinear ? 1 : 0);
  program.set("backFacesAreTilted", c.backFacesAreTilted ? 1 : 0);
}

void setNight(const GlProgram& program, const ShadingConstants& c) {
  program.set("twilightIsOn", c.twilightIsOn ? 1 : 0);
  program.set("horizonSide", c.horizonSide);
  program.set("horizonArch", c.horizonArch);
  program.set("moonIsOn", c.moonIsOn ? 1 : 0);
  program.set("levelMoon", c.levelMoon);
  program.set("moonRayleigh", c.moonRayleigh);
  program.set("moonAerosol", c.moonAerosol);
  program.set("discAxis", c.discAxis);
  program.set("discEdge", c.discEdge);
  program.set("discLight", c.discLight);
  program.set("starLight", c.starLight);
  program.set("lampCount", c.lampCount);
  for (int i = 0; i < c.lampCount; ++i) {
    program.set(element("lampPlace", i).c_str(), c.lampPlace[i]);
    program.set(element("lampLight", i).c_str(), c.lampLight[i]);
    program.set(element("lampWidth", i).c_str(), c.lampWidth[i]);
    program.set(element("lampShines", i).c_str(), c.lampShines[i]);
  }
}

void setWater(const GlProgram& program, const ShadingConstants& c) {
  program.set("waterExtinction", c.waterExtinction);
  program.set("deepWater", c.deepWater);
  program.set("veil", c.veil);
  program.set("crestSky", c.crestSky);
  program.set("crestSun", c.crestSun);
  program.set("crestScale", c.crestScale);
  program.set("ripplesAreOn", c.ripplesAreOn ? 1 : 0);
  program.set("rippleDeviation", c.rippleDeviation);
  program.set("hairSlope", c.hairSlope);
  program.set("waveLean", c.waveLean);
  program.set("rippleLastLevel", c.rippleLastLevel);
  for (int i = 0; i < 4; ++i) {
    program.set(element("rippleFromWorld", i).c_str(), c.rippleFromWorld[i]);
  }
  for (int i = 0; i < 2; ++i) {
    program.set(element("rippleOrigin", i).c_str(), c.rippleOrigin[i]);
    program.set(element("rippleAlong", i).c_str(), c.rippleAlong[i]);
    program.set(element("rippleTexelsPerMetre", i).c_str(), c.rippleTexelsPerMetre[i]);
  }
  for (int i = 0; i < 8; ++i) program.set(element("rippleKept", i).c_str(), c.rippleKept[i]);
}

void setLocal(const GlProgram& program, const ShadingConstants& c) {
  program.set("pixelRight", c.pixelRight);
  program.set("pixelDown", c.pixelDown);
  program.set("pixelMiddle", c.pixelMiddle);
  program.set("mirrorIsOn", c.mirrorIsOn ? 1 : 0);
  program.set("belowIsOn", c.belowIsOn ? 1 : 0);
  program.set("mirrorLeast", c.mirrorLeast);
  program.set("mirrorSize", c.mirrorSize);
  program.set("belowLeast", c.belowLeast);
  program.set("belowSize", c.belowSize);
  program.set("mirrorSteps", c.mirrorSteps);
  program.set("mirrorNearest", c.mirrorNearest);
  program.set("mirrorFarthest", c.mirrorFarthest);
  program.set("mirrorBend", c.mirrorBend);
  program.set("shoreHardness", c.shoreHardness);
}

void setUnderWater(const GlProgram& program, const ShadingConstants& c) {
  program.set("windowIsOn", c.windowIsOn ? 1 : 0);
  program.set("depthsAreOn", c.depthsAreOn ? 1 : 0);
  program.set("windowLeast", c.windowLeast);
  program.set("windowSize", c.windowSize);
  program.set("depthsLeast", c.depthsLeast);
  program.set("depthsSize", c.depthsSize);
  program.set("stillWater", c.stillWater);
  program.set("sunInWater", c.sunInWater);
  program.set("sunThroughSurface", c.sunThroughSurface);
  program.set("eyeVeil", c.eyeVeil);
  program.set("waterlineIsOn", c.waterlineIsOn ? 1 : 0);
  program.set("waterlinePerPixel", c.waterlinePerPixel);
}

void setShadows(const GlProgram& program, const ShadingConstants& c) {
  program.set("shadowCount", c.shadowCount);
  if (c.shadowCount == 0) return;
  program.set("sunPartBelow", c.sunPartBelow);
  program.set("shadowRight", c.shadowRight);
  program.set("shadowUp", c.shadowUp);
  program.set("shadowBend", c.shadowBend);
  program.set("shadowBase", c.shadowBase);
  for (int i = 0; i < c.shadowCount; ++i) {
    program.set(element("shadowLeast", i).c_str(), c.shadowLeast[i]);
    program.set(element("shadowSize", i).c_str(), c.shadowSize[i]);
    program.set(element("shadowTexel", i).c_str(), c.shadowTexel[i]);
    program.set(element("shadowRow", i).c_str(), c.shadowRow[i]);
  }
}

void setFoamAndRain(const GlProgram& program, const ShadingConstants& c) {
  program.set("oilLight", c.oilLight);
  program.set("bubbleLight", c.bubbleLight);
  program.set("foamIsOn", c.foamIsOn ? 1 : 0);
  if (c.foamIsOn) {
    program.set("foamSky", c.foamSky);
    program.set("foamSun", c.foamSun);
    program.set("whitecapAlong", c.whitecapAlong);
    program.set("whitecapPerHeight", c.whitecapPerHeight);
    program.set("whitecapMean", c.whitecapMean);
    program.set("perTotalSlope", c.perTotalSlope);
    program.set("breakingRamp", c.breakingRamp);
    program.set("oldRamp", c.oldRamp);
    program.set("foamLastLevel", c.foamLastLevel);
    for (int i = 0; i < 3; ++i) {
      program.set(element("foamTexelsPerMetre", i).c_str(), c.foamTexelsPerMetre[i]);
      program.set(element("foamAxis", i).c_str(), c.foamAxis[i]);
      program.set(element("foamOrigin", i).c_str(), c.foamOrigin[i]);
    }
    for (int i = 0; i < 8; ++i) program.set(element("foamKept", i).c_str(), c.foamKept[i]);
  }
  program.set("rainIsOn", c.rainIsOn ? 1 : 0);
  if (!c.rainIsOn) return;
  program.set("rainCell", glm::ivec2(c.rainColumn, c.rainRow));
  program.set("rainCode", glm::ivec2(c.rainCount, c.rainSeed));
  program.set("rainFoot", c.rainFoot);
  program.set("rainPart", c.rainPart);
  program.set("rainDrops", c.rainDrops);
  program.set("rainMeanSquare", c.rainMeanSquare);
  program.set("rainSlots", c.rainSlots);
}

}  // namespace

void setWaterTextures(const GlProgram& program, ShadingTextures& textures,
                      const ShadingInput& input) {
  program.setTexture("fresnelTable", 4, textures.fresnel());
  program.setTexture("rippleMap", 5, textures.ripples());
  const ShadingConstants& c = input.constants;
  if (c.foamIsOn) program.setTexture("foamMap", 6, textures.foam());
  if (c.mirrorIsOn) program.setTexture("mirrorMap", 7, textures.mirrored(input.local->mirrored()));
  if (c.belowIsOn) program.setTexture("belowMap", 8, textures.below(input.local->below()));
}

void setSceneTextures(const GlProgram& program, ShadingTextures& textures,
                      const ShadingInput& input, bool anew) {
  const ShadingConstants& c = input.constants;
  if (c.shadowCount > 0) {
    program.setTexture("shadowMap", 15, textures.shadows(*input.shadows, anew));
  }
  if (c.waterlineIsOn) program.setTexture("waterlineMap", 14, input.waterline);
  if (c.windowIsOn) program.setTexture("windowMap", 13, textures.window(input.local->window()));
  if (c.depthsAreOn) program.setTexture("depthsMap", 12, textures.depths(input.local->depths()));
}

void setShadingConstants(const GlProgram& program, const ShadingConstants& c) {
  program.set("forward", c.forward);
  program.set("middleRay", c.middleRay);
  program.set("right", c.right);
  program.set("up", c.up);
  program.set("pixelAngle", c.pixelAngle);
  program.set("cameraIsUnderWater", c.cameraIsUnderWater ? 1 : 0);
  program.set("roughestSlope", static_cast<float>(fresnelTableRoughest));
  setLight(program, c);
  setNight(program, c);
  setWater(program, c);
  setLocal(program, c);
  setUnderWater(program, c);
  setShadows(program, c);
  setFoamAndRain(program, c);
}

ShadingPass::ShadingPass()
    : sky_(makeShader("shade_sky.frag")),
      toneMap_({"full_screen.vert"},
               {"shading_prelude.glsl", "rain_rings.glsl.h", "optics.glsl.h", "waterline.glsl.h",
                "shadows.glsl.h", "night_lights.glsl.h", "sea_shading.glsl.h", "under_water.glsl.h",
                "tone_map.frag"}) {}

void ShadingPass::shadeClass(const GlProgram& program, StencilClass which,
                             const FrameTargets& targets, const ShadingInput& input) {
  setShadingConstants(program, input.constants);
  if (input.sky) program.setTexture("dome", 0, textures_.dome(*input.sky));
  if (which == stencilWater || which == stencilUnderside) {
    setWaterTextures(program, textures_, input);
  }
  setSceneTextures(program, textures_, input, which == stencilSky);
  program.setTexture("surfaceMap", 1, targets.surface);
  program.setTexture("albedoMap", 2, targets.albedo);
  program.setTexture("distanceMap", 3, targets.distance);
  glStencilFunc(GL_EQUAL, which, 0xFF);
  drawFullScreen(program, targets.shading, targets.size);
}

void ShadingPass::shade(const FrameTargets& targets, const ShadingInput& input) {
  glEnable(GL_STENCIL_TEST);
  glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  shadeClass(sky_, stencilSky, targets, input);
  if (input.waterIsOn) {
    if (water_ == 0) water_ = makeShader("shade_water.frag");
    shadeClass(water_, stencilWater, targets, input);
    if (input.constants.cameraIsUnderWater || input.constants.waterlineIsOn) {
      if (underside_ == 0) underside_ = makeShader("shade_underside.frag");
      shadeClass(underside_, stencilUnderside, targets, input);
    }
  }
  if (input.objectsAreOn) {
    if (object_ == 0) object_ = makeShader("shade_object.frag");
    shadeClass(object_, stencilObject, targets, input);
  }
  glDisable(GL_STENCIL_TEST);
}

void ShadingPass::mapTones(const FrameTargets& targets, const ShadingInput& input) {
  setShadingConstants(toneMap_, input.constants);
  toneMap_.setTexture("radianceMap", 1, targets.radiance);
  if (!input.constants.dithers) glEnable(GL_FRAMEBUFFER_SRGB);
  drawFullScreen(toneMap_, targets.toneMapping, targets.size);
  glDisable(GL_FRAMEBUFFER_SRGB);
}

}  // namespace seaway::render
