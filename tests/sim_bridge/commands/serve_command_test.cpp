#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene/sea.h"
#include "tests/sim_bridge/cigi/random_packets.h"
#include "tests/sim_bridge/cigi/udp_host.h"
#include "tests/sim_bridge/service/served_child.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

using namespace cigi;
using cigi::test::UdpSocket;
using seaway::bridge::test::ServedChild;
using seaway::bridge::test::TempFolder;
using seaway::bridge::test::writeScene;

constexpr int hangs = 20000;  // ms

std::vector<std::byte> ask(std::uint32_t frame, double t) {
  return cigi::test::datagramOf(
      {}, {IgControl{.mode = 1,
                     .timestampValid = true,
                     .hostFrame = frame,
                     .timestamp = static_cast<std::uint32_t>(std::llround(t * 1e5))},
           HatHotRequest{.request = 3, .type = 1, .latitude = 28.88, .longitude = -78.46}});
}

HatHotResponse answerIn(const std::vector<std::byte>& datagram) {
  const auto answers = cigi::test::packetsOf<HatHotResponse>(datagram);
  EXPECT_EQ(answers.size(), 1u);
  return answers.empty() ? HatHotResponse{} : answers[0];
}

TEST(ServeCommand, AnswersAHostFromTheScenesSeaAtTheHostsTimeAndEndsWithZero) {
  const TempFolder folder;
  const std::string file = writeScene(folder).string();
  // So slow that no Start of Frame comes by itself between two answers on a busy machine.
  ServedChild service(file, {"--cigi", "0", "--cigi-rate", "0.1"});
  const Scene scene = loadScene(file);
  const Sea sea = buildSea(scene);
  const glm::dvec2 place = sea.geodesy.seaPlaneFromGeodetic(28.88, -78.46).position;
  UdpSocket host;
  for (std::uint32_t frame = 1; frame <= 5; ++frame) {
    host.send(ask(frame, 2.5 * frame), service.address("udp "));
    const HatHotResponse answer = answerIn(host.receive(hangs));
    EXPECT_TRUE(answer.valid);
    // Half a millimetre of place (PlanePlacer), on slopes below 1.
    EXPECT_NEAR(answer.height, sea.surface.sample(place, 2.5 * frame).height, 5e-4);
  }
  EXPECT_EQ(service.end(SIGTERM), 0);
  EXPECT_NE(service.text().find("heights=5"), std::string::npos) << service.text();
}

TEST(ServeCommand, EndsWithZeroWhenInterruptedUnderLoad) {
  const TempFolder folder;
  ServedChild service(writeScene(folder).string(), {"--cigi", "127.0.0.1:0", "--clock", "x4"});
  UdpSocket host;
  const SocketAddress address = service.address("udp ");
  std::atomic<bool> ending = false;
  std::thread load([&] {
    for (std::uint32_t frame = 1; !ending; ++frame) {
      try {
        host.send(ask(frame, 0.0), address);
      } catch (const std::exception&) {
        // The port is closed by now.
      }
    }
  });
  EXPECT_FALSE(host.receive(hangs).empty());
  EXPECT_EQ(service.end(SIGINT), 0);
  ending = true;
  load.join();
}

TEST(ServeCommand, LogsOneJsonObjectALineWhereAsked) {
  const TempFolder folder;
  ServedChild service(writeScene(folder).string(), {"--cigi", "0", "--log-format", "json"});
  EXPECT_EQ(service.end(SIGTERM), 0);
  std::istringstream lines(service.text());
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    const auto message = nlohmann::json::parse(line);
    EXPECT_EQ(message["level"], "info");
    EXPECT_EQ(message["time"].get<std::string>().size(), 24u);
    EXPECT_FALSE(message["message"].get<std::string>().empty());
  }
  EXPECT_EQ(count, 3);
}

// The wave's own height tells which scene is served.
TEST(ServeCommandHard, ASceneIsReloadedUnderLoadAndABadOneChangesNothing) {
  const TempFolder folder;
  const std::string file = writeScene(folder).string();
  // So slow that no Start of Frame comes by itself between two answers on a busy machine.
  ServedChild service(file, {"--cigi", "0", "--cigi-rate", "0.1"});
  UdpSocket host;
  const SocketAddress address = service.address("udp ");
  std::uint32_t frame = 0;
  const auto height = [&] {
    host.send(ask(++frame, 2.5), address);
    return answerIn(host.receive(hangs)).height;
  };
  const double before = height();
  std::atomic<bool> ending = false;
  std::thread load([&] {
    UdpSocket other;
    for (std::uint32_t number = 1; !ending; ++number) {
      other.send(ask(number, 0.0), address);
      EXPECT_FALSE(other.receive(hangs).empty());
    }
  });
  folder.write("scene.yaml", seaway::bridge::test::sceneText({{"hm0_m: 1.12", "hm0_m: -1"}}));
  service.send(SIGHUP);
  service.awaitText("the scene stays as it was");
  service.awaitText("hm0_m");
  EXPECT_EQ(height(), before);
  folder.write("scene.yaml", seaway::bridge::test::sceneText({{"hm0_m: 1.12", "hm0_m: 2.24"}}));
  service.send(SIGHUP);
  service.awaitText("is loaded anew");
  // Twice the height: the same octaves of twice the amplitude, in single precision.
  EXPECT_NEAR(height(), 2.0 * before, 1e-3);
  ending = true;
  load.join();
  EXPECT_EQ(service.end(SIGTERM), 0);
}

TEST(ServeCommandHard, BadOptionsAndAPortInUseEndWithTwoAndAMessage) {
  const TempFolder folder;
  const std::string scene = writeScene(folder).string();
  const UdpSocket other;
  const std::string taken = other.address().text();
  const auto refused = [&](std::vector<std::string> options, const std::string& message) {
    options.insert(options.begin(), {"serve", scene});
    const auto outcome = seaway::bridge::test::seaway(options);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
  };
  refused({}, "nothing to serve");
  refused({"--cigi", taken}, taken);
  const asio::ip::tcp::endpoint any(asio::ip::address_v4::loopback(), 0);
  asio::io_context context;
  asio::ip::tcp::acceptor http(context, any);
  const std::string inUse = "127.0.0.1:" + std::to_string(http.local_endpoint().port());
  refused({"--cigi", "0", "--metrics", inUse}, inUse);
  refused({"--metrics", "70000"}, "--metrics: '70000' is not allowed");
  refused({"--cigi", "0", "--log-format", "xml"}, "--log-format: 'xml' is not allowed");
  refused({"--cigi", "70000"}, "--cigi: '70000' is not allowed");
  refused({"--cigi", "0", "--clock", "x0"}, "--clock: 'x0' is not allowed");
  refused({"--cigi", "0", "--cigi-pacing", "fast"}, "--cigi-pacing: 'fast' is not allowed");
  refused({"--cigi", "0", "--cigi-version", "3.2"}, "--cigi-version: '3.2' is not allowed");
  refused({"--cigi", "0", "--cigi-rate", "0"}, "--cigi-rate");
  refused({"--cigi", "0", "--cigi-host", "nowhere"}, "--cigi-host: 'nowhere' is not allowed");
}

}  // namespace
}  // namespace seaway::bridge
