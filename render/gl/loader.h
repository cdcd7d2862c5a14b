#pragma once

#include <string>

namespace seaway::render {

/// What a loaded context says of itself.
struct GlDescription {
  std::string renderer;
  std::string version;
  int maximumSize = 0;  ///< of a framebuffer's side, pixels
  bool isSoftware = false;
};

using GlProcedure = void (*)();
using GlGetProcedure = GlProcedure (*)(const char* name);

/// Loads OpenGL 4.5 core through the current context's own lookup. Throws std::runtime_error where
/// the context offers less.
void loadGl(GlGetProcedure getProcedure);

/// Whether the current context draws on the processor.
bool isSoftwareRenderer();

/// Describes the current context.
GlDescription describeGl();

}  // namespace seaway::render
