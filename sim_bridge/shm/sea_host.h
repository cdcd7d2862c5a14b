#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <set>
#include <span>
#include <vector>

#include "sim_bridge/service/plane_placer.h"
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
  void requireOwn(std::uint32_t hull) const;
  void place(const SampleAsked& asked, std::span<const double> x, std::span<const double> y);
  SampleStatus attend(double t, std::uint32_t hull);
  void write(const SampleAsked& asked, SampleStatus wakes, const SampleArrays& out) const;
  void writeDerivatives(const SampleAsked& asked, std::size_t from, std::size_t to,
                        const SampleArrays& out) const;
  void writeOrbitalVelocities(const SampleAsked& asked, std::size_t from, std::size_t to,
                              const SampleArrays& out) const;

  ServedSea& sea_;
  PlanePlacer placer_;
  std::set<std::uint32_t> hulls_;
  std::vector<glm::dvec2> points_;
  std::vector<PlacedPoint> places_;  // of geodetic points
  std::vector<SurfaceSample> samples_;
};

/// What there is to ask, as JSON: scene, anchor, sea, vessels, cameras, wakes; lengths in m.
std::string describeSea(const ServedSea& sea);

}  // namespace seaway::bridge::shm
