#pragma once

#include <cstddef>
#include <map>
#include <string>

namespace seaway::render::test {

/// Counts OpenGL objects as they are made and deleted, by stepping between the program and the
/// loader's functions. One at a time; the context must be current for its whole life.
class GlCensus {
 public:
  GlCensus();
  ~GlCensus();
  GlCensus(const GlCensus&) = delete;
  GlCensus& operator=(const GlCensus&) = delete;

  /// Objects alive of those made since this object was: by kind ("texture", "buffer", …).
  static std::map<std::string, long> alive();
  static long made();  ///< in all, whether alive or not
};

}  // namespace seaway::render::test
