#pragma once

#include <memory>
#include <string>

#include "sim_bridge/service/endpoint.h"
#include "sim_bridge/service/frame_maker.h"
#include "sim_bridge/service/serve_clock.h"
#include "sim_bridge/service/served_sea.h"

namespace CLI {
class App;
}

namespace seaway::bridge {

/// What `seaway serve` is told about gRPC.
struct GrpcServiceOptions {
  std::string address;          ///< [HOST:]PORT or unix:PATH of seaway.v1.Water; empty: none
  std::string xdynAddress;      ///< of xdyn's Waves; empty: none
  std::string certificateFile;  ///< PEM
  std::string keyFile;          ///< PEM
  std::string tokenFile;
  bool insecure = false;            ///< beyond this machine without those
  std::size_t mostPoints = 250000;  ///< of a request
};

/// What gRPC needs of the process: first of all, before there are other threads.
void prepareGrpc(const GrpcServiceOptions& options);

void addGrpcOptions(CLI::App& command, GrpcServiceOptions& options);

/// seaway.v1.Water at `address`. Null where it is not asked for. What it is given must outlive it.
/// Throws InputError.
std::unique_ptr<Endpoint> makeGrpcEndpoint(const GrpcServiceOptions& options, ServedSea& sea,
                                           const ServeClock& clock, FrameMaker& frames);

/// xdyn's Waves at `xdynAddress`; likewise.
std::unique_ptr<Endpoint> makeXdynEndpoint(const GrpcServiceOptions& options, ServedSea& sea);

}  // namespace seaway::bridge
