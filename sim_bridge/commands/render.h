#pragma once

#include <iosfwd>
#include <optional>
#include <string>

#include "sim_bridge/commands/command.h"
#include "sim_bridge/commands/lens_options.h"

namespace seaway::bridge {

struct RenderOptions {
  std::string scene;
  double time = 0.0;   ///< s
  std::string camera;  ///< empty: the scene's first
  std::string from;    ///< LAT,LON,HEIGHT of a camera of one's own; empty: one of the scene's
  std::optional<double> yaw_deg, pitch_deg, roll_deg, fieldOfView_deg;  ///< of such a camera
  std::string size;                                                     ///< WxH; empty: the scene's
  std::string out;                                                      ///< PNG file
  std::string depth, normals, radiance;                                 ///< EXR files; empty: none
  std::string labels;                                                   ///< PNG file; empty: none
  std::string frameJson;                                                ///< JSON file; empty: none
  LensOptions lens;
  std::string technique = "projected_grid";
  std::string variant = "automatic";
  std::string grid;                ///< COLUMNSxROWS; empty: the scene's
  std::string compare;             ///< technique to compare with; empty: none
  std::string backend = "osmesa";  ///< osmesa, egl or egl:N
  bool stats = false;              ///< draw twice, time the second, print as JSON
  bool json = false;
};

/// `seaway render`: one picture of a scene, its vessels replayed up to the time.
int runRender(const RenderOptions& options, std::ostream& out);
void addRenderCommand(CLI::App& app, ChosenCommand& chosen);

}  // namespace seaway::bridge
