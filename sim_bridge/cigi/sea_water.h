#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <map>
#include <utility>
#include <vector>

#include "sim_bridge/cigi/water.h"
#include "sim_bridge/service/served_sea.h"
#include "surface/water_kinematics.h"

namespace seaway::bridge::cigi {

/// A served sea as CIGI's hosts ask it.
///
/// Points are taken into the sea plane: a geodetic one by its geodesic from the anchor, a point of
/// an entity by that of the entity and its offset turned by the grid's convergence there, which is
/// exact to the map's scale error (Geodesy) times the offset. What is dry, out of range or NaN is
/// not valid. Velocities are orbital ones and the current.
///
/// Waves that a host enables take the place of the scene's: each a regular wave of half its height
/// as amplitude, of its period, or, without one, its wavelength, in the scene's depth; the phase is
/// that at the anchor and the epoch. A wavelength that does not go with the period is passed over
/// with a warning, as are waves that are no field. Without any the scene's own sea comes back.
///
/// Entity 0 of a host is a hull of the scene's first vessel, 1 of its second, and so on: those make
/// wakes (ServedSea), which points of the entity itself do not feel.
///
/// For one thread at a time; several on one sea.
class SeaWater : public Water {
 public:
  explicit SeaWater(ServedSea& sea) : sea_(sea) {}

  void heights(double t, std::span<const WaterPoint> points, std::span<WaterHeight> out) override;
  void velocities(double t, std::span<const WaterPoint> points,
                  std::span<WaterVelocity> out) override;
  void wavesAsked(std::uint32_t host, double t, std::span<const HostWave> waves) override;
  void entitiesAt(std::uint32_t host, double t, std::span<const HostEntity> entities) override;
  void hostGone(std::uint32_t host) override;

 private:
  /// A geodetic position in the plane.
  struct Base {
    double latitude_deg = 0.0, longitude_deg = 0.0;
    glm::dvec2 position{0.0};
    glm::dvec2 turn{1.0, 0.0};  // cosine and sine of the convergence
  };
  /// Consecutive points that leave out the same hull's waves.
  struct Run {
    std::size_t from = 0, count = 0;
    std::uint32_t hull = 0;
  };
  using HullKey = std::pair<std::uint32_t, std::uint16_t>;  // host, entity

  const Base& baseOf(double latitude_deg, double longitude_deg);
  std::uint32_t hullOf(const WaterPoint& point) const;
  void place(std::span<const WaterPoint> points);
  void advanceWakes(double t);

  ServedSea& sea_;
  Base base_;
  bool baseKnown_ = false;
  std::map<HullKey, std::uint32_t> hulls_;
  std::vector<glm::dvec2> places_, turns_;
  std::vector<Run> runs_;
  std::vector<SurfaceSample> samples_;
  std::vector<glm::dvec3> points_;
  std::vector<WaterKinematics> motions_;
  std::vector<WakeListener> listeners_;
  bool warnedOfLength_ = false;
};

}  // namespace seaway::bridge::cigi
