#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <set>
#include <span>
#include <vector>

#include "sim_bridge/service/plane_placer.h"
#include "sim_bridge/service/prepared_surface.h"
#include "sim_bridge/service/served_sea.h"
#include "sim_bridge/shm/host_sea.h"

namespace seaway::bridge::shm {

/// A served sea as a host of the shared memory asks it: values are the bits of
/// WaterSurface::sample. Geodetic points are placed by PlanePlacer, within 0.5 mm; their slopes and
/// velocities are turned to true east and north. Each request tells the sea who listens where, so
/// that wakes come; where they are not there at its time, its points say wakeOutOfTime.
class SeaHost : public HostSea {
 public:
  /// `sea` must outlive the host.
  explicit SeaHost(ServedSea& sea);
  ~SeaHost() override;

  void sample(const SampleAsked& asked, std::span<const double> x, std::span<const double> y,
              const SampleArrays& out) override;
  std::uint32_t addHull(std::uint32_t vessel) override;
  void placeHulls(double t, std::span<const seaway_shm_pose> poses) override;
  void removeHull(std::uint32_t hull) override;
  std::string describe() const override;
  std::optional<std::pair<double, double>> wakeSpan() const override { return sea_.wakeSpan(); }

 private:
  /// Points that are asked, by their coordinates as the host gives them.
  struct Points {
    std::span<const double> x, y;
  };
  void requireOwn(std::uint32_t hull) const;
  SampleStatus attend(double t, std::uint32_t hull, Points plane);
  Points placed(Points geodetic);
  void samplePlaced(const SampleAsked& asked, const SampleOptions& options, Points plane,
                    SampleStatus wakes, const SurfaceAtTime& water, const SampleArrays& out);

  ServedSea& sea_;
  PlanePlacer placer_;
  std::set<std::uint32_t> hulls_;
  PreparedSurface surface_;
  std::vector<PlacedPoint> places_;  // of geodetic points, as are x_ and y_
  std::vector<double> x_, y_;
};

/// What there is to ask, as JSON: scene, anchor, sea, vessels, cameras, wakes; lengths in m.
std::string describeSea(const ServedSea& sea);

}  // namespace seaway::bridge::shm
