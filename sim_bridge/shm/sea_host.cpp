#include "sim_bridge/shm/sea_host.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "sim_bridge/service/listener_of.h"
#include "sim_bridge/service/wave_arrays.h"

namespace seaway::bridge::shm {
namespace {

// A host's status bits are the sample's own.
constexpr bool isBit(int bit, SampleStatus status) {
  return static_cast<std::uint32_t>(bit) == static_cast<std::uint32_t>(status);
}
static_assert(isBit(SEAWAY_SHM_POINT_TRUNCATED, SampleStatus::truncated));
static_assert(isBit(SEAWAY_SHM_POINT_NOT_FINITE, SampleStatus::notFinite));
static_assert(isBit(SEAWAY_SHM_POINT_OUT_OF_RANGE, SampleStatus::outOfRange));
static_assert(isBit(SEAWAY_SHM_POINT_NO_KINEMATICS, SampleStatus::noKinematics));
static_assert(isBit(SEAWAY_SHM_POINT_WAKE_OUT_OF_TIME, SampleStatus::wakeOutOfTime));
static_assert(isBit(SEAWAY_SHM_POINT_WAKE_PARTIAL, SampleStatus::wakePartial));
static_assert(isBit(SEAWAY_SHM_POINT_DRY, SampleStatus::dry));

void requireFinite(const char* what, double value) {
  if (std::isfinite(value)) return;
  throw Refused(SEAWAY_SHM_BAD_VALUE,
                std::string(what) + " of a hull's pose must be a finite number");
}

HostedPose checked(const seaway_shm_pose& pose) {
  requireFinite("latitude_deg", pose.latitude_deg);
  requireFinite("longitude_deg", pose.longitude_deg);
  requireFinite("height", pose.height);
  requireFinite("heading_deg", pose.heading_deg);
  requireFinite("pitch_deg", pose.pitch_deg);
  requireFinite("roll_deg", pose.roll_deg);
  return {pose.latitude_deg, pose.longitude_deg, pose.height,
          pose.heading_deg,  pose.pitch_deg,     pose.roll_deg};
}

}  // namespace

SeaHost::SeaHost(ServedSea& sea) : sea_(sea), placer_(sea.geodesy()) {}

SeaHost::~SeaHost() {
  for (const std::uint32_t hull : hulls_) sea_.removeHull(hull);
}

void SeaHost::requireOwn(std::uint32_t hull) const {
  if (hulls_.contains(hull)) return;
  throw Refused(SEAWAY_SHM_NOT_FOUND, "this host has no hull " + std::to_string(hull));
}

std::uint32_t SeaHost::addHull(std::uint32_t vessel) {
  constexpr std::size_t mostHulls = 256;
  if (hulls_.size() >= mostHulls) {
    throw Refused(SEAWAY_SHM_TOO_LARGE, "at most 256 hulls of a host");
  }
  const std::uint32_t hull = sea_.addHull(vessel);
  if (hull == 0) {
    const std::size_t count = sea_.scene()->vessels.size();
    throw Refused(SEAWAY_SHM_NOT_FOUND, "the scene has no vessel " + std::to_string(vessel) +
                                            "; it has " + std::to_string(count));
  }
  hulls_.insert(hull);
  return hull;
}

void SeaHost::placeHulls(double t, std::span<const seaway_shm_pose> poses) {
  if (!std::isfinite(t)) throw Refused(SEAWAY_SHM_BAD_VALUE, "the time of poses must be finite");
  for (const seaway_shm_pose& pose : poses) {
    requireOwn(pose.hull);
    checked(pose);
  }
  for (const seaway_shm_pose& pose : poses) {
    if (sea_.place(pose.hull, t, checked(pose))) continue;
    throw Refused(SEAWAY_SHM_BAD_VALUE,
                  "hull " + std::to_string(pose.hull) +
                      " stays: its time is not after its last, or its place is out of range");
  }
}

void SeaHost::removeHull(std::uint32_t hull) {
  requireOwn(hull);
  hulls_.erase(hull);
  sea_.removeHull(hull);
}

SeaHost::Points SeaHost::placed(Points geodetic) {
  const std::size_t count = geodetic.x.size();
  places_.resize(count);
  x_.resize(count);
  y_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    places_[i] = placer_.place(geodetic.y[i], geodetic.x[i]);
    x_[i] = places_[i].position.x;
    y_[i] = places_[i].position.y;
  }
  return {x_, y_};
}

SampleStatus SeaHost::attend(double t, std::uint32_t hull, Points plane) {
  const auto listener = listenerOf(plane.x, plane.y, t, hull);
  return listener ? sea_.attend(t, std::span(&*listener, 1)) : SampleStatus::ok;
}

void SeaHost::sample(const SampleAsked& asked, std::span<const double> x, std::span<const double> y,
                     const SampleArrays& out) {
  SampleOptions options;
  options.tolerance = asked.tolerance;
  options.shortestWavelength = asked.shortestWavelength;
  options.derivatives = asked.derivatives;
  options.orbitalVelocity = asked.orbitalVelocity;
  if (asked.ownHull != 0) {
    requireOwn(asked.ownHull);
    options.excludeVessel = sea_.ownWake(asked.ownHull);
  }
  const Points plane = asked.geodetic ? placed({x, y}) : Points{x, y};
  const SampleStatus wakes = attend(asked.time, options.excludeVessel, plane);
  const PreparedSurface::Use water(surface_, sea_.surface(), asked.time);
  if (!asked.geodetic && isPlain(*water, options)) {
    return sampleWaves<double>(*water, x, y, options, wakes,
                               {out.height, out.slopeEast, out.slopeNorth, out.verticalVelocity,
                                out.error, out.bound, out.status});
  }
  samplePlaced(asked, options, plane, wakes, *water, out);
}

namespace {

// Of a block: its samples stay in the first cache while arrays are written one after the other.
constexpr std::size_t block = 128;
using Samples = std::span<const SurfaceSample>;

void writeHeights(Samples samples, SampleStatus wakes, std::size_t to, const SampleArrays& out) {
  for (const SurfaceSample& sample : samples) {
    out.height[to] = sample.height;
    out.error[to] = sample.error;
    out.bound[to] = sample.bound;
    out.status[to++] = static_cast<std::uint32_t>(sample.status | wakes);
  }
}

/// `places` is empty where vectors lie along the plane's own axes.
void writeDerivatives(Samples samples, const PlacedPoint* places, std::size_t to,
                      const SampleArrays& out) {
  for (const SurfaceSample& sample : samples) {
    const glm::dvec2 slope = places ? places[to].trueFromPlane(sample.slope) : sample.slope;
    out.slopeEast[to] = slope.x;
    out.slopeNorth[to] = slope.y;
    out.verticalVelocity[to++] = sample.verticalVelocity;
  }
}

void writeOrbitalVelocities(Samples samples, const PlacedPoint* places, std::size_t to,
                            const SampleArrays& out) {
  for (const SurfaceSample& sample : samples) {
    const glm::dvec3 velocity = sample.orbitalVelocity;
    const glm::dvec2 level(velocity.x, velocity.y);
    const glm::dvec2 turned = places ? places[to].trueFromPlane(level) : level;
    out.orbitalEast[to] = turned.x;
    out.orbitalNorth[to] = turned.y;
    out.orbitalUp[to++] = velocity.z;
  }
}

}  // namespace

void SeaHost::samplePlaced(const SampleAsked& asked, const SampleOptions& options, Points plane,
                           SampleStatus wakes, const SurfaceAtTime& water,
                           const SampleArrays& out) {
  std::array<glm::dvec2, block> points;
  std::array<SurfaceSample, block> all;
  const PlacedPoint* places = asked.geodetic ? places_.data() : nullptr;
  for (std::size_t from = 0; from < plane.x.size(); from += block) {
    const std::size_t count = std::min(block, plane.x.size() - from);
    for (std::size_t i = 0; i < count; ++i) points[i] = {plane.x[from + i], plane.y[from + i]};
    const std::span<SurfaceSample> samples = std::span(all).first(count);
    water.sample(std::span(points).first(count), samples, options);
    writeHeights(samples, wakes, from, out);
    if (asked.derivatives) writeDerivatives(samples, places, from, out);
    if (asked.orbitalVelocity) writeOrbitalVelocities(samples, places, from, out);
  }
}

std::string SeaHost::describe() const { return describeSea(sea_); }

}  // namespace seaway::bridge::shm
