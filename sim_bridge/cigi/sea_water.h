#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <map>
#include <utility>
#include <vector>

#include "sim_bridge/cigi/host_views.h"
#include "sim_bridge/cigi/water.h"
#include "sim_bridge/service/frame_maker.h"
#include "sim_bridge/service/plane_placer.h"
#include "sim_bridge/service/served_sea.h"
#include "surface/water_kinematics.h"

namespace seaway::bridge::cigi {

/// A served sea as CIGI's hosts ask it.
///
/// Points are taken into the sea plane by PlanePlacer, points of an entity from the entity's place:
/// within 2 mm of their geodesics for 100 m. What is dry, out of range or NaN is not valid.
/// Velocities are orbital ones and the current.
///
/// Waves that a host enables take the place of the scene's: each a regular wave of half its height
/// as amplitude, of its period, or, without one, its wavelength, in the scene's depth; the phase is
/// that at the anchor and the epoch. A wavelength that does not go with the period is passed over
/// with a warning, as are waves that are no field. Without any the scene's own sea comes back.
///
/// Entity 0 of a host is a hull of the scene's first vessel, 1 of its second, and so on: those are
/// seen in pictures and make wakes (ServedSea), which points of the entity itself do not feel. One
/// that is clamped floats on the water as it is in the mean under it.
///
/// A host's views of such entities are cameras `cigi:HOST:VIEW` of the FrameMaker, HOST counting
/// from 1 by arrival; what of a view's window lies off its axis is passed over with a warning.
///
/// For one thread at a time; several on one sea.
class SeaWater : public Water {
 public:
  /// Without `frames` views are passed over. What is given must outlive this object.
  explicit SeaWater(ServedSea& sea, FrameMaker* frames = nullptr);

  void heights(double t, std::span<const WaterPoint> points, std::span<WaterHeight> out) override;
  void velocities(double t, std::span<const WaterPoint> points,
                  std::span<WaterVelocity> out) override;
  void wavesAsked(std::uint32_t host, double t, std::span<const HostWave> waves) override;
  void entitiesAt(std::uint32_t host, double t, std::span<const HostEntity> entities) override;
  void hostGone(std::uint32_t host) override;
  void viewAsked(std::uint32_t host, const ViewControl& view) override;
  void viewDefined(std::uint32_t host, const ViewDefinition& view) override;

 private:
  /// Consecutive points that leave out the same hull's waves.
  struct Run {
    std::size_t from = 0, count = 0;
    std::uint32_t hull = 0;
  };
  using HullKey = std::pair<std::uint32_t, std::uint16_t>;  // host, entity

  const PlacedPoint& baseOf(double latitude_deg, double longitude_deg);
  std::uint32_t hullOf(const WaterPoint& point) const;
  void place(std::span<const WaterPoint> points);
  void attend(double t);
  void setCameras(std::uint32_t host);
  bool follow(std::uint32_t hull, double t, const HostEntity& entity);

  ServedSea& sea_;
  FrameMaker* frames_;
  std::map<std::uint32_t, HostViews> views_;
  PlanePlacer placer_;
  double latitude_deg_, longitude_deg_;  // of the base
  PlacedPoint base_;
  std::map<HullKey, std::uint32_t> hulls_;
  std::vector<glm::dvec2> places_;
  std::vector<PlacedPoint> bases_;
  std::vector<Run> runs_;
  std::vector<SurfaceSample> samples_;
  std::vector<glm::dvec3> points_;
  std::vector<WaterKinematics> motions_;
  std::vector<WakeListener> listeners_;
  bool warnedOfLength_ = false, warnedOfView_ = false;
};

}  // namespace seaway::bridge::cigi
