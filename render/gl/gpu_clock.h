#pragma once

#include <string>
#include <utility>
#include <vector>

#include "render/gl/gl_objects.h"

namespace seaway::render {

inline void releaseQuery(GLuint name) { glDeleteQueries(1, &name); }
using GlQuery = GlName<&releaseQuery>;

/// Times passes on the graphics card itself, without waiting for any: timer queries around each.
/// Software renderers have no clock of their own; there nothing is made and nothing measured.
class GpuClock {
 public:
  explicit GpuClock(bool enabled) : enabled_(enabled) {}

  void start(std::string pass);
  void stop();

  /// Milliseconds of each pass since the last call; waits until the last is done.
  std::vector<std::pair<std::string, double>> collect();

 private:
  void mark();

  bool enabled_;
  std::vector<std::string> passes_;
  std::vector<GlQuery> queries_;  // two a pass, reused
  std::size_t used_ = 0;
};

}  // namespace seaway::render
