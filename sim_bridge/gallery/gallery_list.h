#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim_bridge/scene/scene.h"

namespace seaway::bridge {

/// One picture of a gallery: a scene, who looks and when.
struct GalleryPicture {
  std::string name;       ///< of its files
  std::string scenePath;  ///< relative to the list
  std::string camera;     ///< one of the scene's; empty: `from` says
  std::optional<CameraPlace> from;
  double yaw_deg = 0.0, pitch_deg = 0.0, roll_deg = 0.0, fieldOfView_deg = 60.0;  ///< of `from`
  double time = 0.0;                                                              ///< s
  glm::ivec2 size{960, 540};
  std::string technique = "projected_grid";
  std::string variant = "automatic";
  std::string caption;
};

struct Gallery {
  std::filesystem::path file;
  std::vector<GalleryPicture> pictures;

  std::filesystem::path sceneOf(const GalleryPicture& picture) const {
    return file.parent_path() / picture.scenePath;
  }
};

/// Reads a list such as configs/gallery.yaml: key `pictures`. Throws InputError with file, line and
/// key, also where a name comes twice, or neither or both of `camera` and `from` are given; scenes
/// themselves are not looked at.
Gallery loadGallery(const std::filesystem::path& file);

/// The command that draws a picture of the gallery, with `seaway` as the program.
std::string commandOf(const Gallery& gallery, const GalleryPicture& picture);

}  // namespace seaway::bridge
