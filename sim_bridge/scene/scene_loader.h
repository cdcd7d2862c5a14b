#pragma once

#include <filesystem>
#include <string>

#include "sim_bridge/scene/scene.h"
#include "sim_bridge/scene/schema.h"

namespace seaway::bridge {

/// Keys of a scene file.
const Mapping<Scene>& sceneSchema();

/// Reads a scene with the vessel and sea state files it names (paths relative to the scene's file).
///
/// Throws InputError — file, line, key, value and what is allowed — for anything the schema does
/// not allow, and for duplicate names, a mount that is no vessel of the scene, a camera both
/// mounted and fixed, a start or camera outside the geodesy's range, or a file that is missing.
/// Warns (spdlog) where a sea state file's octaves are not of the height its provenance tells.
Scene loadScene(const std::filesystem::path& file);

/// The same of a scene file's text, whose paths are relative to `folder`. Messages call the file
/// `FOLDER/<text>`.
Scene sceneFromText(const std::string& yaml, const std::filesystem::path& folder);

}  // namespace seaway::bridge
