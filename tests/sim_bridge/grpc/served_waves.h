#pragma once

#include <memory>
#include <string>

#include "sim_bridge/grpc/xdyn_waves.h"
#include "tests/sim_bridge/grpc/served_water.h"
#include "wave_grpc.grpc.pb.h"

namespace seaway::bridge::test {

/// A scene's sea behind xdyn's service.
struct ServedWaves {
  explicit ServedWaves(const std::string& text = wakelessText()) : waters(text) {
    rpc::addXdynService(server, waves);
    server.bind();
    server.start();
    stub =
        Waves::NewStub(grpc::CreateChannel(server.address(), grpc::InsecureChannelCredentials()));
  }

  ServedWaters waters;
  rpc::XdynWaves waves{waters.sea, 1000};
  rpc::RpcServer server{{.option = "--xdyn",
                         .address = "127.0.0.1:0",
                         .credentials = grpc::InsecureServerCredentials(),
                         .token = ""},
                        waters.sea.meters().of("xdyn")};
  std::unique_ptr<Waves::Stub> stub;
};

}  // namespace seaway::bridge::test
