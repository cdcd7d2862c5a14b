#pragma once

#include <array>

#include "sim_bridge/cigi/field.h"
#include "sim_bridge/cigi/packets.h"

/// Where CIGI 3.3 and 4.0 keep each value of each packet (SISO-STD-013). Bytes not named are
/// reserved: written as 0, passed over in reading.
namespace seaway::bridge::cigi {

template <class P>
struct Layout;

template <>
struct Layout<IgControl> {
  using F = Field<IgControl>;
  static constexpr const char* name = "IG Control";
  static constexpr Head v33{1, 24};
  static constexpr Head v40{0x0000, 24};
  static constexpr std::array fields{
      F{"majorVersion", "", Fixed<std::uint8_t>{3, 4}, at(2), at(4)},
      F{"databaseNumber", "", &IgControl::databaseNumber, at(3), at(5)},
      F{"mode", "", &IgControl::mode, bits(4, 0, 2), bits(7, 0, 2)},
      F{"timestampValid", "", &IgControl::timestampValid, bits(4, 2), bits(7, 2)},
      F{"extrapolation", "", &IgControl::extrapolation, bits(4, 3), bits(6, 0)},
      F{"minorVersion", "", Fixed<std::uint8_t>{3, 0}, bits(4, 4, 4), bits(7, 4, 4)},
      F{"byteOrder", "", Fixed<std::uint16_t>{0x8000, 0}, at(6), absent},
      F{"hostFrame", "", &IgControl::hostFrame, at(8), at(8)},
      F{"timestamp", "10 us", &IgControl::timestamp, at(12), at(16)},
      F{"lastIgFrame", "", &IgControl::lastIgFrame, at(16), at(12)},
  };
};

template <>
struct Layout<StartOfFrame> {
  using F = Field<StartOfFrame>;
  static constexpr const char* name = "Start of Frame";
  static constexpr Head v33{101, 24};
  static constexpr Head v40{0xFFFF, 24};
  static constexpr std::array fields{
      F{"majorVersion", "", Fixed<std::uint8_t>{3, 4}, at(2), at(4)},
      F{"databaseNumber", "", &StartOfFrame::databaseNumber, at(3), at(5)},
      F{"status", "", &StartOfFrame::status, at(4), absent},
      F{"mode", "", &StartOfFrame::mode, bits(5, 0, 2), bits(7, 0, 2)},
      F{"timestampValid", "", &StartOfFrame::timestampValid, bits(5, 2), bits(7, 2)},
      F{"hostEarthModel", "", &StartOfFrame::hostEarthModel, bits(5, 3), bits(7, 3)},
      F{"minorVersion", "", Fixed<std::uint8_t>{3, 0}, bits(5, 4, 4), bits(7, 4, 4)},
      F{"byteOrder", "", Fixed<std::uint16_t>{0x8000, 0}, at(6), absent},
      F{"igFrame", "", &StartOfFrame::igFrame, at(8), at(8)},
      F{"timestamp", "10 us", &StartOfFrame::timestamp, at(12), at(12)},
      F{"lastHostFrame", "", &StartOfFrame::lastHostFrame, at(16), at(16)},
      F{"conditions", "", &StartOfFrame::conditions, absent, at(20)},
  };
};

template <>
struct Layout<EntityControl> {
  using F = Field<EntityControl>;
  static constexpr const char* name = "Entity Control";
  static constexpr Head v33{2, 48};
  static constexpr Head v40{0x0025, 16};
  static constexpr std::array fields{
      F{"entity", "", &EntityControl::entity, at(2), at(6)},
      F{"state", "", &EntityControl::state, bits(4, 0, 2), bits(4, 0, 2)},
      F{"attached", "", &EntityControl::attached, bits(4, 2), absent},
      F{"clamp", "", &EntityControl::clamp, bits(4, 5, 2), absent},
      F{"animation", "", &EntityControl::animation, at(5), absent},
      F{"alpha", "", &EntityControl::alpha, at(6), at(5)},
      F{"type", "", &EntityControl::type, at(8), at(10)},
      F{"parent", "", &EntityControl::parent, at(10), absent},
      F{"roll", "deg", &EntityControl::roll, at(12), absent},
      F{"pitch", "deg", &EntityControl::pitch, at(16), absent},
      F{"yaw", "deg", &EntityControl::yaw, at(20), absent},
      F{"latitude", "deg", &EntityControl::latitude, at(24), absent},
      F{"longitude", "deg", &EntityControl::longitude, at(32), absent},
      F{"altitude", "m", &EntityControl::altitude, at(40), absent},
      F{"kind", "", &EntityControl::kind, absent, at(8)},
      F{"domain", "", &EntityControl::domain, absent, at(9)},
      F{"category", "", &EntityControl::category, absent, at(12)},
      F{"subcategory", "", &EntityControl::subcategory, absent, at(13)},
      F{"specific", "", &EntityControl::specific, absent, at(14)},
      F{"extra", "", &EntityControl::extra, absent, at(15)},
  };
};

template <>
struct Layout<EntityPosition> {
  using F = Field<EntityPosition>;
  static constexpr const char* name = "Entity Position";
  static constexpr Head v33 = noPacket;
  static constexpr Head v40{0x0001, 48};
  static constexpr std::array fields{
      F{"attached", "", &EntityPosition::attached, absent, bits(4, 0)},
      F{"clamp", "", &EntityPosition::clamp, absent, bits(4, 1, 2)},
      F{"entity", "", &EntityPosition::entity, absent, at(6)},
      F{"parent", "", &EntityPosition::parent, absent, at(8)},
      F{"roll", "deg", &EntityPosition::roll, absent, at(12)},
      F{"pitch", "deg", &EntityPosition::pitch, absent, at(16)},
      F{"yaw", "deg", &EntityPosition::yaw, absent, at(20)},
      F{"latitude", "deg", &EntityPosition::latitude, absent, at(24)},
      F{"longitude", "deg", &EntityPosition::longitude, absent, at(32)},
      F{"altitude", "m", &EntityPosition::altitude, absent, at(40)},
  };
};

template <>
struct Layout<RateControl> {
  using F = Field<RateControl>;
  static constexpr const char* name = "Rate Control";
  static constexpr Head v33{8, 32};
  static constexpr Head v40{0x0007, 32};
  static constexpr std::array fields{
      F{"entity", "", &RateControl::entity, at(2), at(4)},
      F{"part", "", &RateControl::part, at(4), at(6)},
      F{"toPart", "", &RateControl::toPart, bits(5, 0), bits(7, 0)},
      F{"bodyAxes", "", &RateControl::bodyAxes, bits(5, 1), bits(7, 1)},
      F{"x", "m/s", &RateControl::x, at(8), at(8)},
      F{"y", "m/s", &RateControl::y, at(12), at(12)},
      F{"z", "m/s", &RateControl::z, at(16), at(16)},
      F{"roll", "deg/s", &RateControl::roll, at(20), at(20)},
      F{"pitch", "deg/s", &RateControl::pitch, at(24), at(24)},
      F{"yaw", "deg/s", &RateControl::yaw, at(28), at(28)},
  };
};

template <>
struct Layout<HatHotRequest> {
  using F = Field<HatHotRequest>;
  static constexpr const char* name = "HAT/HOT Request";
  static constexpr Head v33{24, 32};
  static constexpr Head v40{0x0017, 40};
  static constexpr std::array fields{
      F{"request", "", &HatHotRequest::request, at(2), at(4)},
      F{"type", "", &HatHotRequest::type, bits(4, 0, 2), bits(8, 0, 2)},
      F{"entityAxes", "", &HatHotRequest::entityAxes, bits(4, 2), bits(8, 2)},
      F{"period", "frames", &HatHotRequest::period, at(5), at(9)},
      F{"entity", "", &HatHotRequest::entity, at(6), at(6)},
      F{"latitude", "deg", &HatHotRequest::latitude, at(8), at(16)},
      F{"longitude", "deg", &HatHotRequest::longitude, at(16), at(24)},
      F{"altitude", "m", &HatHotRequest::altitude, at(24), at(32)},
  };
};

template <>
struct Layout<HatHotResponse> {
  using F = Field<HatHotResponse>;
  static constexpr const char* name = "HAT/HOT Response";
  static constexpr Head v33{102, 16};
  static constexpr Head v40{0x0FFF, 16};
  static constexpr std::array fields{
      F{"request", "", &HatHotResponse::request, at(2), at(6)},
      F{"valid", "", &HatHotResponse::valid, bits(4, 0), bits(4, 0)},
      F{"ofTerrain", "", &HatHotResponse::ofTerrain, bits(4, 1), bits(4, 1)},
      F{"hostFrame", "", &HatHotResponse::hostFrame, bits(4, 4, 4), bits(4, 4, 4)},
      F{"height", "m", &HatHotResponse::height, at(8), at(8)},
  };
};

template <>
struct Layout<HatHotExtendedResponse> {
  using F = Field<HatHotExtendedResponse>;
  static constexpr const char* name = "HAT/HOT Extended Response";
  static constexpr Head v33{103, 40};
  static constexpr Head v40{0x0FFE, 40};
  static constexpr std::array fields{
      F{"request", "", &HatHotExtendedResponse::request, at(2), at(6)},
      F{"valid", "", &HatHotExtendedResponse::valid, bits(4, 0), bits(4, 0)},
      F{"hostFrame", "", &HatHotExtendedResponse::hostFrame, bits(4, 4, 4), bits(4, 4, 4)},
      F{"heightAbove", "m", &HatHotExtendedResponse::heightAbove, at(8), at(8)},
      F{"heightOf", "m", &HatHotExtendedResponse::heightOf, at(16), at(16)},
      F{"material", "", &HatHotExtendedResponse::material, at(24), at(24)},
      F{"normalAzimuth", "deg", &HatHotExtendedResponse::normalAzimuth, at(28), at(28)},
      F{"normalElevation", "deg", &HatHotExtendedResponse::normalElevation, at(32), at(32)},
  };
};

template <>
struct Layout<MaritimeSurfaceControl> {
  using F = Field<MaritimeSurfaceControl>;
  static constexpr const char* name = "Maritime Surface Conditions Control";
  static constexpr Head v33{13, 24};
  static constexpr Head v40{0x000C, 24};
  static constexpr std::array fields{
      F{"region", "", &MaritimeSurfaceControl::region, at(2), at(6)},
      F{"enabled", "", &MaritimeSurfaceControl::enabled, bits(4, 0), bits(4, 0)},
      F{"whitecaps", "", &MaritimeSurfaceControl::whitecaps, bits(4, 1), bits(4, 1)},
      F{"scope", "", &MaritimeSurfaceControl::scope, bits(4, 2, 2), bits(4, 2, 2)},
      F{"height", "m", &MaritimeSurfaceControl::height, at(8), at(8)},
      F{"temperature", "deg C", &MaritimeSurfaceControl::temperature, at(12), at(12)},
      F{"clarity", "%", &MaritimeSurfaceControl::clarity, at(16), at(16)},
  };
};

template <>
struct Layout<WaveControl> {
  using F = Field<WaveControl>;
  static constexpr const char* name = "Wave Control";
  static constexpr Head v33{14, 32};
  static constexpr Head v40{0x000D, 32};
  static constexpr std::array fields{
      F{"region", "", &WaveControl::region, at(2), at(6)},
      F{"wave", "", &WaveControl::wave, at(4), at(4)},
      F{"enabled", "", &WaveControl::enabled, bits(5, 0), bits(5, 0)},
      F{"scope", "", &WaveControl::scope, bits(5, 1, 2), bits(5, 1, 2)},
      F{"breaker", "", &WaveControl::breaker, bits(5, 3, 2), bits(5, 3, 2)},
      F{"height", "m", &WaveControl::height, at(8), at(8)},
      F{"wavelength", "m", &WaveControl::wavelength, at(12), at(12)},
      F{"period", "s", &WaveControl::period, at(16), at(16)},
      F{"direction", "deg", &WaveControl::direction, at(20), at(20)},
      F{"phase", "deg", &WaveControl::phase, at(24), at(24)},
      F{"leading", "deg", &WaveControl::leading, at(28), at(28)},
  };
};

template <>
struct Layout<EnvironmentRequest> {
  using F = Field<EnvironmentRequest>;
  static constexpr const char* name = "Environmental Conditions Request";
  static constexpr Head v33{28, 32};
  static constexpr Head v40{0x001B, 32};
  static constexpr std::array fields{
      F{"type", "", &EnvironmentRequest::type, at(2), at(4)},
      F{"request", "", &EnvironmentRequest::request, at(3), at(5)},
      F{"latitude", "deg", &EnvironmentRequest::latitude, at(8), at(8)},
      F{"longitude", "deg", &EnvironmentRequest::longitude, at(16), at(16)},
      F{"altitude", "m", &EnvironmentRequest::altitude, at(24), at(24)},
  };
};

template <>
struct Layout<MaritimeSurfaceResponse> {
  using F = Field<MaritimeSurfaceResponse>;
  static constexpr const char* name = "Maritime Surface Conditions Response";
  static constexpr Head v33{111, 16};
  static constexpr Head v40{0x0FF6, 24};
  static constexpr std::array fields{
      F{"request", "", &MaritimeSurfaceResponse::request, at(2), at(4)},
      F{"height", "m", &MaritimeSurfaceResponse::height, at(4), at(8)},
      F{"temperature", "deg C", &MaritimeSurfaceResponse::temperature, at(8), at(12)},
      F{"clarity", "%", &MaritimeSurfaceResponse::clarity, at(12), at(16)},
  };
};

template <>
struct Layout<ViewControl> {
  using F = Field<ViewControl>;
  static constexpr const char* name = "View Control";
  static constexpr Head v33{16, 32};
  static constexpr Head v40{0x000F, 40};
  static constexpr std::array fields{
      F{"view", "", &ViewControl::view, at(2), at(6)},
      F{"group", "", &ViewControl::group, at(4), at(4)},
      F{"xEnabled", "", &ViewControl::xEnabled, bits(5, 0), bits(5, 0)},
      F{"yEnabled", "", &ViewControl::yEnabled, bits(5, 1), bits(5, 1)},
      F{"zEnabled", "", &ViewControl::zEnabled, bits(5, 2), bits(5, 2)},
      F{"rollEnabled", "", &ViewControl::rollEnabled, bits(5, 3), bits(5, 3)},
      F{"pitchEnabled", "", &ViewControl::pitchEnabled, bits(5, 4), bits(5, 4)},
      F{"yawEnabled", "", &ViewControl::yawEnabled, bits(5, 5), bits(5, 5)},
      F{"entity", "", &ViewControl::entity, at(6), at(8)},
      F{"x", "m", &ViewControl::x, at(8), at(12)},
      F{"y", "m", &ViewControl::y, at(12), at(16)},
      F{"z", "m", &ViewControl::z, at(16), at(20)},
      F{"roll", "deg", &ViewControl::roll, at(20), at(24)},
      F{"pitch", "deg", &ViewControl::pitch, at(24), at(28)},
      F{"yaw", "deg", &ViewControl::yaw, at(28), at(32)},
  };
};

template <>
struct Layout<ViewDefinition> {
  using F = Field<ViewDefinition>;
  static constexpr const char* name = "View Definition";
  static constexpr Head v33{21, 32};
  static constexpr Head v40{0x0014, 40};
  static constexpr std::array fields{
      F{"view", "", &ViewDefinition::view, at(2), at(4)},
      F{"group", "", &ViewDefinition::group, at(4), at(6)},
      F{"nearEnabled", "", &ViewDefinition::nearEnabled, bits(5, 0), bits(7, 0)},
      F{"farEnabled", "", &ViewDefinition::farEnabled, bits(5, 1), bits(7, 1)},
      F{"leftEnabled", "", &ViewDefinition::leftEnabled, bits(5, 2), bits(7, 2)},
      F{"rightEnabled", "", &ViewDefinition::rightEnabled, bits(5, 3), bits(7, 3)},
      F{"topEnabled", "", &ViewDefinition::topEnabled, bits(5, 4), bits(7, 4)},
      F{"bottomEnabled", "", &ViewDefinition::bottomEnabled, bits(5, 5), bits(7, 5)},
      F{"mirror", "", &ViewDefinition::mirror, bits(5, 6, 2), bits(7, 6, 2)},
      F{"orthographic", "", &ViewDefinition::orthographic, bits(6, 3), bits(8, 3)},
      F{"type", "", &ViewDefinition::type, bits(6, 5, 3), bits(8, 5, 3)},
      F{"nearPlane", "m", &ViewDefinition::nearPlane, at(8), at(12)},
      F{"farPlane", "m", &ViewDefinition::farPlane, at(12), at(16)},
      F{"left", "deg", &ViewDefinition::left, at(16), at(20)},
      F{"right", "deg", &ViewDefinition::right, at(20), at(24)},
      F{"top", "deg", &ViewDefinition::top, at(24), at(28)},
      F{"bottom", "deg", &ViewDefinition::bottom, at(28), at(32)},
  };
};

template <>
struct Layout<WaterVelocityRequest> {
  using F = Field<WaterVelocityRequest>;
  static constexpr const char* name = "Water Velocity Request (user-defined)";
  static constexpr Head v33{201, 32};
  static constexpr Head v40{0x1000, 40};
  static constexpr std::array fields{
      F{"request", "", &WaterVelocityRequest::request, at(2), at(4)},
      F{"entityAxes", "", &WaterVelocityRequest::entityAxes, bits(4, 2), bits(8, 2)},
      F{"period", "frames", &WaterVelocityRequest::period, at(5), at(9)},
      F{"entity", "", &WaterVelocityRequest::entity, at(6), at(6)},
      F{"latitude", "deg", &WaterVelocityRequest::latitude, at(8), at(16)},
      F{"longitude", "deg", &WaterVelocityRequest::longitude, at(16), at(24)},
      F{"altitude", "m", &WaterVelocityRequest::altitude, at(24), at(32)},
  };
};

template <>
struct Layout<WaterVelocityResponse> {
  using F = Field<WaterVelocityResponse>;
  static constexpr const char* name = "Water Velocity Response (user-defined)";
  static constexpr Head v33{202, 32};
  static constexpr Head v40{0x1001, 32};
  static constexpr std::array fields{
      F{"request", "", &WaterVelocityResponse::request, at(2), at(6)},
      F{"valid", "", &WaterVelocityResponse::valid, bits(4, 0), bits(4, 0)},
      F{"hostFrame", "", &WaterVelocityResponse::hostFrame, bits(4, 4, 4), bits(4, 4, 4)},
      F{"heightOf", "m", &WaterVelocityResponse::heightOf, at(8), at(8)},
      F{"east", "m/s", &WaterVelocityResponse::east, at(16), at(16)},
      F{"north", "m/s", &WaterVelocityResponse::north, at(20), at(20)},
      F{"up", "m/s", &WaterVelocityResponse::up, at(24), at(24)},
  };
};

}  // namespace seaway::bridge::cigi
