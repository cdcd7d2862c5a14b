#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "surface/hull/hydrostatics.h"
#include "surface/hull/triangle_mesh.h"
#include "surface/surface_sample.h"

namespace seaway {

/// How the water's push on a hull is worked out; tests/bench/hull_bench.cpp times each, `seaway
/// cost` sets errors beside it.
enum class LoadLevel {
  columns,      ///< vertical columns under the waterplane: long waves, crowds of hulls
  mesh,         ///< wet triangles, hydrostatic pressure below the actual surface
  meshDynamic,  ///< wet triangles, the waves' own pressure with it (Froude–Krylov, stretched)
};

/// Empirical coefficients of what pressure in undisturbed water does not tell. All ≥ 0.
struct HullCoefficients {
  /// Pressure ½ρ C uₙ|uₙ| on every wet panel, uₙ being its speed through the water along its
  /// normal: a plate across the flow has a drag coefficient of 2C.
  double formDrag = 0.5;
  /// Skin friction coefficient; else the ITTC 1957 line 0.075/(log₁₀ Re − 2)² by the hull's length.
  std::optional<double> skinFriction;
  /// Pressure ½ρ C uₙ² on panels that cut the surface and enter it; 0: off.
  double slamming = 0.0;
  /// As formDrag in air, on dry panels.
  double windDrag = 0.5;
  /// Radiation damping of heave, roll and pitch, parts of critical damping, relative to the water.
  double heaveDamping = 0.3, rollDamping = 0.1, pitchDamping = 0.3;
  /// Added mass in surge, sway, heave as parts of the mass; in roll, pitch, yaw of the moments of
  /// inertia. Ships have about 0.05, 0.8, 1.0, 0.2, 0.8, 0.5.
  std::array<double, 6> addedMass{};
};

/// A hull and what it weighs, in the body frame (x forward, y to port, z up, m).
struct HullSettings {
  LoadLevel level = LoadLevel::meshDynamic;
  double mass = 0.0;                ///< kg, > 0
  glm::dvec3 centreOfGravity{0.0};  ///< m
  glm::dvec3 gyradii{0.0};          ///< about x, y, z, m; 0: 0.35 beam, 0.25 and 0.25 length
  glm::ivec2 columns{20, 20};       ///< of level `columns`, along and across, ≥ 2 each
  /// Displacement known with z = 0 in the water, m³, which the mesh is calibrated to. Alone: its
  /// ratio to the mesh's own multiplies buoyancy (V, KB, BM of a Wigley hull of 800 triangles
  /// within 0.05 %, its waterplane 0.3 % too large). With `knownWaterplane`: see calibrated().
  std::optional<double> knownVolume;
  /// Area of the waterplane at z = 0, m²; needs knownVolume.
  std::optional<double> knownWaterplane;
  /// Shortest waves that count, m; empty: cutoffFor(length).
  std::optional<double> shortestWavelength;
  HullCoefficients coefficients;
};

/// One vertical column of a hull: wet between its ends.
struct MeshColumn {
  glm::dvec2 place{0.0};         ///< body frame, m
  double area = 0.0;             ///< m²
  double low = 0.0, high = 0.0;  ///< m
};

/// A hull ready for loads(). Immutable; const calls are thread-safe.
class HullModel {
 public:
  /// Throws InputError for a mesh that is not watertight (with what is wrong), a mass that is not
  /// above 0 or not finite, settings out of range, and a hull that would sink. A mesh that faces
  /// inwards is turned round.
  HullModel(TriangleMesh mesh, const HullSettings& settings);

  /// What a triangle needs at every step.
  struct Panel {
    TriangleMesh::Triangle corners;
    glm::dvec3 area{0.0};    ///< vector, m²
    glm::dvec3 normal{0.0};  ///< unit, 0 without area
    double size = 0.0;       ///< |area|
    glm::dvec3 middle{0.0};  ///< m
    /// Moment about the origin of a pressure of 1 at one corner, falling to 0 at the others, m³:
    /// (a + b + c + corner)/12 × area.
    std::array<glm::dvec3, 3> moments{};
    int probe = 0;  ///< where the water's velocity is taken for it
  };
  static constexpr int probesAlong = 8, probesAcross = 2, probes = probesAlong * probesAcross;

  const TriangleMesh& mesh() const { return mesh_; }
  const HullSettings& settings() const { return settings_; }
  const std::vector<Panel>& panels() const { return panels_; }
  const std::vector<MeshColumn>& columns() const { return columns_; }
  const std::array<glm::dvec3, probes>& probePlaces() const { return probePlaces_; }
  const MeshBounds& bounds() const { return bounds_; }
  double length() const { return bounds_.size().x; }  ///< m
  const glm::dvec3& gyradii() const { return gyradii_; }

  /// Buoyancy per buoyancy of the mesh.
  double volumeFactor() const { return volumeFactor_; }
  /// Waves that are left out, m.
  double shortestWavelength() const { return shortestWavelength_; }
  /// Upright at its draft in still sea water.
  const SubmergedPart& atRest() const { return atRest_; }
  double restHeight() const {
    return restHeight_;
  }  ///< of the body's origin over the water then, m

  /// Undamped natural frequencies at rest without added mass, rad/s: ω² = ρgA/m and mgGM/I; 0 where
  /// unstable.
  double heaveFrequency() const { return heaveFrequency_; }
  double rollFrequency() const { return rollFrequency_; }
  double pitchFrequency() const { return pitchFrequency_; }

  /// Radiation damping in heave (N·s/m), roll and pitch (N·m·s).
  const glm::dvec3& damping() const { return damping_; }
  /// Added mass: kg and kg·m², diagonal, about the centre of gravity.
  const std::array<double, 6>& addedMass() const { return addedMass_; }

  std::size_t memoryBytes() const;

 private:
  void setPanels();
  void setColumns();
  void setRest();

  TriangleMesh mesh_;
  HullSettings settings_;
  std::vector<Panel> panels_;
  std::vector<MeshColumn> columns_;
  std::array<glm::dvec3, probes> probePlaces_{};
  MeshBounds bounds_;
  glm::dvec3 gyradii_{0.0}, damping_{0.0};
  std::array<double, 6> addedMass_{};
  SubmergedPart atRest_;
  double volumeFactor_ = 1.0, shortestWavelength_ = 0.0, restHeight_ = 0.0;
  double heaveFrequency_ = 0.0, rollFrequency_ = 0.0, pitchFrequency_ = 0.0;
};

}  // namespace seaway
