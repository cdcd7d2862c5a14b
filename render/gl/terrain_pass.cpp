#include "render/gl/terrain_pass.h"

#include "render/gl/frame_targets.h"
#include "surface/constants.h"

namespace seaway::render {

TerrainPass::TerrainPass()
    : program_({"terrain.vert"},
               {"terrain_detail_glsl.glsl", "terrain_detail.glsl.h", "terrain.frag"}),
      array_(makeVertexArray()) {
  glVertexArrayVertexBuffer(array_, 0, vertices_, 0, sizeof(glm::vec3));
  floatAttribute(array_, 0, 3, 0);
}

void TerrainPass::upload(const TerrainSkin& skin) {
  const auto levels = static_cast<int>(skin.levels().size());
  const glm::ivec2 size = skin.levels().front().size;
  const GLenum filter = GL_LINEAR;
  colours_ = makeTexture(GL_RGBA8, size, filter, levels);
  slopes_ = makeTexture(GL_RG16_SNORM, size, filter, levels);
  for (int level = 0; level < levels; ++level) {
    const TerrainSkin::Level& l = skin.levels()[level];
    glTextureSubImage2D(colours_, level, 0, 0, l.size.x, l.size.y, GL_RGBA, GL_UNSIGNED_BYTE,
                        &skin.colours()[l.first]);
    glTextureSubImage2D(slopes_, level, 0, 0, l.size.x, l.size.y, GL_RG, GL_SHORT,
                        &skin.slopes()[l.first]);
  }
  for (const GLuint texture : {GLuint(colours_), GLuint(slopes_)}) {
    glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER,
                        levels > 1 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
  }
  skinBytes_ = skin.memoryBytes();
}

void TerrainPass::draw(const TerrainInView& terrain, const Camera& camera,
                       const glm::mat4& clipFromRelativeWorld) {
  if (terrain.corners().empty()) return;
  if (map_ != &terrain.map()) {
    upload(terrain.skin());
    map_ = &terrain.map();
  }
  vertices_.put(terrain.corners());
  const glm::dvec2 foot = glm::dvec2(camera.position) - terrain.map().least();
  program_.set("clipFromRelativeWorld", clipFromRelativeWorld);
  program_.set("mapFoot", glm::vec2(foot));
  program_.set("mapExtent", glm::vec2(terrain.map().most() - terrain.map().least()));
  program_.set("texelSize", terrain.skin().texelSize());
  program_.set("mostSlope", TerrainSkin::mostSlope);
  program_.set("lastLevel", static_cast<float>(terrain.skin().levels().size() - 1));
  program_.set("pixelAngle", static_cast<float>(camera.pixelAngle()));
  program_.set("eyeHeight", static_cast<float>(camera.position.z));
  program_.set("curvature", static_cast<float>(0.5 / earthMeanRadius));
  program_.set("wetHeight", terrain.wetHeight());
  program_.setTexture("colourMap", 0, colours_);
  program_.setTexture("slopeMap", 1, slopes_);
  glStencilFunc(GL_ALWAYS, stencilObject, 0xFF);
  glUseProgram(program_);
  glBindVertexArray(array_);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(terrain.corners().size()));
}

}  // namespace seaway::render
