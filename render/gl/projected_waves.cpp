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
  coverMap_.fill(view, rows_, size.x);
  glBindVertexArray(noVertices_);
  if (const auto disturbances = view.water->disturbances()) {
    wakes_.fill(disturbances.get(), view.time, foot,
                projectedLayout(projector, view.water->waves(), size));
  } else {
    wakes_ = {};
  }
  addStamps(stamps, foot, size.x);
  useOutline(map_.program(), view);
  clock_.start("heights");
  map_.fill(field, rows_, size.x, view.camera, this->stamps(), coverMap_.extras());
  clock_.stop();
}

void ProjectedWaves::addStamps(std::span<const Stamp> stamps, glm::dvec2 foot, int columns) {
  if (stamps.empty()) stampPass_.reset();
  if (wakes_.empty()) wakePass_.reset();
  if (stamps.empty() && wakes_.empty()) return stampMap_.reset();
  if (!stampMap_) stampMap_.emplace();
  if (!stamps.empty() && !stampPass_) stampPass_.emplace();
  if (!wakes_.empty() && !wakePass_) wakePass_.emplace();
  map_.uploadRows(rows_);
  clock_.start("stamps");
  stampMap_->begin({columns, static_cast<int>(rows_.size())});
  if (stampPass_) stampPass_->draw(stamps, foot, rows_, columns);
  glBindVertexArray(noVertices_);
  if (wakePass_) wakePass_->draw(wakes_, foot, rows_, columns);
  stampMap_->end();
  clock_.stop();
}

void ProjectedWaves::useCover(const GlProgram& program) const {
  program.set("coverIsOn", coverMap_.cover() != 0 ? 1 : 0);
  if (coverMap_.cover() != 0) program.setTexture("coverMap", 2, coverMap_.cover());
}

std::size_t ProjectedWaves::memoryBytes() const {
  const auto of = [](const auto& part) { return part ? part->memoryBytes() : 0; };
  return map_.memoryBytes() + coverMap_.memoryBytes() + outline_.memoryBytes() + of(stampMap_) +
         of(stampPass_) + of(wakePass_) + wakes_.memoryBytes() + rows_.capacity() * sizeof(TwinRow);
}

}  // namespace seaway::render
