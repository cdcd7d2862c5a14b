#include "sim_bridge/cigi/entities.h"

#include <algorithm>
#include <cmath>

#include "surface/angles.h"

namespace seaway::bridge::cigi {
namespace {

constexpr std::uint8_t active = 1;
constexpr std::uint8_t destroyed = 2;
constexpr int deepestAttachment = 8;

// Columns: north, east and down in east, north, up.
const glm::dmat3 enuFromNed(glm::dvec3(0, 1, 0), glm::dvec3(1, 0, 0), glm::dvec3(0, 0, -1));

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
    entities_.erase(control.entity);
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
