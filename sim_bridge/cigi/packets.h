#pragma once

#include <cstdint>
#include <variant>

/// CIGI, the Common Image Generator Interface (SISO-STD-013), versions 3.3 and 4.0: the packets
/// that a sea needs, free of how either version writes them (packet_layouts.h).
///
/// Angles are degrees, positions degrees of latitude and longitude and metres above mean sea level;
/// yaw is a compass heading, pitch positive bow up, roll positive starboard down. Body axes of an
/// entity are x forward, y starboard, z down.
namespace seaway::bridge::cigi {

/// Begins every datagram of a host.
struct IgControl {
  std::int8_t databaseNumber = 0;
  std::uint8_t mode = 0;  ///< 0 reset and standby, 1 operate, 2 debug, 3 (3.3) maintenance
  bool timestampValid = false;
  bool extrapolation = false;
  std::uint32_t hostFrame = 0;
  std::uint32_t timestamp = 0;  ///< 10 µs, modulo 2³²
  std::uint32_t lastIgFrame = 0;
};

/// Begins every datagram of an image generator.
struct StartOfFrame {
  std::int8_t databaseNumber = 0;
  std::uint8_t status = 0;  ///< 0 normal; 3.3 only
  std::uint8_t mode = 0;    ///< as in IgControl
  bool timestampValid = false;
  bool hostEarthModel = false;  ///< else WGS 84
  std::uint32_t igFrame = 0;
  std::uint32_t timestamp = 0;  ///< 10 µs, modulo 2³²
  std::uint32_t lastHostFrame = 0;
  std::uint16_t conditions = 0;  ///< 4.0 only
};

/// What an entity is; in 3.3 also where. 4.0 says that in EntityPosition, and the type as an
/// enumeration of DIS.
struct EntityControl {
  std::uint16_t entity = 0;
  std::uint8_t state = 0;  ///< 0 inactive or standby, 1 active, 2 destroyed
  std::uint8_t alpha = 255;
  std::uint16_t type = 0;  ///< 4.0: country
  // 3.3 alone
  bool attached = false;
  std::uint8_t clamp = 0;
  std::uint8_t animation = 0;
  std::uint16_t parent = 0;
  float roll = 0, pitch = 0, yaw = 0;
  double latitude = 0, longitude = 0, altitude = 0;
  // 4.0 alone
  std::uint8_t kind = 0, domain = 0, category = 0, subcategory = 0, specific = 0, extra = 0;
};

/// Where an entity is; 4.0 only.
struct EntityPosition {
  std::uint16_t entity = 0;
  bool attached = false;   ///< to `parent`: position and attitude are in its body axes, metres
  std::uint8_t clamp = 0;  ///< 0 none, 1 altitude, 2 altitude and attitude relative to the surface
  std::uint16_t parent = 0;
  float roll = 0, pitch = 0, yaw = 0;                ///< deg
  double latitude = 0, longitude = 0, altitude = 0;  ///< deg, deg, m; x, y, z where attached
};

/// Velocity of an entity.
struct RateControl {
  std::uint16_t entity = 0;
  std::uint8_t part = 0;
  bool toPart = false;
  bool bodyAxes = false;
  float x = 0, y = 0, z = 0;           ///< m/s
  float roll = 0, pitch = 0, yaw = 0;  ///< deg/s
};

enum class HeightKind : std::uint8_t { aboveTerrain = 0, ofTerrain = 1, extended = 2 };

/// Asks for height above terrain (HAT), height of terrain (HOT) or both.
struct HatHotRequest {
  std::uint16_t request = 0;
  std::uint8_t type = 0;  ///< HeightKind
  bool entityAxes = false;
  std::uint8_t period = 0;  ///< frames between answers; 0: one answer
  std::uint16_t entity = 0;
  double latitude = 0, longitude = 0, altitude = 0;  ///< x, y, z in m where `entityAxes`
};

struct HatHotResponse {
  std::uint16_t request = 0;
  bool valid = false;
  bool ofTerrain = false;
  std::uint8_t hostFrame = 0;  ///< its four low bits
  double height = 0;           ///< m: HAT, or HOT above mean sea level
};

struct HatHotExtendedResponse {
  std::uint16_t request = 0;
  bool valid = false;
  std::uint8_t hostFrame = 0;  ///< its four low bits
  double heightAbove = 0;      ///< HAT, m
  double heightOf = 0;         ///< HOT, m above mean sea level
  std::uint32_t material = 0;
  float normalAzimuth = 0;    ///< deg clockwise from true north
  float normalElevation = 0;  ///< deg above the horizontal
};

/// What surface conditions and waves hold for.
enum class Scope : std::uint8_t { global = 0, regional = 1, entity = 2 };

struct MaritimeSurfaceControl {
  std::uint16_t region = 0;  ///< or entity
  bool enabled = false;
  bool whitecaps = false;
  std::uint8_t scope = 0;  ///< Scope
  float height = 0;        ///< of still water above mean sea level, m
  float temperature = 0;   ///< °C
  float clarity = 0;       ///< %
};

struct WaveControl {
  std::uint16_t region = 0;  ///< or entity
  std::uint8_t wave = 0;
  bool enabled = false;
  std::uint8_t scope = 0;  ///< Scope
  std::uint8_t breaker = 0;
  float height = 0;      ///< trough to crest, m
  float wavelength = 0;  ///< m
  float period = 0;      ///< s
  float direction = 0;   ///< toward, deg clockwise from true north
  float phase = 0;       ///< deg
  float leading = 0;     ///< deg
};

struct EnvironmentRequest {
  std::uint8_t type = 0;  ///< bits: 1 maritime, 2 terrestrial, 4 weather, 8 aerosol
  std::uint8_t request = 0;
  double latitude = 0, longitude = 0, altitude = 0;
};

struct MaritimeSurfaceResponse {
  std::uint8_t request = 0;
  float height = 0;       ///< of still water above mean sea level, m
  float temperature = 0;  ///< °C
  float clarity = 0;      ///< %
};

struct ViewControl {
  std::uint16_t view = 0;
  std::uint8_t group = 0;
  bool xEnabled = false, yEnabled = false, zEnabled = false;
  bool rollEnabled = false, pitchEnabled = false, yawEnabled = false;
  std::uint16_t entity = 0;
  float x = 0, y = 0, z = 0;           ///< in the entity's body axes, m
  float roll = 0, pitch = 0, yaw = 0;  ///< relative to the entity, deg
};

struct ViewDefinition {
  std::uint16_t view = 0;
  std::uint8_t group = 0;
  bool nearEnabled = false, farEnabled = false;
  bool leftEnabled = false, rightEnabled = false, topEnabled = false, bottomEnabled = false;
  std::uint8_t mirror = 0;
  bool orthographic = false;
  std::uint8_t type = 0;
  float nearPlane = 0, farPlane = 0;               ///< m
  float left = 0, right = 0, top = 0, bottom = 0;  ///< half angles, deg; left and bottom negative
};

/// User-defined: asks for the water's velocity at a point. Laid out as a HAT/HOT request.
struct WaterVelocityRequest {
  std::uint16_t request = 0;
  bool entityAxes = false;
  std::uint8_t period = 0;  ///< frames between answers; 0: one answer
  std::uint16_t entity = 0;
  double latitude = 0, longitude = 0, altitude = 0;  ///< x, y, z in m where `entityAxes`
};

/// User-defined: the water's velocity over ground, the current included.
struct WaterVelocityResponse {
  std::uint16_t request = 0;
  bool valid = false;
  std::uint8_t hostFrame = 0;         ///< its four low bits
  double heightOf = 0;                ///< of the surface there, m above mean sea level
  float east = 0, north = 0, up = 0;  ///< m/s
};

using Packet =
    std::variant<IgControl, StartOfFrame, EntityControl, EntityPosition, RateControl, HatHotRequest,
                 HatHotResponse, HatHotExtendedResponse, MaritimeSurfaceControl, WaveControl,
                 EnvironmentRequest, MaritimeSurfaceResponse, ViewControl, ViewDefinition,
                 WaterVelocityRequest, WaterVelocityResponse>;

}  // namespace seaway::bridge::cigi
