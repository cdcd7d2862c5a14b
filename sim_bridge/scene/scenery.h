#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "sim_bridge/scene/schema.h"
#include "surface/hull/coloured_mesh.h"
#include "surface/hull/hull_file.h"

namespace seaway::bridge {

/// Where a thing of the scenery has its mesh's origin.
struct SceneryPlace {
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
  double height = 0.0;  ///< m above the still-water level; of one that floats, above the water
};

/// A mesh that is no vessel: a pier, a buoy, a house. It takes no part in motion or wakes.
struct SceneryObject {
  std::string name;
  std::string meshPath;   ///< as in the scene
  HullFileSettings axes;  ///< unit and axes of the file
  double scale = 1.0;
  SceneryPlace place;
  double heading_deg = 0.0;  ///< true, of the mesh's forward axis
  double pitch_deg = 0.0;    ///< forward axis up
  double roll_deg = 0.0;     ///< right side down
  glm::vec3 colour{0.5f};    ///< linear reflectance of what has no colour in the file
  bool floats = false;  ///< rises and tilts with the waves that are longer than itself, massless
  std::shared_ptr<const ColouredMesh> mesh;  ///< read by the loader; shared by those of one file
};

/// Keys of an entry of `scenery`.
Mapping<SceneryObject> scenerySchema();

/// A scenery file's path, unit and axes, and its mesh once read: each file is read once.
class SceneryMeshes {
 public:
  /// Logs what of the file is not drawn. Throws InputError as readColouredMesh.
  std::shared_ptr<const ColouredMesh> read(const std::filesystem::path& file,
                                           const HullFileSettings& axes);

 private:
  struct Known {
    std::filesystem::path file;
    HullFileSettings axes;
    std::shared_ptr<const ColouredMesh> mesh;
  };
  std::vector<Known> known_;
};

}  // namespace seaway::bridge
