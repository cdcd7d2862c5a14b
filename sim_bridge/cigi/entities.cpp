#include "sim_bridge/cigi/entities.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "surface/angles.h"

namespace seaway::bridge::cigi {
namespace {

constexpr std::uint8_t active = 1;
constexpr std::uint8_t destroyed = 2;
constexpr int deepestAttachment = 8;
constexpr double longestStep = 10.0;  // s

// WGS84.
constexpr double semiMajorAxis = 6378137.0;
constexpr double squaredEccentricity = 6.69437999014e-3;

// Columns: north, east and down in east, north, up.
const glm::dmat3 enuFromNed(glm::dvec3(0, 1, 0), glm::dvec3(1, 0, 0), glm::dvec3(0, 0, -1));

/// A step of a body at a steady rate: along its path's chord, so that a steady turn stays a circle.
void step(EntityPosition& at, const RateControl& rate, double dt) {
  const double yaw = at.yaw + 0.5 * dt * rate.yaw;
  const double pitch = at.pitch + 0.5 * dt * rate.pitch;
  const double roll = at.roll + 0.5 * dt * rate.roll;
  glm::dvec3 moved = dt * glm::dvec3(rate.x, rate.y, rate.z);
  if (rate.bodyAxes) moved = nedFromBody(yaw, pitch, roll) * moved;
  at.yaw = static_cast<float>(std::remainder(at.yaw + dt * rate.yaw, 360.0));
  at.pitch = static_cast<float>(std::remainder(at.pitch + dt * rate.pitch, 360.0));
  at.roll = static_cast<float>(std::remainder(at.roll + dt * rate.roll, 360.0));
  if (at.attached) {
    at.latitude += moved.x, at.longitude += moved.y, at.altitude += moved.z;
    return;
  }
  const double sine = std::sin(radiansFromDegrees(at.latitude));
  const double w2 = 1.0 - squaredEccentricity * sine * sine;
  const double n = semiMajorAxis / std::sqrt(w2);
  const double m = n * (1.0 - squaredEccentricity) / w2;
  const double cosine = std::max(std::sqrt(1.0 - sine * sine), 1e-9);
  at.latitude += degreesFromRadians(moved.x / m);
  at.longitude += degreesFromRadians(moved.y / (n * cosine));
  at.altitude -= moved.z;
}

}  // namespace

glm::dmat3 nedFromBody(double yaw_deg, double pitch_deg, double roll_deg) {
  const double yaw = radiansFromDegrees(yaw_deg);
  const double pitch = radiansFromDegrees(pitch_deg);
  const double roll = radiansFromDegrees(roll_deg);
  const double cy = std::cos(yaw), sy = std::sin(yaw);
  const double cp = std::cos(pitch), sp = std::sin(pitch);
  const double cr = std::cos(roll), sr = std::sin(roll);
  return {{cy * cp, sy * cp, -sp},
          {cy * sp * sr - sy * cr, sy * sp * sr + cy * cr, cp * sr},
          {cy * sp * cr + sy * sr, sy * sp * cr - cy * sr, cp * cr}};
}

void Entities::set(const EntityControl& control, bool withPosition) {
  if (control.state == destroyed) {
    const auto found = entities_.find(control.entity);
    if (found == entities_.end()) return;
    if (found->second.rate) --moving_;
    entities_.erase(found);
    return;
  }
  Entity& entity = entities_[control.entity];
  entity.active = control.state == active;
  entity.type = control.type;
  if (!withPosition) return;
  entity.placed = true;
  entity.position = {control.entity,    control.attached, control.clamp, control.parent,
                     control.roll,      control.pitch,    control.yaw,   control.latitude,
                     control.longitude, control.altitude};
}

void Entities::set(const EntityPosition& position) {
  Entity& entity = entities_[position.entity];
  entity.placed = true;
  entity.position = position;
}

void Entities::set(const RateControl& rate) {
  if (rate.toPart) return;
  const auto found = entities_.find(rate.entity);
  if (found == entities_.end()) return;
  const float all[] = {rate.x, rate.y, rate.z, rate.roll, rate.pitch, rate.yaw};
  const bool finite =
      std::all_of(std::begin(all), std::end(all), [](float v) { return std::isfinite(v); });
  const bool still = std::all_of(std::begin(all), std::end(all), [](float v) { return v == 0.0f; });
  if (!finite) return;
  if (found->second.rate) --moving_;
  found->second.rate = still ? std::nullopt : std::optional(rate);
  if (!still) ++moving_;
}

void Entities::advanceTo(double t) {
  const double dt = t - std::exchange(time_, t);
  if (moving_ == 0 || !(dt > 0.0) || dt > longestStep) return;
  for (auto& [id, entity] : entities_) {
    if (entity.rate && entity.active && entity.placed) step(entity.position, *entity.rate, dt);
  }
}

std::optional<EntityPlace> Entities::place(std::uint16_t entity) const {
  return place(entity, deepestAttachment);
}

std::optional<EntityPlace> Entities::place(std::uint16_t id, int deepest) const {
  const auto found = entities_.find(id);
  if (found == entities_.end() || !found->second.active || !found->second.placed) return {};
  const EntityPosition& at = found->second.position;
  const glm::dmat3 rotation = nedFromBody(at.yaw, at.pitch, at.roll);
  if (!at.attached) {
    return EntityPlace{{.latitude_deg = at.latitude, .longitude_deg = at.longitude, .entity = id},
                       at.altitude,
                       enuFromNed * rotation,
                       at.clamp};
  }
  if (deepest == 0) return {};
  std::optional<EntityPlace> parent = place(at.parent, deepest - 1);
  if (!parent) return {};
  const glm::dvec3 offset =
      parent->enuFromBody * glm::dvec3(at.latitude, at.longitude, at.altitude);
  parent->place.east += offset.x;
  parent->place.north += offset.y;
  parent->altitude += offset.z;
  parent->enuFromBody = parent->enuFromBody * rotation;
  return parent;
}

void Entities::list(double waterLevel, std::vector<HostEntity>& out) const {
  out.clear();
  for (const auto& [id, entity] : entities_) {
    const EntityPosition& at = entity.position;
    if (!entity.active || !entity.placed || at.attached) continue;
    out.push_back({.entity = id,
                   .type = entity.type,
                   .place = {at.latitude, at.longitude},
                   .clamp = at.clamp,
                   .height = at.altitude - (at.clamp == 0 ? waterLevel : 0.0),
                   .heading_deg = at.yaw,
                   .pitch_deg = at.pitch,
                   .roll_deg = at.roll});
  }
  std::sort(out.begin(), out.end(),
            [](const HostEntity& a, const HostEntity& b) { return a.entity < b.entity; });
}

}  // namespace seaway::bridge::cigi
