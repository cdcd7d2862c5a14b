#include "render/gl/outline_buffers.h"

#include <span>
#include <vector>

namespace seaway::render {

void OutlineBuffers::upload() {
  if (!buffers_) buffers_ = std::make_unique<Buffers>();
  std::vector<glm::ivec4> cells;
  for (const WaterOutline::Cell& cell : outline_->cells()) {
    cells.emplace_back(cell.firstEdge, cell.edgeCount, cell.winding, 0);
  }
  std::vector<glm::vec4> edges;
  for (const WaterOutline::Edge& edge : outline_->edges()) {
    edges.emplace_back(glm::vec2(edge.from), glm::vec2(edge.to));
  }
  buffers_->cells.put(std::span<const glm::ivec4>(cells));
  buffers_->edges.put(std::span<const glm::vec4>(edges));
}

void OutlineBuffers::use(const GlProgram& program,
                         const std::shared_ptr<const WaterOutline>& outline, const Camera& camera) {
  program.set("outlineIsOn", outline ? 1 : 0);
  if (!outline) return;
  if (outline != outline_) {
    outline_ = outline;
    upload();
  }
  program.set("outlineFoot", glm::vec2(glm::dvec2(camera.position) - outline_->origin()));
  program.set("outlineCellSize", glm::vec2(outline_->cellSize()));
  program.set("outlineCellCount", outline_->cellCount());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2, buffers_->cells);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, buffers_->edges);
}

std::size_t OutlineBuffers::memoryBytes() const {
  return buffers_ ? buffers_->cells.memoryBytes() + buffers_->edges.memoryBytes() : 0;
}

}  // namespace seaway::render
