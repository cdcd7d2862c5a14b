#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "sim_bridge/commands/command.h"

namespace seaway::bridge {

struct RunOptions {
  std::string scene;
  std::string out;                 ///< folder; empty: out/SCENE
  std::optional<double> duration;  ///< s
  std::optional<double> framesPerSecond;
  std::string size;  ///< WxH
  std::optional<std::int64_t> seed;
  std::string backend = "osmesa";         ///< osmesa, egl or egl:N
  std::string checkpoint, resume;         ///< files; empty: none
  std::optional<double> checkpointEvery;  ///< s
  std::vector<std::string> also;          ///< words of frameFileKinds()
  std::string video;                      ///< MP4 file; empty: none
  int samples = 1;                        ///< a pixel's side
  bool json = false;
};

/// `seaway run`: sails a scene and writes telemetry.csv, frames/NNNNNN.png and summary.json.
///
/// Beside NNNNNN.png stand the files that `also` names, NNNNNN.json and the like. `video` is of the
/// first camera.
///
/// The first camera's frames stand in `frames/`, those of each further camera in `frames/NAME/`.
/// The output folder is checked before any work; files appear whole, summary.json last: a folder
/// that has one is complete. Exactly the files that an earlier run in the same folder lists in its
/// summary are removed first (RunFolder).
int runRun(const RunOptions& options, std::ostream& out);
void addRunCommand(CLI::App& app, ChosenCommand& chosen);

}  // namespace seaway::bridge
