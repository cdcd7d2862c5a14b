#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <optional>
#include <unordered_map>
#include <vector>

#include "sim_bridge/cigi/packets.h"
#include "sim_bridge/cigi/water.h"

namespace seaway::bridge::cigi {

/// Where an entity is and how it lies.
struct EntityPlace {
  WaterPoint place;
  double altitude = 0.0;        ///< m above mean sea level, or above the surface where clamped
  glm::dmat3 enuFromBody{1.0};  ///< body: x forward, y starboard, z down
  std::uint8_t clamp = 0;       ///< of the entity that the others are attached to
};

/// Rotation from body axes (forward, starboard, down) to north, east, down.
glm::dmat3 nedFromBody(double yaw_deg, double pitch_deg, double roll_deg);

/// The entities of one host, as its packets tell them.
class Entities {
 public:
  void set(const EntityControl& control, bool withPosition);
  void set(const EntityPosition& position);
  /// An entity goes on at this rate from now on, until it is told another or none (all 0). Rates of
  /// articulated parts are not for it.
  void set(const RateControl& rate);
  void clear() { entities_.clear(), moving_ = 0; }

  /// Entities with a rate go on to time `t`, s; from a time later than `t`, or ten seconds before
  /// it, they do not move.
  void advanceTo(double t);
  bool anyMoves() const { return moving_ > 0; }

  /// Where an active entity is, through the parents that it is attached to; nothing for one that is
  /// unknown, inactive, or attached in a ring or more than eight deep.
  std::optional<EntityPlace> place(std::uint16_t entity) const;

  /// The active ones that are attached to none, by rising number; `waterLevel` m above mean sea
  /// level.
  void list(double waterLevel, std::vector<HostEntity>& out) const;

 private:
  struct Entity {
    bool active = true;
    bool placed = false;
    std::uint16_t type = 0;
    EntityPosition position;
    std::optional<RateControl> rate;
  };
  std::optional<EntityPlace> place(std::uint16_t entity, int deepest) const;

  std::unordered_map<std::uint16_t, Entity> entities_;
  std::size_t moving_ = 0;  // entities with a rate, or more
  double time_ = 0.0;
};

}  // namespace seaway::bridge::cigi
