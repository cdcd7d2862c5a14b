#pragma once

#include <array>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "surface/hull/hull_loads.h"
#include "surface/hull/wet_triangle.h"

/// The inside of loads(): hull_loads.h is the door.
namespace seaway {

inline constexpr double waterWeight = seaWaterDensity * standardGravity;  // N/m³

/// Sums of the body frame.
struct BodySums {
  Load buoyancy, drag, wind;
  double volume = 0.0, wetted = 0.0;

  /// Pressure that is linear over a panel: −∫ p n dA and −∫ p r × n dA.
  void press(const HullModel::Panel& panel, double pa, double pb, double pc) {
    buoyancy.force -= ((pa + pb + pc) * (1.0 / 3.0)) * panel.area;
    buoyancy.moment -= pa * panel.moments[0] + pb * panel.moments[1] + pc * panel.moments[2];
  }

  /// The same over a triangle.
  void press(const glm::dvec3& area, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
             double pa, double pb, double pc) {
    const double sum = pa + pb + pc;
    const glm::dvec3 arm = (sum * (a + b + c) + pa * a + pb * b + pc * c) * (1.0 / 12.0);
    buoyancy.force -= (sum / 3.0) * area;
    buoyancy.moment -= glm::cross(arm, area);
  }
};

/// One evaluation: what loads() and its parts share.
struct LoadWork {
  const HullModel& hull;
  const HullPose& pose;
  const SurfaceAtTime& water;
  LoadScratch& scratch;
  const LoadOptions& options;
  SampleOptions sampling;
  glm::dmat3 worldFromBody;
  glm::dmat3 bodyFromWorld;
  BodySums sums;
  HullLoads result;

  // The body's motion in its own axes, and the water's at the probes.
  glm::dvec3 velocity{0.0}, turning{0.0};
  std::array<glm::dvec3, HullModel::probes> flow{}, slip{};  // of the water, of the body in it
  std::array<double, HullModel::probes> rise{};              // of the water, m/s
  glm::dvec3 wind{0.0};
  double friction = 0.0;
  bool flows = false;

  LoadWork(const HullModel& itsHull, const HullPose& itsPose, const SurfaceAtTime& itsWater,
           LoadScratch& itsScratch, const LoadOptions& itsOptions)
      : hull(itsHull),
        pose(itsPose),
        water(itsWater),
        scratch(itsScratch),
        options(itsOptions),
        worldFromBody(glm::mat3_cast(itsPose.worldFromBody)),
        bodyFromWorld(glm::transpose(worldFromBody)) {
    sampling.shortestWavelength = options.shortestWavelength.value_or(hull.shortestWavelength());
    sampling.derivatives = false;
    sampling.excludeVessel = options.ownWake;
    velocity = bodyFromWorld * pose.velocity;
    turning = bodyFromWorld * pose.angularVelocity;
  }

  void resize(std::size_t points, bool slopes) {
    for (auto* values : {&scratch.x_, &scratch.y_, &scratch.depth_, &scratch.pressure_}) {
      values->resize(points);
    }
    for (auto* values : {&scratch.height_, &scratch.stretched_, &scratch.head_}) {
      values->resize(points);
    }
    scratch.slopeX_.resize(slopes ? points : 0);
    scratch.slopeY_.resize(slopes ? points : 0);
    scratch.change_.resize(disturbed() ? points : 0);
    scratch.place_.resize(points);
    scratch.wet_.resize(points);
  }

  /// Whether splashes, rain, ripples or layers change the surface.
  bool disturbed() const { return water.extras().events || water.extras().detail; }

  bool probeWater();
  bool submergeVertices();
  /// Heights (and slopes, where the scratch has them) of waves, wakes and all else at x, y.
  void sampleHeights();
  void addChanges();
  void tellShore();
  bool touchesGround(std::size_t count) const;
  void addDynamicPressure(std::size_t wet);
  void pressPanels();
  struct WetPart {
    double share, meanDepth;
  };
  WetPart pressCut(const HullModel::Panel& panel, const Wetness& wetness);
  void drag(const HullModel::Panel& panel, double wetPart, bool cut);
  void blow(const HullModel::Panel& panel, double dryPart);
  void pushColumns();
  void dragColumns();
  void radiate();
  HullLoads finish();
};

}  // namespace seaway
