#include "render/gl/shading_textures.h"

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "render/shading/shading_tables.h"

namespace seaway::render {
namespace {

constexpr int fresnelColumns = ShadingTables::fresnelColumns;
constexpr int fresnelRows = ShadingTables::fresnelRows;

/// Calls `put(level, side, first texel)` for each level of a chain.
template <typename Put>
void forEachLevel(int side, int levels, Put put) {
  for (int level = 0; level < levels; ++level) put(level, side >> level, levelStart(side, level));
}

}  // namespace

GLuint ShadingTextures::dome(const SkyDome& sky) {
  if (dome_ == 0) {
    dome_ = makeTexture(GL_RGB9_E5, {SkyDome::side, SkyDome::side}, GL_LINEAR, SkyDome::levels);
  }
  if (domeVersion_ != sky.version()) {
    forEachLevel(SkyDome::side, SkyDome::levels, [&](int level, int side, int first) {
      glTextureSubImage2D(dome_, level, 0, 0, side, side, GL_RGB, GL_UNSIGNED_INT_5_9_9_9_REV,
                          sky.texels().data() + first);
    });
    domeVersion_ = sky.version();
  }
  return dome_;
}

GLuint ShadingTextures::fresnel() {
  if (fresnel_ != 0) return fresnel_;
  const ShadingTables& tables = shadingTables();
  std::vector<glm::vec3> texels;
  for (std::size_t i = 0; i < tables.mirror.size(); ++i) {
    texels.emplace_back(static_cast<float>(tables.mirror[i] & 0xFFFFu) / 65535.0f,
                        static_cast<float>(tables.mirror[i] >> 16) / 65535.0f, tables.area[i]);
  }
  fresnel_ = makeTexture(GL_RGBA32F, {fresnelColumns, fresnelRows}, GL_LINEAR);
  glTextureSubImage2D(fresnel_, 0, 0, 0, fresnelColumns, fresnelRows, GL_RGB, GL_FLOAT,
                      texels.data());
  return fresnel_;
}

GLuint ShadingTextures::ripples() {
  if (ripples_ != 0) return ripples_;
  std::vector<glm::vec2> texels;
  for (const std::uint32_t texel : shadingTables().ripples) {
    texels.push_back(unpackRipple(texel));
  }
  constexpr int wholeSide = ShadingTables::rippleSide, levels = ShadingTables::rippleLevels;
  ripples_ = makeTexture(GL_RG32F, {wholeSide, wholeSide}, GL_LINEAR, levels);
  forEachLevel(wholeSide, levels, [&](int level, int side, int first) {
    glTextureSubImage2D(ripples_, level, 0, 0, side, side, GL_RG, GL_FLOAT, texels.data() + first);
  });
  glTextureParameteri(ripples_, GL_TEXTURE_WRAP_S, GL_REPEAT);
  glTextureParameteri(ripples_, GL_TEXTURE_WRAP_T, GL_REPEAT);
  return ripples_;
}

GLuint ShadingTextures::foam() {
  if (foam_ != 0) return foam_;
  constexpr int wholeSide = FoamTable::side, levels = FoamTable::levels;
  foam_ = makeTexture(GL_R32F, {wholeSide, wholeSide}, GL_LINEAR, levels);
  forEachLevel(wholeSide, levels, [&](int level, int side, int first) {
    glTextureSubImage2D(foam_, level, 0, 0, side, side, GL_RED, GL_FLOAT,
                        foamTable().texels.data() + first);
  });
  glTextureParameteri(foam_, GL_TEXTURE_WRAP_S, GL_REPEAT);
  glTextureParameteri(foam_, GL_TEXTURE_WRAP_T, GL_REPEAT);
  return foam_;
}

GLuint ShadingTextures::fill(const LocalImage& image, Local& local) {
  if (local.size.x < image.size.x || local.size.y < image.size.y) {
    // Room to grow by a half, so that a picture that grows a little each frame does not do this.
    local.size = glm::max(local.size, image.size + image.size / 2);
    local.texture = makeTexture(GL_RGBA32F, local.size, GL_NEAREST);
  }
  std::vector<glm::vec4> texels(image.light.size());
  for (std::size_t i = 0; i < texels.size(); ++i) {
    texels[i] = glm::vec4(image.radiance(i), image.nearness[i]);
  }
  glTextureSubImage2D(local.texture, 0, 0, 0, image.size.x, image.size.y, GL_RGBA, GL_FLOAT,
                      texels.data());
  return local.texture;
}

GLuint ShadingTextures::shadows(const ShadowMaps& maps, bool anew) {
  const glm::ivec2 size = maps.size();
  if (shadows_.size.x < size.x || shadows_.size.y < size.y) {
    shadows_.size = glm::max(shadows_.size, size + size / 4);
    shadows_.texture = makeTexture(GL_R32F, shadows_.size, GL_NEAREST);
    anew = true;
  }
  if (anew) {
    glTextureSubImage2D(shadows_.texture, 0, 0, 0, size.x, size.y, GL_RED, GL_FLOAT,
                        maps.texels().data());
  }
  return shadows_.texture;
}

std::size_t ShadingTextures::skyMemoryBytes() const {
  return dome_ == 0 ? 0 : std::size_t{SkyDome::side} * SkyDome::side * 4 * 4 / 3;
}

std::size_t ShadingTextures::waterMemoryBytes() const {
  return (fresnel_ == 0 ? 0 : std::size_t{fresnelColumns} * fresnelRows * 16) +
         (ripples_ == 0 ? 0 : shadingTables().ripples.size() * 8) +
         (foam_ == 0 ? 0 : foamTable().texels.size() * sizeof(float));
}

}  // namespace seaway::render
