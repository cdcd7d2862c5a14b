#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "render/camera.h"
#include "surface/terrain/terrain_map.h"

namespace seaway::render {

/// Which picture a terrain is for.
enum class TerrainSide {
  direct,    ///< as it stands
  mirrored,  ///< what is above the still water, z → −z
  below,     ///< depths divided by the index of refraction, as they appear from straight above
};

/// How much of a terrain a picture needs.
struct TerrainSelection {
  TerrainSide side = TerrainSide::direct;
  /// Most that the drawn ground is off the finest mesh's, in pixels of the picture. Where the still
  /// water's edge is, an eighth of it: on a flat beach the edge moves by more than the height.
  double tolerance = 0.7;
  double lowest = -1e30;  ///< m: ground that is nowhere higher than this is left out
  double highest = 1e30;  ///< m: and what is nowhere lower than this
};

/// Levels of detail of a terrain: right triangles that are halved where that shows (Lindstrom &
/// Pascucci 2001, "Visualization of large terrains made easy"), without cracks whatever the view.
///
/// Each height that halves two triangles has the largest error of not doing so, over all heights in
/// the two, and the highest of what would follow. A height is used where its error, seen
/// from the camera no farther away than any that would follow, is more than the tolerance. The
/// finest mesh has two triangles a cell; it differs from TerrainMap::heightAt by at most a quarter
/// of the cell's twist. Selecting does not depend on anything but map, camera and selection.
class TerrainLod {
 public:
  explicit TerrainLod(const TerrainMap& map);

  /// Appends triangles in the camera's view, three corners each, turning either way: x and y
  /// relative to the camera, z above the still water as the side shows it, m. Along the map's edges
  /// curtains reach 20 m below the still water.
  void select(const TerrainMap& map, const Camera& camera, const TerrainSelection& selection,
              std::vector<glm::vec3>& corners) const;

  /// Bounds of all errors at a height, m; by the height's number in the map.
  float errorAt(std::size_t index) const { return error_[index]; }
  int block() const { return block_; }  ///< side of the coarsest square, cells
  std::size_t memoryBytes() const { return (error_.capacity() + top_.capacity()) * sizeof(float); }

 private:
  void gatherLevel(const TerrainMap& map, int side, std::vector<std::uint8_t>& shore);
  void gather(const TerrainMap& map, glm::ivec2 middle, glm::ivec2 half, int childSide,
              bool childrenAreDiagonal, std::vector<std::uint8_t>& shore);

  int block_ = 1;
  std::vector<float> error_, top_;
};

/// Places of such corners relative to the camera, on the curved sea, m.
void bendToSea(const Camera& camera, std::vector<glm::vec3>& corners);

}  // namespace seaway::render
