#pragma once

#include <string_view>
#include <vector>

namespace seaway::render::test {

/// Counts every call of OpenGL that the library makes, by stepping between it and the loader's
/// functions. One at a time; a context must be current for its whole life.
class GlCalls {
 public:
  GlCalls();
  ~GlCalls();
  GlCalls(const GlCalls&) = delete;
  GlCalls& operator=(const GlCalls&) = delete;

  static long count();  ///< since this object was made
  /// Names of the functions that are counted.
  static std::vector<std::string_view> counted();
};

}  // namespace seaway::render::test
