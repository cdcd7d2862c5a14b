#pragma once

#include <iosfwd>
#include <string>

#include "sim_bridge/commands/command.h"

namespace seaway::bridge {

struct RenderOptions {
  std::string scene;
  double time = 0.0;   ///< s
  std::string camera;  ///< empty: the scene's first
  std::string size;    ///< WxH; empty: the scene's
  std::string out;     ///< PNG file
  std::string backend = "osmesa";  ///< osmesa, egl or egl:N
  bool json = false;
};

/// `seaway render`: one picture of a scene, its vessels replayed up to the time.
int runRender(const RenderOptions& options, std::ostream& out);
void addRenderCommand(CLI::App& app, ChosenCommand& chosen);

}  // namespace seaway::bridge
