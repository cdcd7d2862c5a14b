#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "sim_bridge/cigi/packets.h"

/// What a CIGI session needs of a sea; nothing here knows how the sea is made.
namespace seaway::bridge::cigi {

/// A place: `east` and `north` metres (true, at that place) from a geodetic position.
struct WaterPoint {
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
  double east = 0.0;
  double north = 0.0;
  double height = 0.0;  ///< m above the still-water level; of velocities alone
  /// The entity whose own waves are left out, because the point is of it, and its host; host 0:
  /// none.
  std::uint16_t entity = 0;
  std::uint32_t host = 0;
};

struct WaterHeight {
  double elevation = 0.0;   ///< of the surface above the still-water level, m
  double slopeEast = 0.0;   ///< true east
  double slopeNorth = 0.0;  ///< true north
  bool valid = false;       ///< whether there is water, and its height is known
};

struct WaterVelocity {
  double elevation = 0.0;    ///< of the surface above the point, above the still-water level, m
  glm::dvec3 velocity{0.0};  ///< true east, north, up, m/s, over ground
  bool valid = false;        ///< whether the point is in water whose motion is known
};

/// A wave that a host wants, by Wave Control.
struct HostWave {
  double height = 0.0;      ///< trough to crest, m
  double wavelength = 0.0;  ///< m; 0: by the period
  double period = 0.0;      ///< s; 0: by the wavelength
  double toward_deg = 0.0;  ///< clockwise from true north
  double phase_deg = 0.0;
  bool operator==(const HostWave&) const = default;
};

/// Where a host says that an active entity is.
struct HostEntity {
  std::uint16_t entity = 0;
  std::uint16_t type = 0;
  WaterPoint place;
  std::uint8_t clamp = 0;    ///< 1: held to the water's height; 2: to its slope too
  double height = 0.0;       ///< m above the still-water level, or, clamped, above the water
  double heading_deg = 0.0;  ///< true, of the bow
  double pitch_deg = 0.0;    ///< bow up
  double roll_deg = 0.0;     ///< starboard down
};

class Water {
 public:
  virtual ~Water() = default;

  /// Heights at time `t`, s since the scene's epoch. Both spans have the same size. Any point, time
  /// or NaN is allowed: what cannot be told is not valid.
  virtual void heights(double t, std::span<const WaterPoint> points,
                       std::span<WaterHeight> out) = 0;
  /// Velocities likewise.
  virtual void velocities(double t, std::span<const WaterPoint> points,
                          std::span<WaterVelocity> out) = 0;

  /// The enabled global waves of a host, by rising number, each time that they change.
  virtual void wavesAsked(std::uint32_t host, double t, std::span<const HostWave> waves) {
    (void)host, (void)t, (void)waves;
  }
  /// A host's active entities that stand on their own, in each of its frames that has any, and once
  /// when it has none any more.
  virtual void entitiesAt(std::uint32_t host, double t, std::span<const HostEntity> entities) {
    (void)host, (void)t, (void)entities;
  }
  /// A host that has fallen silent: nothing of it is there any more.
  virtual void hostGone(std::uint32_t host) { (void)host; }
  /// A host's view, as it was set last.
  virtual void viewAsked(std::uint32_t host, const ViewControl& view) { (void)host, (void)view; }
  virtual void viewDefined(std::uint32_t host, const ViewDefinition& view) {
    (void)host, (void)view;
  }
};

}  // namespace seaway::bridge::cigi
