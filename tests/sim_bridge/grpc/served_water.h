#pragma once

#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "seaway/v1/water.grpc.pb.h"
#include "sim_bridge/grpc/rpc_server.h"
#include "sim_bridge/grpc/water_service.h"
#include "sim_bridge/service/grpc_service.h"
#include "tests/sim_bridge/service/served_waters.h"

namespace seaway::bridge::test {

/// The scene of sceneText without wakes: its sea is a function of place and time alone.
inline std::string wakelessText() { return sceneText({{"run:", "effects: {wake: off}\nrun:"}}); }

/// A scene's sea behind a server of our own, and hosts of it.
struct ServedWater {
  explicit ServedWater(const std::string& text = wakelessText(), rpc::WaterLimits limits = {},
                       rpc::RpcServerOptions options = {}, const std::string& clock = "host")
      : waters(text), host{waters.sea, ServeClock::parse("--clock", clock), frames, limits} {
    options.option = "--grpc";
    if (options.address.empty()) options.address = "127.0.0.1:0";
    if (!options.credentials) options.credentials = grpc::InsecureServerCredentials();
    server = std::make_unique<rpc::RpcServer>(std::move(options), meter());
    rpc::addWaterService(*server, host);
    server->bind();
    server->start();
  }
  ~ServedWater() { server->stop(); }

  Meter& meter() { return waters.sea.meters().of("grpc"); }
  std::uint64_t refused(Refusal why) {
    return meter().read().refusals[static_cast<std::size_t>(why)];
  }

  std::shared_ptr<grpc::Channel> channel(
      std::shared_ptr<grpc::ChannelCredentials> credentials = nullptr) const {
    grpc::ChannelArguments arguments;
    arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);  // a connection of its own
    arguments.SetMaxReceiveMessageSize(-1);
    if (!credentials) credentials = grpc::InsecureChannelCredentials();
    return grpc::CreateCustomChannel(server->address(), credentials, arguments);
  }
  std::unique_ptr<v1::Water::Stub> stub() const { return v1::Water::NewStub(channel()); }

  ServedWaters waters;
  FrameMaker frames{waters.sea};
  rpc::WaterHost host;
  std::unique_ptr<rpc::RpcServer> server;
};

constexpr auto hangs = std::chrono::seconds(60);

/// A context that a test does not wait for longer than for something that hangs.
struct Context : grpc::ClientContext {
  Context() { set_deadline(std::chrono::system_clock::now() + hangs); }
};

inline v1::SampleRequest planeRequest(double t, std::size_t count, double spacing = 3.7) {
  v1::SampleRequest request;
  request.set_time_s(t);
  request.mutable_plane();
  for (std::size_t i = 0; i < count; ++i) {
    request.mutable_plane()->add_x_m(spacing * static_cast<double>(i % 97) - 150.0);
    request.mutable_plane()->add_y_m(0.1 * spacing * static_cast<double>(i));
  }
  return request;
}

inline std::vector<glm::dvec2> placesOf(const v1::SampleRequest& request) {
  std::vector<glm::dvec2> places;
  for (int i = 0; i < request.plane().x_m_size(); ++i) {
    places.emplace_back(request.plane().x_m(i), request.plane().y_m(i));
  }
  return places;
}

/// Waits until `condition` holds; false where that takes so long that something hangs.
template <class Condition>
bool eventually(Condition condition) {
  const auto end = std::chrono::steady_clock::now() + hangs;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

}  // namespace seaway::bridge::test
