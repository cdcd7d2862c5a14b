#include "render/gl/wake_stamp_pass.h"

#include <cmath>
#include <glm/common.hpp>

#include "render/gl/stamp_map.h"

namespace seaway::render {

WakeStampPass::WakeStampPass()
    : program_({"wake_stamps.vert"}, {"field_buffers.glsl", "wake_stamps.frag"}) {}

void WakeStampPass::upload(const WakePyramid& pyramid, Sheet& sheet) {
  const auto levels = pyramid.levels();
  const int count = static_cast<int>(levels.size()) - 1;  // the last carries nothing
  if (sheet.cells != levels.front().cells) {
    sheet.cells = levels.front().cells;
    sheet.levels = count;
    sheet.spline = makeTexture(GL_R32F, {sheet.cells * 3 / 2, sheet.cells}, GL_NEAREST);
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_3D, 1, &name);
    sheet.missing = GlTexture(name);
    glTextureStorage3D(name, 1, GL_R32F, WakePyramid::blocks, WakePyramid::blocks, count + 1);
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTextureParameteri(name, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTextureParameteri(name, GL_TEXTURE_WRAP_T, GL_REPEAT);
    glTextureParameteri(name, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
  }
  for (int l = 0; l <= count; ++l) {
    const WakePyramid::Level& level = levels[static_cast<std::size_t>(l)];
    if (l < count) {
      glPixelStorei(GL_UNPACK_ROW_LENGTH, static_cast<GLint>(level.stride));
      // As in wake_stamps.frag.
      const glm::ivec2 corner =
          l == 0 ? glm::ivec2(0) : glm::ivec2(sheet.cells, sheet.cells - 2 * level.cells);
      glTextureSubImage2D(sheet.spline, 0, corner.x, corner.y, level.cells, level.cells, GL_RED,
                          GL_FLOAT, level.row(0));
      glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    }
    glTextureSubImage3D(sheet.missing, 0, 0, 0, l, WakePyramid::blocks, WakePyramid::blocks, 1,
                        GL_RED, GL_FLOAT, level.missing.data());
  }
}

void WakeStampPass::draw(const WakesInView& wakes, glm::dvec2 foot, std::span<const TwinRow> rows,
                         int columns) {
  const auto pyramids = wakes.sheets();
  sheets_.resize(pyramids.size());
  program_.set("mapSize", glm::vec2(columns, rows.size()));
  const glm::dvec2 place = foot - wakes.drift();  // in the water's frame
  for (std::size_t i = 0; i < pyramids.size(); ++i) {
    const WakePyramid& pyramid = pyramids[i];
    const double size = pyramid.size();
    const glm::vec2 centre(pyramid.centre() - place);
    // The corners of a square, whichever way the rows lie.
    const auto texels =
        texelsAround(centre, static_cast<float>(std::sqrt(0.5) * size), rows, columns);
    if (!texels) continue;
    upload(pyramid, sheets_[i]);
    program_.set("texels", *texels);
    program_.set("origin", glm::vec2(place / size - glm::floor(place / size)));
    program_.set("centre", centre);
    program_.set("size", static_cast<float>(size));
    program_.set("cell", static_cast<float>(pyramid.cellSize()));
    program_.set("levels", sheets_[i].levels);
    program_.set("cells0", sheets_[i].cells);
    program_.setTexture("spline", 0, sheets_[i].spline);
    program_.setTexture("missingSlope", 1, sheets_[i].missing);
    glUseProgram(program_);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
}

std::size_t WakeStampPass::memoryBytes() const {
  std::size_t bytes = 0;
  for (const Sheet& sheet : sheets_) {
    const auto cells = static_cast<std::size_t>(sheet.cells);
    bytes += 4 * (cells * cells * 3 / 2 +
                  WakePyramid::blocks * WakePyramid::blocks * (sheet.levels + std::size_t{1}));
  }
  return bytes;
}

}  // namespace seaway::render
