#pragma once

#include <glm/vec2.hpp>
#include <string>

#include "sim_bridge/scene/scene.h"

namespace CLI {
class App;
}

namespace seaway::bridge {

/// How a camera's picture comes about, as commands take it.
struct LensOptions {
  std::string intrinsics;  ///< FX,FY,CX,CY of pictures of the size drawn; empty: the camera's own
  std::string distortion;  ///< K1,K2,P1,P2[,K3]; empty: the camera's own
  int samples = 1;         ///< a pixel's side
};

/// Adds `--intrinsics` and `--distortion`.
void addLensOptions(CLI::App& command, LensOptions& options);
/// Adds `--aa`.
void addSamplesOption(CLI::App& command, int& samples);

/// Puts what is given in place of the camera's own, and checks that pictures of `size` pixels can
/// be drawn so. Throws InputError.
void applyLens(const LensOptions& options, glm::ivec2 size, SceneCamera& camera);

}  // namespace seaway::bridge
