#include "render/gl/projected_waves.h"

#include "render/gl/loader.h"

namespace seaway::render {

ProjectedWaves::ProjectedWaves()
    : noVertices_(makeVertexArray()),
      map_(isSoftwareRenderer() ? WaveMap::Way::fragment : WaveMap::Way::compute),
      clock_(!isSoftwareRenderer()) {}

void ProjectedWaves::fill(const View& view, const Projector& projector, glm::ivec2 size,
                          std::span<const Stamp> stamps) {
  const glm::dvec2 foot(view.camera.position);
  const FieldTwin field(view.water->waves(), view.time, foot);
  rows_ = twinRows(projector, view.water->waves(), size);
  coverMap_.fill(*view.water, view.time, foot, rows_, size.x);
  glBindVertexArray(noVertices_);
  stampTexture_ = 0;
  if (!stamps.empty()) {
    if (!stampPass_) stampPass_.emplace();
    map_.uploadRows(rows_);
    clock_.start("stamps");
    stampTexture_ = stampPass_->draw(stamps, foot, rows_, size.x);
    clock_.stop();
  }
  useOutline(map_.program(), view);
  clock_.start("heights");
  map_.fill(field, rows_, size.x, view.camera, stampTexture_, coverMap_.extras());
  clock_.stop();
}

void ProjectedWaves::useCover(const GlProgram& program) const {
  program.set("coverIsOn", coverMap_.cover() != 0 ? 1 : 0);
  if (coverMap_.cover() != 0) program.setTexture("coverMap", 2, coverMap_.cover());
}

std::size_t ProjectedWaves::memoryBytes() const {
  return map_.memoryBytes() + coverMap_.memoryBytes() + outline_.memoryBytes() + (stampPass_ ? stampPass_->memoryBytes() : 0) +
         rows_.capacity() * sizeof(TwinRow);
}

}  // namespace seaway::render
