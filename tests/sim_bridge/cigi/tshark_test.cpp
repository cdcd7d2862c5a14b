#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>

#include "tests/sim_bridge/cigi/random_packets.h"
#include "tests/sim_bridge/test_support.h"

/// Wireshark's dissector as a reader of 3.3 that knows nothing of our tables.
namespace seaway::bridge::cigi {
namespace {

using bridge::test::TempFolder;

std::string outputOf(const std::string& command) {
  std::string text;
  FILE* pipe = popen((command + " 2>/dev/null").c_str(), "r");
  if (!pipe) return text;
  std::array<char, 4096> part;
  while (const std::size_t size = std::fread(part.data(), 1, part.size(), pipe)) {
    text.append(part.data(), size);
  }
  pclose(pipe);
  return text;
}

bool hasTshark() { return !outputOf("command -v tshark && command -v text2pcap").empty(); }

/// The datagram as text2pcap reads it.
std::string hexDump(const std::vector<std::byte>& bytes) {
  std::string text = "000000";
  for (const std::byte byte : bytes) {
    char pair[8];
    std::snprintf(pair, sizeof pair, " %02x", std::to_integer<unsigned>(byte));
    text += pair;
  }
  return text + "\n";
}

/// Fields of the datagram as tshark reads them, in the order given, divided by '|'.
std::string dissected(const std::vector<std::byte>& datagram,
                      const std::vector<std::string>& fields) {
  const TempFolder folder;
  const std::string dump = folder.write("dump.txt", hexDump(datagram)).string();
  const std::string capture = (folder / "dump.pcap").string();
  outputOf("text2pcap -q -u 8004,8005 " + dump + " " + capture);
  std::string command =
      "tshark -r " + capture + " -d udp.port==8004,cigi -T fields -E separator='|'";
  for (const std::string& field : fields) command += " -e " + field;
  std::string text = outputOf(command);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

class CigiTshark : public ::testing::TestWithParam<ByteOrder> {
 protected:
  void SetUp() override {
    if (!hasTshark()) GTEST_SKIP() << "tshark is not installed";
  }
  std::string read(const std::vector<Packet>& packets, const std::vector<std::string>& fields) {
    return dissected(test::datagramOf({Version::v33, GetParam()}, packets), fields);
  }
};

TEST_P(CigiTshark, ReadsWhatAHostSends) {
  const std::string text = read({IgControl{.databaseNumber = -3,
                                           .mode = 1,
                                           .timestampValid = true,
                                           .hostFrame = 123456,
                                           .timestamp = 654321,
                                           .lastIgFrame = 42},
                                 HatHotRequest{.request = 513,
                                               .type = 2,
                                               .entityAxes = true,
                                               .period = 7,
                                               .entity = 772,
                                               .latitude = 1.5,
                                               .longitude = -2.25,
                                               .altitude = 3.125},
                                 WaveControl{.region = 513,
                                             .wave = 3,
                                             .enabled = true,
                                             .scope = 1,
                                             .breaker = 2,
                                             .height = 1.5f,
                                             .wavelength = 80,
                                             .period = 7.25f,
                                             .direction = 225,
                                             .phase = -45,
                                             .leading = 12},
                                 MaritimeSurfaceControl{.region = 9,
                                                        .enabled = true,
                                                        .whitecaps = true,
                                                        .scope = 2,
                                                        .height = 0.5f,
                                                        .temperature = 12,
                                                        .clarity = 60}},
                                {"cigi.ig_control.db_number",
                                 "cigi.ig_control.host_frame_number",
                                 "cigi.ig_control.timestamp",
                                 "cigi.ig_control.last_ig_frame_number",
                                 "cigi.hat_hot_request.hat_hot_id",
                                 "cigi.hat_hot_request.type",
                                 "cigi.hat_hot_request.update_period",
                                 "cigi.hat_hot_request.entity_id",
                                 "cigi.hat_hot_request.lat_xoff",
                                 "cigi.hat_hot_request.lon_yoff",
                                 "cigi.hat_hot_request.alt_zoff",
                                 "cigi.wave_control.entity_region_id",
                                 "cigi.wave_control.wave_id",
                                 "cigi.wave_control.scope",
                                 "cigi.wave_control.breaker_type",
                                 "cigi.wave_control.height",
                                 "cigi.wave_control.wavelength",
                                 "cigi.wave_control.period",
                                 "cigi.wave_control.direction",
                                 "cigi.wave_control.phase_offset",
                                 "cigi.wave_control.leading",
                                 "cigi.maritime_surface_conditions_control.entity_region_id",
                                 "cigi.maritime_surface_conditions_control.scope",
                                 "cigi.maritime_surface_conditions_control.sea_surface_height",
                                 "cigi.maritime_surface_conditions_control.surface_water_temp",
                                 "cigi.maritime_surface_conditions_control.surface_clarity"});
  EXPECT_EQ(text,
            "-3|123456|654321|42|513|2|7|772|1.5|-2.25|3.125|513|3|1|2|1.5|80|7.25|225|-45|12|9|2|"
            "0.5|12|60");
}

TEST_P(CigiTshark, ReadsEntitiesAndViews) {
  const std::string text = read({IgControl{},
                                 EntityControl{.entity = 258,
                                               .state = 1,
                                               .alpha = 200,
                                               .type = 772,
                                               .attached = true,
                                               .clamp = 2,
                                               .parent = 1286,
                                               .roll = 1.5f,
                                               .pitch = -2.5f,
                                               .yaw = 90,
                                               .latitude = 28.5,
                                               .longitude = -78.25,
                                               .altitude = 3},
                                 RateControl{.entity = 258,
                                             .part = 4,
                                             .x = 1.5f,
                                             .y = 2.5f,
                                             .z = 3.5f,
                                             .roll = 4.5f,
                                             .pitch = 5.5f,
                                             .yaw = 6.5f},
                                 ViewControl{.view = 11,
                                             .group = 2,
                                             .entity = 258,
                                             .x = 1.5f,
                                             .y = 2.5f,
                                             .z = -3.5f,
                                             .roll = 1,
                                             .pitch = 2,
                                             .yaw = 3},
                                 ViewDefinition{.view = 11,
                                                .group = 2,
                                                .mirror = 1,
                                                .type = 5,
                                                .nearPlane = 0.5f,
                                                .farPlane = 4000,
                                                .left = -30,
                                                .right = 30,
                                                .top = 20,
                                                .bottom = -20}},
                                {"cigi.entity_control.entity_id",
                                 "cigi.entity_control.alpha",
                                 "cigi.entity_control.entity_type",
                                 "cigi.entity_control.parent_id",
                                 "cigi.entity_control.ground_ocean_clamp",
                                 "cigi.entity_control.roll",
                                 "cigi.entity_control.pitch",
                                 "cigi.entity_control.yaw",
                                 "cigi.entity_control.lat_xoff",
                                 "cigi.entity_control.lon_yoff",
                                 "cigi.entity_control.alt_zoff",
                                 "cigi.rate_control.entity_id",
                                 "cigi.rate_control.part_id",
                                 "cigi.rate_control.x_rate",
                                 "cigi.rate_control.y_rate",
                                 "cigi.rate_control.z_rate",
                                 "cigi.rate_control.roll_rate",
                                 "cigi.rate_control.pitch_rate",
                                 "cigi.rate_control.yaw_rate",
                                 "cigi.view_control.group_id",
                                 "cigi.view_control.entity_id",
                                 "cigi.view_control.xoff",
                                 "cigi.view_control.yoff",
                                 "cigi.view_control.zoff",
                                 "cigi.view_control.yaw",
                                 "cigi.view_def.group_id",
                                 "cigi.view_def.mirror_mode",
                                 "cigi.view_def.near",
                                 "cigi.view_def.far",
                                 "cigi.view_def.left",
                                 "cigi.view_def.right",
                                 "cigi.view_def.top",
                                 "cigi.view_def.bottom"});
  EXPECT_EQ(text,
            "258|200|772|1286|2|1.5|-2.5|90|28.5|-78.25|3|258|4|1.5|2.5|3.5|4.5|5.5|6.5|2|258|1.5|"
            "2.5|-3.5|3|2|1|0.5|4000|-30|30|20|-20");
}

TEST_P(CigiTshark, ReadsWhatTheSeaAnswers) {
  const std::string text = read(
      {StartOfFrame{
           .databaseNumber = 5, .mode = 1, .igFrame = 77, .timestamp = 88, .lastHostFrame = 99},
       HatHotResponse{
           .request = 513, .valid = true, .ofTerrain = true, .hostFrame = 10, .height = -1.25},
       HatHotExtendedResponse{.request = 514,
                              .valid = true,
                              .hostFrame = 11,
                              .heightAbove = 2.5,
                              .heightOf = -3.5,
                              .material = 1,
                              .normalAzimuth = -135,
                              .normalElevation = 80},
       MaritimeSurfaceResponse{.request = 9, .height = 0.5f, .temperature = 12, .clarity = 60}},
      {"cigi.sof.db_number", "cigi.sof.ig_frame_number", "cigi.sof.timestamp",
       "cigi.sof.last_host_frame_number", "cigi.hat_hot_response.hat_hot_id",
       "cigi.hat_hot_response.host_frame_number_lsn", "cigi.hat_hot_response.height",
       "cigi.hat_hot_ext_response.hat_hot_id", "cigi.hat_hot_ext_response.host_frame_number_lsn",
       "cigi.hat_hot_ext_response.hat", "cigi.hat_hot_ext_response.hot",
       "cigi.hat_hot_ext_response.material_code", "cigi.hat_hot_ext_response.normal_vector_azimuth",
       "cigi.hat_hot_ext_response.normal_vector_elevation",
       "cigi.maritime_surface_conditions_response.request_id",
       "cigi.maritime_surface_conditions_response.sea_surface_height",
       "cigi.maritime_surface_conditions_response.surface_water_temp",
       "cigi.maritime_surface_conditions_response.surface_clarity"});
  EXPECT_EQ(text, "5|77|88|99|513|10|-1.25|514|11|2.5|-3.5|1|-135|80|9|0.5|12|60");
}

INSTANTIATE_TEST_SUITE_P(ByteOrders, CigiTshark,
                         ::testing::Values(ByteOrder::littleEndian, ByteOrder::bigEndian),
                         [](const auto& parameter) {
                           return parameter.param == ByteOrder::littleEndian ? "LittleEndian"
                                                                             : "BigEndian";
                         });

}  // namespace
}  // namespace seaway::bridge::cigi
