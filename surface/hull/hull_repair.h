#pragma once

#include <memory>

#include "surface/hull/triangle_mesh.h"

namespace seaway {

struct RepairSettings {
  /// Side of the voxels that the hull is rebuilt from, m; 0: a 150th of its longest side.
  double voxelSize = 0.0;
  /// Widest hole to be closed, m; 0: four voxels.
  double widestHole = 0.0;
};

/// A watertight mesh of what `mesh` encloses: its distance field is taken on voxels (OpenVDB),
/// thickened until holes close, the outermost surface kept, and thinned again. Inner walls,
/// overlaps and the triangles' sense do not matter. Surfaces lie within half a voxel of the
/// original's; edges are rounded by that much, corners inside `widestHole` filled.
///
/// Throws InputError for settings that are not ≥ 0, for a mesh that still has a hole when thickened
/// (nothing is enclosed), and for more than 1000 voxels along the longest side.
TriangleMesh repaired(const TriangleMesh& mesh, const RepairSettings& settings = {});

/// Signed distance to a closed mesh, m, negative inside, on voxels up to `band` m from it; beyond,
/// ± band. Within half a voxel of the truth. Immutable, thread-safe.
class HullDistance {
 public:
  /// Throws InputError unless 0 < voxelSize < band and finite.
  HullDistance(const TriangleMesh& mesh, double voxelSize, double band);
  ~HullDistance();
  HullDistance(HullDistance&&) noexcept;
  HullDistance& operator=(HullDistance&&) noexcept;

  double at(const glm::dvec3& point) const;  ///< body frame, m
  std::size_t memoryBytes() const;

 private:
  struct Grid;
  std::unique_ptr<Grid> grid_;
};

}  // namespace seaway
