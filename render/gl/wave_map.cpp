#include "render/gl/wave_map.h"

#include <bit>
#include <cmath>
#include <cstdint>

#include "surface/constants.h"

namespace seaway::render {
namespace {

/// As in field_buffers.glsl.
struct FieldHeader {
  glm::ivec4 counts;
};
constexpr std::size_t fieldBytes =
    sizeof(FieldHeader) + FieldTwin::mostOctaves * sizeof(TwinOctave);
static_assert(sizeof(TwinOctave) == 64 && sizeof(TwinRow) == 32);

struct TallyBlock {
  std::uint32_t largestHeight, verticesInFrustum, largestSlope;
};

GlProgram makeProgram(WaveMap::Way way) {
  if (way == WaveMap::Way::compute) {
    return GlProgram::compute({"field_buffers.glsl", "field.glsl", "field_sum.glsl",
                               "curved_sea.glsl", "outline.glsl", "wave_map.glsl",
                               "wave_map.comp"});
  }
  return GlProgram({"full_screen.vert"},
                   {"field_buffers.glsl", "field.glsl", "field_sum.glsl", "curved_sea.glsl",
                    "outline.glsl", "wave_map.glsl", "wave_map.frag"});
}

}  // namespace

void setCurvedSea(const GlProgram& program, const Camera& camera) {
  program.set("eyeHeight", static_cast<float>(camera.position.z));
  program.set("curvature", static_cast<float>(0.5 / earthMeanRadius));
}

WaveMap::WaveMap(Way way)
    : way_(way), program_(makeProgram(way)), field_(makeBuffer()), tally_(makeBuffer()) {
  glNamedBufferStorage(field_, fieldBytes, nullptr, GL_DYNAMIC_STORAGE_BIT);
  glNamedBufferStorage(tally_, sizeof(TallyBlock), nullptr, GL_DYNAMIC_STORAGE_BIT);
}

void WaveMap::resize(glm::ivec2 size) {
  if (size == size_) return;
  texture_ = makeTexture(GL_RGBA32F, size, GL_LINEAR);
  framebuffer_ = way_ == Way::fragment ? makeFramebuffer({texture_}) : GlFramebuffer();
  size_ = size;
}

void WaveMap::uploadRows(std::span<const TwinRow> rows) {
  rows_.put(rows);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, rows_);
}

void WaveMap::uploadField(const FieldTwin& field) {
  const FieldHeader header{glm::ivec4(field.counts(), 0)};
  glNamedBufferSubData(field_, 0, sizeof header, &header);
  const auto octaves = field.octaves();
  if (!octaves.empty()) {
    glNamedBufferSubData(field_, sizeof header, static_cast<GLsizeiptr>(octaves.size_bytes()),
                         octaves.data());
  }
  const TallyBlock nothing{0, 0, 0};
  glNamedBufferSubData(tally_, 0, sizeof nothing, &nothing);
}

void WaveMap::bindBuffers() const {
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, field_);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, rows_);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, tally_);
}

void WaveMap::fill(const FieldTwin& field, std::span<const TwinRow> rows, int columns,
                   const Camera& camera, GLuint stamps, GLuint extras) {
  resize({columns, static_cast<int>(rows.size())});
  uploadField(field);
  uploadRows(rows);
  bindBuffers();

  const glm::dvec2 half = camera.halfPicture(), middle = camera.pictureMiddle();
  setCurvedSea(program_, camera);
  program_.set("axialFromWorld", glm::vec3(camera.forward()));
  program_.set("xFromWorld", glm::vec3((camera.left() + middle.x * camera.forward()) / half.x));
  program_.set("yFromWorld", glm::vec3((camera.up() - middle.y * camera.forward()) / half.y));
  program_.set("nearDistance", static_cast<float>(camera.nearDistance));
  program_.set("stampsAreOn", stamps != 0 ? 1 : 0);
  program_.setTexture("stamps", 0, stamps);
  program_.set("extrasAreOn", extras != 0 ? 1 : 0);
  if (extras != 0) program_.setTexture("extras", 1, extras);
  glUseProgram(program_);
  if (way_ == Way::compute) {
    glBindImageTexture(0, texture_, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    glDispatchCompute(static_cast<GLuint>((size_.x + 31) / 32),
                      static_cast<GLuint>((size_.y + 3) / 4), 1);
  } else {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, size_.x, size_.y);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                  GL_BUFFER_UPDATE_BARRIER_BIT);
}

WaveMap::Tally WaveMap::tally() const {
  TallyBlock block{0, 0, 0};
  glGetNamedBufferSubData(tally_, 0, sizeof block, &block);
  return {std::bit_cast<float>(block.largestHeight), block.verticesInFrustum};
}

std::size_t WaveMap::memoryBytes() const {
  return fieldBytes + sizeof(TallyBlock) + rows_.memoryBytes() +
         static_cast<std::size_t>(size_.x) * size_.y * 16;
}

}  // namespace seaway::render
