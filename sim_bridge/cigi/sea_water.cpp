#include "sim_bridge/cigi/sea_water.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>

#include "surface/angles.h"
#include "surface/dispersion.h"
#include "surface/input_error.h"

namespace seaway::bridge::cigi {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A wavelength may differ by this part from the one that its period has before it is told.
constexpr double lengthTolerance = 0.05;

bool isWater(SampleStatus status) {
  return !has(status, SampleStatus::notFinite) && !has(status, SampleStatus::outOfRange) &&
         !has(status, SampleStatus::dry);
}

double frequencyOf(const HostWave& wave, double depth) {
  if (wave.period > 0.0) return 1.0 / wave.period;
  return angularFrequency(2.0 * pi / wave.wavelength, depth) / (2.0 * pi);
}

/// Whether a wave's length goes with its period; one of them alone always does.
bool isConsistent(const HostWave& wave, double depth) {
  if (!(wave.period > 0.0) || !(wave.wavelength > 0.0)) return true;
  const double length = 2.0 * pi / waveNumber(2.0 * pi / wave.period, depth);
  return std::abs(wave.wavelength / length - 1.0) <= lengthTolerance;
}

std::string cameraName(std::uint32_t host, std::uint16_t view) {
  return "cigi:" + std::to_string(host) + ":" + std::to_string(view);
}

/// The window of a view whose middle the eye does not look at, in a picture of any size: what
/// counts are its edges.
SceneIntrinsics windowOf(const HostView& view) {
  const glm::ivec2 size(1024);
  const double left = std::tan(radiansFromDegrees(view.left_deg));
  const double right = std::tan(radiansFromDegrees(view.right_deg));
  const double bottom = std::tan(radiansFromDegrees(view.bottom_deg));
  const double top = std::tan(radiansFromDegrees(view.top_deg));
  render::Intrinsics pixels;
  pixels.fx = size.x / (right - left);
  pixels.fy = size.y / (top - bottom);
  // The picture begins half a pixel before the middle of its first.
  pixels.cx = -0.5 - pixels.fx * left;
  pixels.cy = -0.5 + pixels.fy * top;
  return {pixels, size};
}

}  // namespace

SeaWater::SeaWater(ServedSea& sea, FrameMaker* frames)
    : sea_(sea), frames_(frames), placer_(sea.geodesy()), latitude_deg_(nan), longitude_deg_(nan) {}

const PlacedPoint& SeaWater::baseOf(double latitude_deg, double longitude_deg) {
  if (latitude_deg_ != latitude_deg || longitude_deg_ != longitude_deg) {
    base_ = placer_.place(latitude_deg, longitude_deg);
    latitude_deg_ = latitude_deg;
    longitude_deg_ = longitude_deg;
  }
  return base_;
}

std::uint32_t SeaWater::hullOf(const WaterPoint& point) const {
  if (point.host == 0 || hulls_.empty()) return 0;
  const auto found = hulls_.find({point.host, point.entity});
  if (found == hulls_.end()) return 0;
  return sea_.ownWake(found->second);
}

void SeaWater::place(std::span<const WaterPoint> points) {
  places_.clear();
  bases_.clear();
  runs_.clear();
  for (const WaterPoint& point : points) {
    const PlacedPoint& base = baseOf(point.latitude_deg, point.longitude_deg);
    const std::uint32_t hull = hullOf(point);
    if (runs_.empty() || runs_.back().hull != hull) runs_.push_back({places_.size(), 0, hull});
    ++runs_.back().count;
    places_.push_back(base.position + base.planeFromTrue({point.east, point.north}));
    bases_.push_back(base);
  }
}

void SeaWater::attend(double t) {
  listeners_.clear();
  for (const Run& run : runs_) {
    glm::dvec2 least(std::numeric_limits<double>::infinity()), most = -least;
    for (std::size_t i = run.from; i < run.from + run.count; ++i) {
      if (!WaveField::serves(places_[i], t)) continue;
      least = glm::min(least, places_[i]);
      most = glm::max(most, places_[i]);
    }
    if (least.x > most.x) continue;
    listeners_.push_back({0.5 * (least + most), 0.5 * glm::length(most - least), run.hull});
  }
  sea_.attend(t, listeners_);
}

void SeaWater::heights(double t, std::span<const WaterPoint> points, std::span<WaterHeight> out) {
  place(points);
  attend(t);
  samples_.resize(points.size());
  const auto surface = sea_.surface();
  for (const Run& run : runs_) {
    surface->sample(std::span(places_).subspan(run.from, run.count), t,
                    std::span(samples_).subspan(run.from, run.count), {.excludeVessel = run.hull});
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SurfaceSample& sample = samples_[i];
    const glm::dvec2 slope = bases_[i].trueFromPlane(sample.slope);
    const bool valid = isWater(sample.status) && std::isfinite(sample.height);
    out[i] = {sample.height, slope.x, slope.y, valid};
  }
}

void SeaWater::velocities(double t, std::span<const WaterPoint> points,
                          std::span<WaterVelocity> out) {
  place(points);
  attend(t);
  const auto surface = sea_.surface();
  const glm::dvec2 current = surface->waves().settings().current;
  points_.clear();
  for (std::size_t i = 0; i < points.size(); ++i) {
    points_.emplace_back(places_[i], points[i].height);
  }
  motions_.resize(points.size());
  const SurfaceAtTime now = surface->at(std::isfinite(t) ? t : 0.0);
  for (const Run& run : runs_) {
    sampleKinematics(now, std::span(points_).subspan(run.from, run.count),
                     std::span(motions_).subspan(run.from, run.count), {.excludeVessel = run.hull});
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const WaterKinematics& motion = motions_[i];
    const glm::dvec2 level =
        bases_[i].trueFromPlane(glm::dvec2(motion.velocity.x, motion.velocity.y) + current);
    const bool ashore = (now.outline() && !now.outline()->contains(places_[i])) ||
                        (now.terrain() && !(motion.surfaceHeight > now.bedAt(places_[i])));
    const bool valid = std::isfinite(t) && !ashore && isWater(motion.status) &&
                       std::isfinite(level.x) && std::isfinite(motion.velocity.z);
    out[i] = {motion.surfaceHeight, {level.x, level.y, motion.velocity.z}, valid};
  }
}

void SeaWater::wavesAsked(std::uint32_t, double, std::span<const HostWave> waves) {
  if (waves.empty()) return sea_.restoreOctaves();
  const double depth = sea_.scene()->sea.depth;
  std::vector<Octave> octaves;
  for (const HostWave& wave : waves) {
    if (!isConsistent(wave, depth) && !std::exchange(warnedOfLength_, true)) {
      spdlog::warn(
          "CIGI: a wave of {} s is not {} m long in this depth: the period counts; more of these "
          "are not told",
          wave.period, wave.wavelength);
    }
    const double toward = sea_.geodesy().directionFromTrueHeading({0.0, 0.0}, wave.toward_deg);
    octaves.push_back(makeRegularWave(0.5 * wave.height, frequencyOf(wave, depth), toward,
                                      radiansFromDegrees(wave.phase_deg), depth));
  }
  try {
    sea_.setOctaves(std::move(octaves));
  } catch (const InputError& fault) {
    spdlog::warn("CIGI: the sea stays as it was; a host's waves are no field: {}", fault.what());
  }
}

bool SeaWater::follow(std::uint32_t hull, double t, const HostEntity& entity) {
  HostedPose pose{entity.place.latitude_deg, entity.place.longitude_deg, entity.height,
                  entity.heading_deg,        entity.pitch_deg,           entity.roll_deg};
  if (entity.clamp == 0) return sea_.place(hull, t, pose);
  const PlacedPoint& base = baseOf(pose.latitude_deg, pose.longitude_deg);
  const bool serves = WaveField::serves(base.position, t) && std::isfinite(pose.heading_deg);
  if (!serves) return false;
  const double direction = sea_.geodesy().directionFromTrueHeading(base.position, pose.heading_deg);
  const VesselPose afloat = sea_.afloat(entity.entity, base.position, direction, t);
  pose.height += afloat.height;
  if (entity.clamp > 1) {
    pose.pitch_deg += degreesFromRadians(afloat.pitch);
    pose.roll_deg += degreesFromRadians(afloat.roll);
  }
  return sea_.place(hull, t, pose);
}

void SeaWater::entitiesAt(std::uint32_t host, double t, std::span<const HostEntity> entities) {
  std::set<std::uint16_t> present;
  for (const HostEntity& entity : entities) {
    const HullKey key{host, entity.entity};
    auto hull = hulls_.find(key);
    if (hull == hulls_.end()) {
      const std::uint32_t made = sea_.addHull(entity.entity);
      if (made == 0) continue;
      hull = hulls_.emplace(key, made).first;
      if (views_.contains(host)) setCameras(host);
    }
    present.insert(entity.entity);
    follow(hull->second, t, entity);  // before the epoch without a trail: HostedTrails
  }
  std::erase_if(hulls_, [&](const auto& entry) {
    const bool gone = entry.first.first == host && !present.contains(entry.first.second);
    if (gone) sea_.removeHull(entry.second);
    return gone;
  });
}

void SeaWater::viewAsked(std::uint32_t host, const ViewControl& view) {
  if (!frames_) return;
  views_[host].set(view);
  setCameras(host);
}

void SeaWater::viewDefined(std::uint32_t host, const ViewDefinition& view) {
  if (!frames_) return;
  if (!views_[host].set(view) && !std::exchange(warnedOfView_, true)) {
    spdlog::warn("CIGI: a View Definition is passed over: orthographic, mirrored, or too wide");
  }
  setCameras(host);
}

void SeaWater::setCameras(std::uint32_t host) {
  const auto scene = sea_.scene();
  for (const auto& [number, view] : views_[host].views()) {
    const std::string name = cameraName(host, number);
    const auto hull = hulls_.find({host, view.entity});
    if (!view.placed || view.entity >= scene->vessels.size()) {
      frames_->setCamera(name, std::nullopt);
      continue;
    }
    SceneCamera camera;
    camera.name = name;
    camera.mount = scene->vessels[view.entity].name;
    camera.position = {view.x, -view.y, -view.z};
    camera.yaw_deg = view.yaw_deg;
    camera.pitch_deg = view.pitch_deg;
    camera.roll_deg = view.roll_deg;
    camera.fieldOfView_deg = view.top_deg - view.bottom_deg;
    if (!view.isCentred()) camera.intrinsics = windowOf(view);
    frames_->setCamera(name, camera, hull == hulls_.end() ? 0 : hull->second);
  }
}

void SeaWater::hostGone(std::uint32_t host) {
  if (const auto gone = views_.extract(host)) {
    for (const auto& [number, view] : gone.mapped().views()) {
      frames_->setCamera(cameraName(host, number), std::nullopt);
    }
  }
  std::erase_if(hulls_, [&](const auto& entry) {
    if (entry.first.first != host) return false;
    sea_.removeHull(entry.second);
    return true;
  });
}

}  // namespace seaway::bridge::cigi
