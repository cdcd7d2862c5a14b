#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>

#include "sim_bridge/scene/scene.h"

namespace CLI {
class App;
}

namespace seaway::bridge {

/// "640x480" as pixels. Throws InputError for anything else, and outside [1, 8192].
glm::ivec2 parseSize(const std::string& text);

/// "256x512" as columns and rows of a grid. Throws InputError, also outside [2, 4096].
glm::ivec2 parseGrid(const std::string& text);

/// A time given with `--time` to a command that sails vessels, which are known from the scene's
/// epoch on: finite, ≥ 0. Throws InputError.
double requireTime(double time);

/// A time given to a command that asks the sea alone, a function of any time before the epoch or
/// after: within WaveField::latest. Throws InputError.
double requireSeaTime(double time);

/// For options that name a file or folder: CLI11 takes an empty word for one.
std::string mustBeNamed(const std::string& path);

/// Puts `--model` (group or perlin) in place of the scene's `sea.model`. Throws InputError for any
/// other word, and where the scene lists its octaves, so that there is nothing to choose.
void overrideModel(Scene& scene, const std::string& model);

/// Adds `--backend`, the graphics context that draws; see render::makeHeadlessContext.
void addBackendOption(CLI::App& command, std::string& backend);

}  // namespace seaway::bridge
