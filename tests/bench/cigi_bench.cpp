#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "sim_bridge/cigi/sea_water.h"
#include "sim_bridge/cigi/udp_endpoint.h"
#include "tests/sim_bridge/cigi/random_packets.h"
#include "tests/sim_bridge/cigi/udp_host.h"

// What CIGI adds to the evaluation of the water: 33 requests in one datagram, on a sea of 12
// octaves. `--table` runs the cases in turn, so that each has the machine as the others have it,
// and prints medians, 99th percentiles and what is above the bare evaluation.
namespace seaway::bridge::cigi {
namespace {

constexpr std::size_t requests = 33;

Scene sceneOfTwelveOctaves() {
  Scene scene;
  scene.sea.anchor = {28.878, -78.467};
  scene.sea.seed = 7;
  ParametricState state;
  state.significantWaveHeight = 1.12;
  state.peakPeriod = 5.6;
  state.from_deg = 196.0;
  state.octaves = 12;
  scene.sea.state = state;
  return scene;
}

std::vector<std::byte> datagram(std::uint32_t frame, bool ofEntity, HeightKind kind) {
  std::vector<Packet> packets{
      IgControl{.mode = 1, .timestampValid = true, .hostFrame = frame, .timestamp = 1000 * frame},
      EntityControl{.entity = 9, .state = 1, .yaw = 30.0f, .latitude = 28.9, .longitude = -78.4}};
  for (std::size_t i = 0; i < requests; ++i) {
    const double n = static_cast<double>(i);
    packets.push_back(HatHotRequest{.request = static_cast<std::uint16_t>(i),
                                    .type = static_cast<std::uint8_t>(kind),
                                    .entityAxes = ofEntity,
                                    .entity = 9,
                                    .latitude = ofEntity ? n - 16.0 : 28.9 + 1e-5 * n,
                                    .longitude = ofEntity ? 0.2 * n : -78.4 + 1e-5 * n});
  }
  return test::datagramOf({}, packets);
}

/// A sea, and everything that stands between it and a host.
class Setup {
 public:
  Setup() {
    UdpOptions options;
    options.session.framePeriod = 3600.0;
    options.now = [] { return 0.0; };
    endpoint_ = std::make_unique<UdpEndpoint>(std::move(options), overNetwork_);
    endpoint_->start();
    for (std::size_t i = 0; i < requests; ++i) {
      points_.emplace_back(6000.0 + static_cast<double>(i), 2400.0);
    }
    samples_.resize(requests);
  }

  void evaluation() {
    sea_.surface()->sample(points_, 0.01 * ++frame_, samples_);
    benchmark::DoNotOptimize(samples_.data());
  }
  void session(bool ofEntity, HeightKind kind) {
    const auto asked = datagram(++frame_, ofEntity, kind);
    begin();
    benchmark::DoNotOptimize(&session_.receive(asked, 0.0));
    end();
  }
  void udp(bool ofEntity, HeightKind kind) {
    const auto asked = datagram(++frame_, ofEntity, kind);
    begin();
    host_.send(asked, endpoint_->address());
    const auto answer = host_.receive(10000);
    end();
    if (answer.empty()) std::abort();
  }
  void echo() {
    const auto asked = test::datagramOf({}, {IgControl{.hostFrame = ++frame_}});
    begin();
    host_.send(asked, endpoint_->address());
    if (host_.receive(10000).empty()) std::abort();
    end();
  }

  void begin() { begun_ = std::chrono::steady_clock::now(); }
  void end() { ended_ = std::chrono::steady_clock::now(); }
  double seconds() const { return std::chrono::duration<double>(ended_ - begun_).count(); }

 private:
  Scene scene_ = sceneOfTwelveOctaves();
  ServedSea sea_{scene_, buildSea(scene_)};
  SeaWater inProcess_{sea_}, overNetwork_{sea_};
  Counts counts_;
  CigiSession session_{{}, inProcess_, counts_};
  std::unique_ptr<UdpEndpoint> endpoint_;
  test::UdpSocket host_;
  std::vector<glm::dvec2> points_;
  std::vector<SurfaceSample> samples_;
  std::uint32_t frame_ = 0;
  std::chrono::steady_clock::time_point begun_, ended_;
};

struct Case {
  const char* name;
  std::function<void(Setup&)> run;
};

const std::vector<Case> cases{
    {"evaluation", [](Setup& s) { s.begin(), s.evaluation(), s.end(); }},
    {"session/entity", [](Setup& s) { s.session(true, HeightKind::ofTerrain); }},
    {"session/geodetic", [](Setup& s) { s.session(false, HeightKind::ofTerrain); }},
    {"session/entity/extended", [](Setup& s) { s.session(true, HeightKind::extended); }},
    {"udp/empty", [](Setup& s) { s.echo(); }},
    {"udp/entity", [](Setup& s) { s.udp(true, HeightKind::ofTerrain); }},
    {"udp/geodetic", [](Setup& s) { s.udp(false, HeightKind::ofTerrain); }},
    {"udp/entity/extended", [](Setup& s) { s.udp(true, HeightKind::extended); }},
};

void printTable() {
  constexpr int rounds = 5000;
  Setup setup;
  std::vector<std::vector<double>> us(cases.size());
  for (int round = -200; round < rounds; ++round) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
      cases[i].run(setup);
      if (round >= 0) us[i].push_back(1e6 * setup.seconds());
    }
  }
  std::printf("%zu requests, 12 octaves, %d rounds; us\n%-26s %8s %8s %22s\n", requests, rounds, "",
              "median", "p99", "above the evaluation");
  double evaluation = 0.0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    std::sort(us[i].begin(), us[i].end());
    const double median = us[i][rounds / 2];
    if (i == 0) evaluation = median;
    std::printf("%-26s %8.1f %8.1f %22.1f\n", cases[i].name, median, us[i][rounds * 99 / 100],
                median - evaluation);
  }
}

}  // namespace
}  // namespace seaway::bridge::cigi

int main(int argc, char** argv) {
  using namespace seaway::bridge::cigi;
  if (argc > 1 && std::strcmp(argv[1], "--table") == 0) {
    printTable();
    return 0;
  }
  benchmark::Initialize(&argc, argv);
  Setup setup;
  for (const Case& one : cases) {
    benchmark::RegisterBenchmark(one.name, [&](benchmark::State& state) {
      for (auto _ : state) {
        one.run(setup);
        state.SetIterationTime(setup.seconds());
      }
    })->UseManualTime();
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
