#include <glm/geometric.hpp>
#include <limits>

#include "sim_bridge/capi/handles.h"
#include "sim_bridge/capi/point_blocks.h"
#include "sim_bridge/capi/sample_options.h"
#include "sim_bridge/output/number_text.h"
#include "surface/surface_ray.h"
#include "surface/water_kinematics.h"

namespace seaway::bridge::capi {
namespace {

constexpr seaway_motions noMotions{sizeof(seaway_motions),
                                   0,
                                   nullptr,
                                   nullptr,
                                   nullptr,
                                   nullptr,
                                   nullptr,
                                   nullptr,
                                   nullptr,
                                   nullptr,
                                   nullptr,
                                   nullptr};
constexpr seaway_ray_options rayDefaults{sizeof(seaway_ray_options), 0, 1e-4, 0.1, 100e3};

void put(double* out, std::size_t row, double value) {
  if (out) out[row] = value;
}

void write(const PointBlock& block, std::span<const WaterKinematics> motions,
           const seaway_points& points, const seaway_motions& out) {
  for (std::size_t i = 0; i < block.count; ++i) {
    const WaterKinematics& motion = motions[i];
    const std::size_t row = block.row(i);
    const glm::dvec2 velocity = block.along(i, glm::dvec2(motion.velocity));
    const glm::dvec2 acceleration = block.along(i, glm::dvec2(motion.acceleration));
    put(out.velocity_east, row, velocity.x);
    put(out.velocity_north, row, velocity.y);
    put(out.velocity_up, row, motion.velocity.z);
    put(out.acceleration_east, row, acceleration.x);
    put(out.acceleration_north, row, acceleration.y);
    put(out.acceleration_up, row, motion.acceleration.z);
    put(out.dynamic_pressure, row, motion.dynamicPressure);
    put(out.pressure, row, motion.pressure);
    put(out.surface_height, row, motion.surfaceHeight);
    if (out.status) out.status[row] = block.statusOf(i, motion.status, points);
  }
}

RayOptions rayOptionsOf(const seaway_ray_options& given) {
  requireThat(given.flat <= 1, "options.flat must be 0 or 1");
  requireThat(given.tolerance > 0.0, "options.tolerance must be > 0 m");
  requireThat(given.near_distance >= 0.0, "options.near_distance must be >= 0 m");
  requireThat(given.far_distance > given.near_distance && std::isfinite(given.far_distance),
              "options.far_distance must be finite and above near_distance");
  return {.tolerance = given.tolerance,
          .nearDistance = given.near_distance,
          .farDistance = given.far_distance,
          .curved = given.flat == 0};
}

double castRay(const SurfaceAtTime& water, const double* origin, const double* direction,
               const RayOptions& options) {
  const glm::dvec3 from(origin[0], origin[1], origin[2]);
  const glm::dvec3 along(direction[0], direction[1], direction[2]);
  const double length = glm::length(along);
  const bool sound = std::isfinite(from.x + from.y + from.z) && std::isfinite(length) &&
                     length > 0.0 && std::isfinite(water.time());
  if (!sound) return std::numeric_limits<double>::quiet_NaN();
  return distanceToWater(water, from, along / length, options)
      .value_or(std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace seaway::bridge::capi

using namespace seaway::bridge;
using namespace seaway::bridge::capi;

extern "C" {

void seaway_motions_init(seaway_motions* motions, size_t size) {
  initialise(motions, size, noMotions);
}
void seaway_ray_options_init(seaway_ray_options* options, size_t size) {
  initialise(options, size, rayDefaults);
}

seaway_status seaway_sea_sample_motion(const seaway_sea* handle, double time,
                                       const seaway_points* points, const double* height,
                                       const seaway_sample_options* given,
                                       const seaway_motions* out) {
  return guarded([&] {
    const CoupledSea& sea = seaOf(handle);
    requirePoints(points);
    if (points->count > 0) require(height, "height");
    requireStruct(out, "out");
    const PreparedWater prepared(sea, time);
    const seaway::SampleOptions options =
        sampleOptionsOf(sea, prepared.moment(), optionsOr(given, {}, "options"));
    thread_local std::array<glm::dvec3, pointsPerBlock> places;
    thread_local std::array<seaway::WaterKinematics, pointsPerBlock> motions;
    PointBlock& block = threadsBlock();
    PlanePlacer* placer = points->frame == SEAWAY_GEODETIC ? &placerOf(sea) : nullptr;
    for (std::size_t next = 0; next < points->count;) {
      next = fill(block, *points, next, points->count, placer);
      for (std::size_t i = 0; i < block.count; ++i) {
        places[i] = glm::dvec3(block.points[i], height[block.row(i)]);
      }
      const auto answers = std::span(motions).first(block.count);
      sampleKinematics(prepared.water(), std::span(places).first(block.count), answers, options);
      write(block, answers, *points, *out);
    }
  });
}

seaway_status seaway_sea_cast_rays(const seaway_sea* handle, double time, size_t count,
                                   const double* origins, const double* directions,
                                   const seaway_ray_options* given, double* distances) {
  return guarded([&] {
    const CoupledSea& sea = seaOf(handle);
    const seaway::RayOptions options = rayOptionsOf(optionsOr(given, rayDefaults, "options"));
    if (count == 0) return;
    require(origins, "origins");
    require(directions, "directions");
    require(distances, "distances");
    const PreparedWater prepared(sea, time);
    for (size_t i = 0; i < count; ++i) {
      distances[i] = castRay(prepared.water(), origins + 3 * i, directions + 3 * i, options);
    }
  });
}

}  // extern "C"
