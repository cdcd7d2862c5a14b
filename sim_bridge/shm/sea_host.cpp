#include "sim_bridge/shm/sea_host.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

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

void SeaHost::place(const SampleAsked& asked, std::span<const double> x,
                    std::span<const double> y) {
  points_.resize(x.size());
  places_.resize(asked.geodetic ? x.size() : 0);
  if (!asked.geodetic) {
    for (std::size_t i = 0; i < x.size(); ++i) points_[i] = {x[i], y[i]};
    return;
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    places_[i] = placer_.place(y[i], x[i]);
    points_[i] = places_[i].position;
  }
}

SampleStatus SeaHost::attend(double t, std::uint32_t hull) {
  if (!std::isfinite(t)) return SampleStatus::ok;
  glm::dvec2 least(std::numeric_limits<double>::infinity()), most = -least;
  for (const glm::dvec2 point : points_) {
    // NaN is neither less nor more.
    least = glm::min(least, point);
    most = glm::max(most, point);
  }
  if (!WaveField::serves(least, t) || !WaveField::serves(most, t)) {
    // Some are too far, or none is anywhere: without those.
    least = glm::dvec2(std::numeric_limits<double>::infinity()), most = -least;
    for (const glm::dvec2 point : points_) {
      if (!WaveField::serves(point, t)) continue;
      least = glm::min(least, point);
      most = glm::max(most, point);
    }
    if (least.x > most.x) return SampleStatus::ok;
  }
  const WakeListener listener{0.5 * (least + most), 0.5 * glm::length(most - least), hull};
  return sea_.attend(t, std::span(&listener, 1));
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
  place(asked, x, y);
  const SampleStatus wakes = attend(asked.time, options.excludeVessel);
  samples_.resize(points_.size());
  sea_.surface()->sample(points_, asked.time, samples_, options);
  write(asked, wakes, out);
}

void SeaHost::write(const SampleAsked& asked, SampleStatus wakes, const SampleArrays& out) const {
  // Each block stays in the first cache while its arrays are written one after the other.
  constexpr std::size_t block = 128;
  for (std::size_t from = 0; from < samples_.size(); from += block) {
    const std::size_t to = std::min(from + block, samples_.size());
    for (std::size_t i = from; i < to; ++i) {
      out.height[i] = samples_[i].height;
      out.error[i] = samples_[i].error;
      out.bound[i] = samples_[i].bound;
      out.status[i] = static_cast<std::uint32_t>(samples_[i].status | wakes);
    }
    if (asked.derivatives) writeDerivatives(asked, from, to, out);
    if (asked.orbitalVelocity) writeOrbitalVelocities(asked, from, to, out);
  }
}

void SeaHost::writeDerivatives(const SampleAsked& asked, std::size_t from, std::size_t to,
                               const SampleArrays& out) const {
  for (std::size_t i = from; i < to; ++i) {
    const SurfaceSample& sample = samples_[i];
    const glm::dvec2 slope = asked.geodetic ? places_[i].trueFromPlane(sample.slope) : sample.slope;
    out.slopeEast[i] = slope.x;
    out.slopeNorth[i] = slope.y;
    out.verticalVelocity[i] = sample.verticalVelocity;
  }
}

void SeaHost::writeOrbitalVelocities(const SampleAsked& asked, std::size_t from, std::size_t to,
                                     const SampleArrays& out) const {
  for (std::size_t i = from; i < to; ++i) {
    const glm::dvec3 velocity = samples_[i].orbitalVelocity;
    const glm::dvec2 level(velocity.x, velocity.y);
    const glm::dvec2 turned = asked.geodetic ? places_[i].trueFromPlane(level) : level;
    out.orbitalEast[i] = turned.x;
    out.orbitalNorth[i] = turned.y;
    out.orbitalUp[i] = velocity.z;
  }
}

std::string SeaHost::describe() const { return describeSea(sea_); }

}  // namespace seaway::bridge::shm
