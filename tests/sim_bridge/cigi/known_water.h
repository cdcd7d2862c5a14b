#pragma once

#include <cmath>
#include <vector>

#include "sim_bridge/cigi/water.h"

namespace seaway::bridge::cigi::test {

/// Water that rises with time and latitude and slopes evenly: answers are known in closed form.
/// West of Greenwich there is none.
class KnownWater : public Water {
 public:
  static double elevationAt(double t, double latitude_deg, double north) {
    return 0.5 + 0.25 * t + 0.125 * latitude_deg + slopeNorth * north;
  }
  static constexpr double slopeEast = 0.0;
  static constexpr double slopeNorth = 0.5;
  static constexpr double speedEast = 2.0;

  void heights(double t, std::span<const WaterPoint> points, std::span<WaterHeight> out) override {
    ++batches;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const WaterPoint& p = points[i];
      const bool valid = std::isfinite(p.latitude_deg) && p.longitude_deg >= 0.0 &&
                         std::abs(p.latitude_deg) <= 90.0 && std::isfinite(t);
      out[i] = {elevationAt(t, p.latitude_deg, p.north), slopeEast, slopeNorth, valid};
    }
    if (!points.empty()) lastPoint = points.back();
  }

  void velocities(double t, std::span<const WaterPoint> points,
                  std::span<WaterVelocity> out) override {
    ++batches;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const WaterPoint& p = points[i];
      const double elevation = elevationAt(t, p.latitude_deg, p.north);
      out[i] = {elevation, {speedEast, p.height, 0.25}, p.height <= elevation};
    }
  }

  void wavesAsked(std::uint32_t, double, std::span<const HostWave> asked) override {
    waves.assign(asked.begin(), asked.end());
    ++waveChanges;
  }
  void entitiesAt(std::uint32_t, double t, std::span<const HostEntity> placed) override {
    entities.assign(placed.begin(), placed.end());
    entityTimes.push_back(t);
  }
  void viewAsked(std::uint32_t, const ViewControl& view) override { views.push_back(view); }
  void viewDefined(std::uint32_t, const ViewDefinition& view) override {
    definitions.push_back(view);
  }
  void hostGone(std::uint32_t host) override { gone.push_back(host); }

  int batches = 0;
  int waveChanges = 0;
  WaterPoint lastPoint;
  std::vector<HostWave> waves;
  std::vector<HostEntity> entities;
  std::vector<double> entityTimes;
  std::vector<ViewControl> views;
  std::vector<ViewDefinition> definitions;
  std::vector<std::uint32_t> gone;
};

}  // namespace seaway::bridge::cigi::test
