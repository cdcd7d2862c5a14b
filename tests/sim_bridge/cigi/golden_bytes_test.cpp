#include <gtest/gtest.h>

#include <bit>
#include <cstring>

#include "tests/sim_bridge/cigi/random_packets.h"

/// Bytes put together by hand from the standard's offsets, without the tables.
namespace seaway::bridge::cigi {
namespace {

constexpr Dialect little33{Version::v33, ByteOrder::littleEndian};
constexpr Dialect big33{Version::v33, ByteOrder::bigEndian};
constexpr Dialect little40{Version::v40, ByteOrder::littleEndian};
constexpr Dialect big40{Version::v40, ByteOrder::bigEndian};

/// A packet as pairs of hexadecimal digits; blanks are passed over.
std::vector<std::byte> hex(const std::string& text) {
  std::vector<std::byte> bytes;
  std::string pair;
  for (const char c : text) {
    if (c == ' ') continue;
    pair += c;
    if (pair.size() < 2) continue;
    bytes.push_back(static_cast<std::byte>(std::stoi(pair, nullptr, 16)));
    pair.clear();
  }
  return bytes;
}

std::string textOf(const std::vector<std::byte>& bytes) {
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    char pair[4];
    std::snprintf(pair, sizeof pair, "%02x", std::to_integer<unsigned>(bytes[i]));
    text += pair;
    if (i % 4 == 3) text += ' ';
  }
  return text;
}

void expectBytes(Dialect dialect, const Packet& packet, const std::string& golden) {
  const auto written = test::datagramOf(dialect, {packet});
  EXPECT_EQ(textOf(written), textOf(hex(golden))) << packetName(packet);
}

TEST(CigiGoldenBytes, IgControl) {
  const IgControl control{.databaseNumber = -2,
                          .mode = 1,
                          .timestampValid = true,
                          .hostFrame = 0x01020304,
                          .timestamp = 0x0A0B0C0D,
                          .lastIgFrame = 0x11121314};
  expectBytes(little33, control, "01 18 03 fe 35 00 0080 04030201 0d0c0b0a 14131211 00000000");
  expectBytes(big33, control, "01 18 03 fe 35 00 8000 01020304 0a0b0c0d 11121314 00000000");
  expectBytes(little40, control, "1800 0000 04 fe 00 05 04030201 14131211 0d0c0b0a 00000000");
  expectBytes(big40, control, "0018 0000 04 fe 00 05 01020304 11121314 0a0b0c0d 00000000");
}

TEST(CigiGoldenBytes, StartOfFrame) {
  const StartOfFrame start{.databaseNumber = 5,
                           .status = 7,
                           .mode = 2,
                           .timestampValid = true,
                           .hostEarthModel = true,
                           .igFrame = 0x01020304,
                           .timestamp = 0x0A0B0C0D,
                           .lastHostFrame = 0x11121314,
                           .conditions = 0x0102};
  expectBytes(little33, start, "65 18 03 05 07 3e 0080 04030201 0d0c0b0a 14131211 00000000");
  expectBytes(little40, start, "1800 ffff 04 05 00 0e 04030201 0d0c0b0a 14131211 0201 0000");
  expectBytes(big40, start, "0018 ffff 04 05 00 0e 01020304 0a0b0c0d 11121314 0102 0000");
}

// 1.0f is 3f800000, 2.0f 40000000, -0.5f bf000000; 1.0 is 3ff0000000000000, 2.0 4000…, -0.5 bfe0….
TEST(CigiGoldenBytes, Entities) {
  const EntityControl control{.entity = 0x0102,
                              .state = 1,
                              .alpha = 0xC8,
                              .type = 0x0304,
                              .attached = true,
                              .clamp = 2,
                              .animation = 9,
                              .parent = 0x0506,
                              .roll = 1,
                              .pitch = 2,
                              .yaw = -0.5f,
                              .latitude = 1,
                              .longitude = 2,
                              .altitude = -0.5,
                              .kind = 1,
                              .domain = 3,
                              .category = 6,
                              .subcategory = 7,
                              .specific = 8,
                              .extra = 9};
  expectBytes(big33, control,
              "02 30 0102 45 09 c8 00 0304 0506 3f800000 40000000 bf000000 "
              "3ff0000000000000 4000000000000000 bfe0000000000000");
  expectBytes(big40, control, "0010 0025 01 c8 0102 01 03 0304 06 07 08 09");
  const EntityPosition position{.entity = 0x0102,
                                .attached = true,
                                .clamp = 2,
                                .parent = 0x0506,
                                .roll = 1,
                                .pitch = 2,
                                .yaw = -0.5f,
                                .latitude = 1,
                                .longitude = 2,
                                .altitude = -0.5};
  expectBytes(big40, position,
              "0030 0001 05 00 0102 0506 0000 3f800000 40000000 bf000000 "
              "3ff0000000000000 4000000000000000 bfe0000000000000");
}

TEST(CigiGoldenBytes, HeightRequestsAndResponses) {
  const HatHotRequest request{.request = 0x0102,
                              .type = 2,
                              .entityAxes = true,
                              .period = 3,
                              .entity = 0x0405,
                              .latitude = 1,
                              .longitude = 2,
                              .altitude = -0.5};
  expectBytes(big33, request,
              "18 20 0102 06 03 0405 3ff0000000000000 4000000000000000 bfe0000000000000");
  expectBytes(big40, request,
              "0028 0017 0102 0405 06 03 0000 00000000 "
              "3ff0000000000000 4000000000000000 bfe0000000000000");
  expectBytes(little40, request,
              "2800 1700 0201 0504 06 03 0000 00000000 "
              "000000000000f03f 0000000000000040 000000000000e0bf");
  const HatHotResponse response{
      .request = 0x0102, .valid = true, .ofTerrain = true, .hostFrame = 0xA, .height = -0.5};
  expectBytes(big33, response, "66 10 0102 a3 000000 bfe0000000000000");
  expectBytes(big40, response, "0010 0fff a3 00 0102 bfe0000000000000");
  const HatHotExtendedResponse extended{.request = 0x0102,
                                        .valid = true,
                                        .hostFrame = 0xA,
                                        .heightAbove = 1,
                                        .heightOf = 2,
                                        .material = 0x01020304,
                                        .normalAzimuth = -0.5f,
                                        .normalElevation = 2};
  expectBytes(big33, extended,
              "67 28 0102 a1 000000 3ff0000000000000 4000000000000000 01020304 bf000000 40000000 "
              "00000000");
  expectBytes(big40, extended,
              "0028 0ffe a1 00 0102 3ff0000000000000 4000000000000000 01020304 bf000000 40000000 "
              "00000000");
}

TEST(CigiGoldenBytes, TheSea) {
  const MaritimeSurfaceControl surface{.region = 0x0102,
                                       .enabled = true,
                                       .whitecaps = true,
                                       .scope = 2,
                                       .height = 1,
                                       .temperature = 2,
                                       .clarity = -0.5f};
  expectBytes(big33, surface, "0d 18 0102 0b 000000 3f800000 40000000 bf000000 00000000");
  expectBytes(big40, surface, "0018 000c 0b 00 0102 3f800000 40000000 bf000000 00000000");
  const WaveControl wave{.region = 0x0102,
                         .wave = 3,
                         .enabled = true,
                         .scope = 1,
                         .breaker = 2,
                         .height = 1,
                         .wavelength = 2,
                         .period = -0.5f,
                         .direction = 1,
                         .phase = 2,
                         .leading = -0.5f};
  expectBytes(big33, wave,
              "0e 20 0102 03 13 0000 3f800000 40000000 bf000000 3f800000 40000000 bf000000");
  expectBytes(big40, wave,
              "0020 000d 03 13 0102 3f800000 40000000 bf000000 3f800000 40000000 bf000000");
  const EnvironmentRequest request{
      .type = 1, .request = 9, .latitude = 1, .longitude = 2, .altitude = -0.5};
  expectBytes(big33, request,
              "1c 20 01 09 00000000 3ff0000000000000 4000000000000000 bfe0000000000000");
  expectBytes(big40, request,
              "0020 001b 01 09 0000 3ff0000000000000 4000000000000000 bfe0000000000000");
  const MaritimeSurfaceResponse response{
      .request = 9, .height = 1, .temperature = 2, .clarity = -0.5f};
  expectBytes(big33, response, "6f 10 09 00 3f800000 40000000 bf000000");
  expectBytes(big40, response, "0018 0ff6 09 000000 3f800000 40000000 bf000000 00000000");
}

TEST(CigiGoldenBytes, ViewsAndRates) {
  const ViewControl control{.view = 0x0102,
                            .group = 3,
                            .yEnabled = true,
                            .yawEnabled = true,
                            .entity = 0x0405,
                            .x = 1,
                            .y = 2,
                            .z = -0.5f,
                            .roll = 1,
                            .pitch = 2,
                            .yaw = -0.5f};
  expectBytes(big33, control,
              "10 20 0102 03 22 0405 3f800000 40000000 bf000000 3f800000 40000000 bf000000");
  expectBytes(big40, control,
              "0028 000f 03 22 0102 0405 0000 3f800000 40000000 bf000000 3f800000 40000000 "
              "bf000000 00000000");
  const ViewDefinition definition{.view = 0x0102,
                                  .group = 3,
                                  .nearEnabled = true,
                                  .bottomEnabled = true,
                                  .mirror = 1,
                                  .orthographic = true,
                                  .type = 5,
                                  .nearPlane = 1,
                                  .farPlane = 2,
                                  .left = -0.5f,
                                  .right = 1,
                                  .top = 2,
                                  .bottom = -0.5f};
  expectBytes(big33, definition,
              "15 20 0102 03 61 a8 00 3f800000 40000000 bf000000 3f800000 40000000 bf000000");
  expectBytes(big40, definition,
              "0028 0014 0102 03 61 a8 000000 3f800000 40000000 bf000000 3f800000 40000000 "
              "bf000000 00000000");
  const RateControl rate{.entity = 0x0102,
                         .part = 3,
                         .bodyAxes = true,
                         .x = 1,
                         .y = 2,
                         .z = -0.5f,
                         .roll = 1,
                         .pitch = 2,
                         .yaw = -0.5f};
  expectBytes(big33, rate,
              "08 20 0102 03 02 0000 3f800000 40000000 bf000000 3f800000 40000000 bf000000");
  expectBytes(big40, rate,
              "0020 0007 0102 03 02 3f800000 40000000 bf000000 3f800000 40000000 bf000000");
}

TEST(CigiGoldenBytes, WaterVelocity) {
  const WaterVelocityRequest request{.request = 0x0102,
                                     .entityAxes = true,
                                     .period = 3,
                                     .entity = 0x0405,
                                     .latitude = 1,
                                     .longitude = 2,
                                     .altitude = -0.5};
  expectBytes(big33, request,
              "c9 20 0102 04 03 0405 3ff0000000000000 4000000000000000 bfe0000000000000");
  expectBytes(big40, request,
              "0028 1000 0102 0405 04 03 0000 00000000 "
              "3ff0000000000000 4000000000000000 bfe0000000000000");
  const WaterVelocityResponse response{.request = 0x0102,
                                       .valid = true,
                                       .hostFrame = 0xA,
                                       .heightOf = 2,
                                       .east = 1,
                                       .north = 2,
                                       .up = -0.5f};
  expectBytes(big33, response,
              "ca 20 0102 a1 000000 4000000000000000 3f800000 40000000 bf000000 00000000");
  expectBytes(big40, response,
              "0020 1001 a1 00 0102 4000000000000000 3f800000 40000000 bf000000 00000000");
}

}  // namespace
}  // namespace seaway::bridge::cigi
