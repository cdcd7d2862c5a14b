#include "sim_bridge/service/metrics_service.h"

#include <gtest/gtest.h>
#include <httplib.h>

#include <asio.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "render/png.h"
#include "tests/sim_bridge/service/served_child.h"
#include "tests/sim_bridge/service/served_waters.h"

namespace seaway::bridge {
namespace {

using nlohmann::json;
using test::ServedWaters;

/// A served sea of one regular wave with its HTTP endpoint, in this process.
struct Watched {
  explicit Watched(const std::string& text = test::pilotScene("effects: {wake: off}\n"))
      : waters(text) {
    MetricsServiceOptions options;
    options.address = "0";
    endpoint = makeMetricsEndpoint(options, waters.sea, ServeClock::parse("--clock", "host"),
                                   frames, [] { return std::vector<std::string>{"one <door>"}; });
    endpoint->start();
    const std::string where = endpoint->description();
    port = std::stoi(where.substr(where.rfind(':') + 1));
  }
  httplib::Result get(const std::string& path) const {
    httplib::Client client("127.0.0.1", port);
    client.set_read_timeout(60);
    return client.Get(path);
  }
  std::string metric(const std::string& line) const {
    const std::string text = get("/metrics")->body;
    const std::size_t at = text.find("\n" + line + " ");
    if (at == std::string::npos) return "absent";
    const std::size_t value = at + line.size() + 2;
    return text.substr(value, text.find('\n', value) - value);
  }

  ServedWaters waters;
  FrameMaker frames{waters.sea};
  std::unique_ptr<Endpoint> endpoint;
  int port = 0;
};

TEST(MetricsService, TellsRequestsPointsLatenciesAndRefusalsByEndpoint) {
  Watched watched;
  Meter& meter = watched.waters.sea.meters().of("grpc");
  meter.answered(1000, 40e-6);
  meter.answered(24, 3e-3);
  meter.refused(Refusal::tooLarge);
  meter.frameSent(0.02);
  watched.waters.sea.meters().addEvents("cigi", [] {
    return std::vector<std::pair<std::string, std::uint64_t>>{{"lost", 7}};
  });
  EXPECT_EQ(watched.metric("seaway_points_total{endpoint=\"grpc\"}"), "1024");
  EXPECT_EQ(watched.metric("seaway_request_duration_seconds_count{endpoint=\"grpc\"}"), "2");
  EXPECT_EQ(
      watched.metric("seaway_request_duration_seconds_bucket{endpoint=\"grpc\",le=\"4e-05\"}"),
      "1");
  EXPECT_EQ(watched.metric("seaway_request_duration_seconds_bucket{endpoint=\"grpc\",le=\"+Inf\"}"),
            "2");
  EXPECT_EQ(watched.metric("seaway_refused_requests_total{endpoint=\"grpc\",reason=\"too_large\"}"),
            "1");
  EXPECT_EQ(watched.metric("seaway_frame_duration_seconds_count{endpoint=\"grpc\"}"), "1");
  EXPECT_EQ(watched.metric("seaway_endpoint_events_total{endpoint=\"cigi\",event=\"lost\"}"), "7");
  EXPECT_EQ(watched.metric("seaway_vessels"), "2");
  EXPECT_EQ(watched.metric("seaway_wakes_running"), "0");
}

TEST(MetricsService, StatusTellsTheSeaAskedAndRealised) {
  Watched watched(
      "sea: {anchor: {latitude_deg: 28.878, longitude_deg: -78.467}, seed: 7, state: "
      "{jonswap: {hm0_m: 1.12, tp_s: 5.6, from_deg: 196}}}\nrun: {}\n");
  const json status = json::parse(watched.get("/status.json")->body);
  EXPECT_EQ(status["sea"]["asked"]["hm0_m"], 1.12);
  EXPECT_EQ(status["sea"]["asked"]["tp_s"], 5.6);
  // 0.5 % of H_m0 (realisedSignificantWaveHeight). A buoy's two hours have the peak to its bins and
  // scatter, 10 %, and the direction to 5°.
  EXPECT_NEAR(status["sea"]["realised"]["hm0_m"].get<double>(), 1.12, 0.01 * 1.12);
  EXPECT_NEAR(status["sea"]["realised"]["tp_s"].get<double>(), 5.6, 0.56);
  EXPECT_NEAR(status["sea"]["realised"]["from_deg"].get<double>(), 196.0, 5.0);
  EXPECT_EQ(status["endpoints"], json({"one <door>"}));
  watched.waters.sea.setOctaves({});
  EXPECT_EQ(json::parse(watched.get("/status.json")->body)["sea"]["realised"]["hm0_m"], 0.0);
}

TEST(MetricsService, SendsACamerasPictureAtATime) {
  Watched watched;
  const auto answer = watched.get("/camera/mast.png?t=3&size=80x60");
  ASSERT_EQ(answer->status, 200);
  EXPECT_EQ(answer->get_header_value("Content-Type"), "image/png");
  const test::TempFolder folder;
  const auto picture = render::readPng(folder.write("mast.png", answer->body));
  const auto drawn = watched.frames.draw({.camera = "mast", .t = 3.0, .size = {80, 60}});
  EXPECT_EQ(picture.rgb, drawn->colour.rgb);
}

TEST(MetricsServiceHard, BadRequestsAreRefusedWithAReasonAndCounted) {
  Watched watched;
  const auto refused = [&](const std::string& path, int status, const std::string& why) {
    const auto answer = watched.get(path);
    ASSERT_TRUE(answer) << path;
    EXPECT_EQ(answer->status, status) << path;
    EXPECT_NE(answer->body.find(why), std::string::npos) << answer->body;
  };
  refused("/camera/stern.png", 404, "there is: bow, mast");
  refused("/?camera=stern", 404, "stern");
  refused("/camera/mast.png?t=soon", 400, "'soon' is not a number");
  refused("/camera/mast.png?t=nan", 400, "finite");
  refused("/camera/mast.png?size=9x", 400, "9x");
  refused("/camera/mast.png?size=8000x8000", 400, "not allowed");
  refused("/nowhere", 404, "404");
  EXPECT_EQ(watched.metric("seaway_refused_requests_total{endpoint=\"http\",reason=\"not_found\"}"),
            "3");
  EXPECT_EQ(watched.metric("seaway_refused_requests_total{endpoint=\"http\",reason=\"bad_value\"}"),
            "4");
}

TEST(MetricsServiceHard, WhatIsNoRequestIsCountedToo) {
  Watched watched;
  const auto counted = [&](const char* reason) {
    return std::stoi(watched.metric("seaway_refused_requests_total{endpoint=\"http\",reason=\"" +
                                    std::string(reason) + "\"}"));
  };
  const auto sendBytes = [&](const std::string& text) {
    asio::io_context context;
    asio::ip::tcp::socket socket(context);
    socket.connect({asio::ip::address_v4::loopback(), static_cast<std::uint16_t>(watched.port)});
    asio::write(socket, asio::buffer(text));
    char answer[256];
    asio::error_code ignored;
    const std::size_t size = socket.read_some(asio::buffer(answer), ignored);
    return std::string(answer, std::min<std::size_t>(size, 12));
  };
  EXPECT_EQ(counted("malformed"), 0);
  EXPECT_EQ(sendBytes("nonsense\r\n\r\n"), "HTTP/1.1 400");
  EXPECT_EQ(counted("malformed"), 1);
  EXPECT_EQ(counted("not_found"), 0);
  EXPECT_EQ(sendBytes("POST / HTTP/1.1\r\nContent-Length: 0\r\n\r\n"), "HTTP/1.1 404");
  EXPECT_EQ(counted("not_found"), 1);
}

TEST(MetricsServiceHard, MalformedHttpAndHalfOpenSocketsBlockNobody) {
  Watched watched;
  asio::io_context context;
  const asio::ip::tcp::endpoint where(asio::ip::address_v4::loopback(),
                                      static_cast<std::uint16_t>(watched.port));
  std::vector<asio::ip::tcp::socket> open;
  for (const std::string& text :
       {std::string("nonsense\r\n\r\n"), std::string("GET / HTTP/9.9\r\n\r\n"),
        std::string("GET /\0\xff HTTP/1.1\r\n\r\n", 20), std::string(100000, 'A'),
        std::string("POST / HTTP/1.1\r\nContent-Length: 99999999999\r\n\r\n"),
        std::string("GET / HTTP/1.1\r\nHost: a\r\n"), std::string()}) {
    asio::ip::tcp::socket socket(context);
    socket.connect(where);
    asio::error_code ignored;
    asio::write(socket, asio::buffer(text), ignored);
    open.push_back(std::move(socket));
    EXPECT_EQ(watched.get("/healthz")->body, "ok\n");
  }
}

TEST(MetricsServiceHard, AThousandConnectionsComeAndGo) {
  Watched watched;
  asio::io_context context;
  const asio::ip::tcp::endpoint where(asio::ip::address_v4::loopback(),
                                      static_cast<std::uint16_t>(watched.port));
  for (int i = 0; i < 1000; ++i) {
    asio::ip::tcp::socket socket(context);
    socket.connect(where);
    asio::error_code ignored;
    if (i % 3 != 0) {
      asio::write(socket, asio::buffer(std::string("GET /healthz HTTP/1.1\r\n\r\n")), ignored);
    }
    if (i % 3 == 1) {
      char answer[64];
      EXPECT_GT(socket.read_some(asio::buffer(answer), ignored), 0u);
    }
  }
  EXPECT_EQ(watched.get("/healthz")->body, "ok\n");
}

TEST(MetricsServiceHard, EndsUnderLoadAndWithAClientThatSaysNothing) {
  auto watched = std::make_unique<Watched>();
  asio::io_context context;
  asio::ip::tcp::socket silent(context);
  silent.connect({asio::ip::address_v4::loopback(), static_cast<std::uint16_t>(watched->port)});
  std::atomic<bool> ending = false;
  std::vector<std::thread> load;
  for (int i = 0; i < 3; ++i) {
    load.emplace_back([&, port = watched->port] {
      while (!ending) {
        httplib::Client("127.0.0.1", port).Get("/status.json");
        httplib::Client("127.0.0.1", port).Get("/camera/mast.png?size=32x24");
      }
    });
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  watched->endpoint->stop();
  ending = true;
  for (std::thread& thread : load) thread.join();
  watched = nullptr;
}

std::string domOf(const std::string& url) {
  const test::TempFolder folder;
  // A browser that waits for a server too slow for its virtual second would never end.
  const std::string command = "timeout 240 " + std::string(SEAWAY_CHROMIUM) +
                              " --headless --no-sandbox --disable-gpu --disable-dev-shm-usage "
                              "--user-data-dir='" +
                              (folder / "profile").string() +
                              "' --virtual-time-budget=1000 --dump-dom '" + url + "' >'" +
                              (folder / "dom").string() + "' 2>/dev/null";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  return test::readFile(folder / "dom");
}

TEST(StatusPage, ShowsRealValuesAndThePictureInABrowser) {
  if (std::string(SEAWAY_CHROMIUM).empty()) GTEST_SKIP() << "chromium is not installed";
  const std::string scene = std::string(SEAWAY_SOURCE_DIR) + "/configs/scenes/canaveral.yaml";
  test::ServedChild service(scene, {"--metrics", "0", "--cigi", "0", "--clock", "real"}, 2);
  const std::string dom = domOf("http://" + service.address("http://").text() + "/?camera=chase");
  const auto shows = [&](const std::string& text) {
    EXPECT_NE(dom.find(text), std::string::npos) << text << " is not in\n" << dom;
  };
  shows("<td>asked</td><td>1.12 m</td><td>5.6 s</td><td>196°</td>");
  shows("<td>realised</td><td>1.1");
  shows("CIGI 3.3 and 4.0 on udp 127.0.0.1:");
  shows("src=\"/camera/chase.png?t=");
  shows("<td>water</td>");
  shows("version 0.1.0");
  shows("<td>launch</td><td class=\"text\">its course</td>");
  EXPECT_EQ(service.end(SIGTERM), 0);
}

}  // namespace
}  // namespace seaway::bridge
