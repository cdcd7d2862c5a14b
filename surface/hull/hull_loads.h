#pragma once

#include <array>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "surface/hull/hull_model.h"
#include "surface/water_surface.h"

namespace seaway {

/// Density of air at 15 °C, kg/m³.
inline constexpr double airDensity = 1.225;

/// Where a hull is and how it moves, in the sea plane's axes.
struct HullPose {
  glm::dvec3 position{0.0};                      ///< of the body's origin, m
  glm::dquat worldFromBody{1.0, 0.0, 0.0, 0.0};  ///< unit
  glm::dvec3 velocity{0.0};                      ///< of the body's origin, m/s
  glm::dvec3 angularVelocity{0.0};               ///< rad/s
};

/// A force and its moment about the body's origin, in the sea plane's axes: N and N·m.
struct Load {
  glm::dvec3 force{0.0};
  glm::dvec3 moment{0.0};
};

/// What water and air do to a hull.
struct HullLoads {
  Load buoyancy;   ///< pressure of the undisturbed water: hydrostatic and, by level, the waves'
  Load drag;       ///< form and skin; slamming where it is switched on
  Load radiation;  ///< damping of heave, roll and pitch
  Load wind;

  /// All of these together.
  Load total() const {
    return {buoyancy.force + drag.force + radiation.force + wind.force,
            buoyancy.moment + drag.moment + radiation.moment + wind.moment};
  }

  /// Added mass now, diagonal in the body frame about the centre of gravity (kg, kg·m²), and the
  /// water's acceleration (m/s², sea plane) against which it acts: an integrator that knows of
  /// added mass solves (M + A) a = total + A a_water. Not in `total`.
  std::array<double, 6> addedMass{};
  glm::dvec3 waterAcceleration{0.0};

  double submergedVolume = 0.0;  ///< m³
  double wettedArea = 0.0;       ///< m², 0 at level `columns`
  double leftOut = 0.0;          ///< standard deviation of the height of the waves left out, m
  SampleStatus status = SampleStatus::ok;
};

/// What loads depend on besides hull, pose and water.
struct LoadOptions {
  /// Handle of the hull's own wake, 0 for none: it is not felt (SampleOptions::excludeVessel).
  std::uint32_t ownWake = 0;
  /// Velocity of the air, m/s (east, north); empty: no wind loads.
  std::optional<glm::dvec2> wind = {};
  /// Overrides the hull's own, m: 0 keeps all waves.
  std::optional<double> shortestWavelength = {};
};

/// Working memory of loads(): one for each thread, or each hull. Grows at first use, then stays.
class LoadScratch {
 public:
  /// Bytes it holds.
  std::size_t memoryBytes() const;

 private:
  friend HullLoads loads(const HullModel&, const HullPose&, const WaterSurface&, double,
                         LoadScratch&, const LoadOptions&);
  friend struct LoadWork;
  std::optional<SurfaceAtTime> water_;
  std::vector<double> x_, y_, depth_, pressure_;
  std::vector<float> height_, slopeX_, slopeY_, stretched_, head_;
  std::vector<float> change_;  // of heights by splashes, rain, ripples and layers
  std::vector<glm::dvec2> place_;
  std::vector<std::uint32_t> wet_;
};

/// Loads on a hull at time `t`.
///
/// Levels `mesh` and `meshDynamic` sample the sea at the mesh's vertices, cut triangles where the
/// linearly interpolated depth is 0 and integrate pressure that is linear over what is wet, 0 at
/// the waterline: exact for the polyhedron in still water. `mesh` takes ρg times the depth below
/// the surface straight above; `meshDynamic` adds what waves change below the surface, linear with
/// Wheeler's stretching (see sampleKinematics). `columns` pushes each column up the surface's
/// normal. Water motion for drag and damping is taken at 16 probes spread over the hull at half its
/// draft.
///
/// Waves shorter than the hull's cut-off are left out; HullLoads::leftOut says how much. A hull
/// does not disturb the water. Splashes, rain, ripples and what layers damp are felt at the
/// surface, below it as fast as waves of 2 m die down. Shores are told, not felt: where a vertex is
/// outside the outline the sea is taken to go on, and the status has `dry`; where one is below the
/// bed, pressure grows on as in the water, and the status has `belowBed`. A pose or time that is
/// not finite gives NaN and `notFinite`; Perlin octaves have no pressure or motion below the
/// surface: hydrostatic pressure then, and `noKinematics`; where a trough falls to the bed, NaN and
/// `belowBed`.
///
/// The same bits for the same input on any thread. Allocates only while `scratch` grows.
HullLoads loads(const HullModel& hull, const HullPose& pose, const WaterSurface& water, double t,
                LoadScratch& scratch, const LoadOptions& options = {});

/// The same in water already prepared: cheaper for several hulls at one time.
HullLoads loads(const HullModel& hull, const HullPose& pose, const SurfaceAtTime& water,
                LoadScratch& scratch, const LoadOptions& options = {});

/// A hull among others.
struct PlacedHull {
  const HullModel* model = nullptr;
  HullPose pose;
  LoadOptions options;
};

/// Loads on many hulls, in the caller's oneTBB arena: the same bits as one by one. `out` and
/// `scratch` have the size of `hulls`. Thread-safe for distinct `scratch`.
void loadsInParallel(std::span<const PlacedHull> hulls, const SurfaceAtTime& water,
                     std::span<HullLoads> out, std::span<LoadScratch> scratch);

}  // namespace seaway
