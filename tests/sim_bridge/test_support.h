#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sim_bridge/scene/scene.h"

namespace seaway::bridge::test {

/// A fresh folder that goes with the object.
class TempFolder {
 public:
  TempFolder();
  ~TempFolder();
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

  /// Writes a file in the folder, making folders on the way; returns its path.
  std::filesystem::path write(const std::string& name, const std::string& text) const;

  /// Names of all files below the folder.
  std::vector<std::string> files() const;

 private:
  std::filesystem::path path_;
};

std::string readFile(const std::filesystem::path& file);

/// What a child process did.
struct Outcome {
  int status = -1;
  std::string out;
  std::string err;
};

/// Runs the `seaway` binary.
Outcome seaway(const std::vector<std::string>& arguments, const std::string& input = "");

/// Message of the InputError that `action` throws; empty where it throws none.
std::string inputErrorOf(const std::function<void()>& action);

/// A scene file's text: JONSWAP sea, a launch, a camera on it; small frames. `replacements` are
/// applied one after another and must each occur.
std::string sceneText(const std::vector<std::pair<std::string, std::string>>& replacements = {});

/// A vessel file's text, with replacements likewise.
std::string vesselText(const std::vector<std::pair<std::string, std::string>>& replacements = {});

/// Writes scene.yaml and launch.yaml into a folder; returns the scene's path.
std::filesystem::path writeScene(
    const TempFolder& folder,
    const std::vector<std::pair<std::string, std::string>>& replacements = {});

/// The same, but that the launch leaves no waves: the sea alone.
std::filesystem::path writeWakelessScene(
    const TempFolder& folder, std::vector<std::pair<std::string, std::string>> replacements = {});

}  // namespace seaway::bridge::test
