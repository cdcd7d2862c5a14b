#include "render/gl/gpu_clock.h"

namespace seaway::render {

void GpuClock::mark() {
  if (used_ == queries_.size()) {
    GLuint name = 0;
    glCreateQueries(GL_TIMESTAMP, 1, &name);
    queries_.emplace_back(name);
  }
  glQueryCounter(queries_[used_++], GL_TIMESTAMP);
}

void GpuClock::start(std::string pass) {
  if (!enabled_) return;
  passes_.push_back(std::move(pass));
  mark();
}

void GpuClock::stop() {
  if (enabled_) mark();
}

std::vector<std::pair<std::string, double>> GpuClock::collect() {
  std::vector<std::pair<std::string, double>> result;
  for (std::size_t i = 0; i < passes_.size(); ++i) {
    GLuint64 first = 0, last = 0;
    glGetQueryObjectui64v(queries_[2 * i], GL_QUERY_RESULT, &first);
    glGetQueryObjectui64v(queries_[2 * i + 1], GL_QUERY_RESULT, &last);
    result.emplace_back(std::move(passes_[i]), 1e-6 * static_cast<double>(last - first));
  }
  passes_.clear();
  used_ = 0;
  return result;
}

}  // namespace seaway::render
