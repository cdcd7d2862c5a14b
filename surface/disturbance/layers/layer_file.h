#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "surface/disturbance/layers/surface_layer.h"

namespace seaway {

/// One layer in a .vdb file.
struct LayerGrid {
  std::string name;                     ///< such as "foam"
  const SurfaceLayer* layer = nullptr;  ///< not null
};

/// Writes layers as they are at time `t` into an OpenVDB file that other tools read: for each a
/// float grid of its name (cover, [0, 1]) and one of its name and "_age" (s since it was left).
/// Grids are one voxel high, at the height 0 of the sea plane: x east, y north, metres, voxels as
/// large as cells, values at voxels' centres. `notes` go into the file's metadata. Throws
/// InputError where the file cannot be written.
void writeLayers(const std::filesystem::path& file, const std::vector<LayerGrid>& layers, double t,
                 const std::map<std::string, std::string>& notes = {});

/// What a file's grid looks like.
struct GridSummary {
  std::string name;
  std::string type;                   ///< of its values: "float", "double", "half"…
  std::uint64_t voxels = 0;           ///< active
  glm::dvec2 lower{0.0}, upper{0.0};  ///< of the active voxels, m
  double voxelSize = 0.0;             ///< m
};
/// Throws InputError for a file that is no OpenVDB file or is damaged.
std::vector<GridSummary> describeGrids(const std::filesystem::path& file);

/// Paints a grid of an OpenVDB file on `layer` at time `t`: active values in [0, 1], in the sea
/// plane's metres (x east, y north), of whatever voxel size; of voxels above one another the
/// largest counts. An empty `name` takes the file's only grid, or the first that holds floats where
/// one is called "density" or "cover". Throws InputError, naming file and grid, for a damaged file,
/// an unknown name, other values, a turned grid, and for more cells than the layer holds.
void readLayer(const std::filesystem::path& file, const std::string& name, double t,
               SurfaceLayer& layer);

}  // namespace seaway
