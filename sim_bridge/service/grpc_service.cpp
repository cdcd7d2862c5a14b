#include "sim_bridge/service/grpc_service.h"

#include <CLI/CLI.hpp>

#include "sim_bridge/grpc/address_fault.h"
#include "sim_bridge/grpc/credentials.h"
#include "sim_bridge/grpc/rpc_server.h"
#include "sim_bridge/grpc/water_service.h"
#include "sim_bridge/grpc/xdyn_waves.h"
#include "sim_bridge/scene/schema.h"

namespace seaway::bridge {
namespace {

rpc::RpcSecurity securityOf(const GrpcServiceOptions& options) {
  return {options.certificateFile, options.keyFile, options.tokenFile, options.insecure};
}

rpc::RpcServerOptions serverOptions(const std::string& option, const std::string& address,
                                    rpc::RpcCredentials credentials) {
  return {.option = option,
          .address = address,
          .credentials = std::move(credentials.server),
          .token = std::move(credentials.token)};
}

class WaterEndpoint : public Endpoint {
 public:
  WaterEndpoint(rpc::RpcServerOptions server, rpc::WaterLimits limits, ServedSea& sea,
                const ServeClock& clock, FrameMaker& frames)
      : host_{sea, clock, frames, limits}, server_(std::move(server), sea.meters().of("grpc")) {
    rpc::addWaterService(server_, host_);
    server_.bind();
  }
  std::string description() const override { return "gRPC at " + server_.address(); }
  void start() override { server_.start(); }
  void stop() override { server_.stop(); }

 private:
  rpc::WaterHost host_;
  rpc::RpcServer server_;
};

class XdynEndpoint : public Endpoint {
 public:
  XdynEndpoint(rpc::RpcServerOptions server, std::size_t mostPoints, ServedSea& sea)
      : waves_(sea, mostPoints), server_(std::move(server), sea.meters().of("xdyn")) {
    rpc::addXdynService(server_, waves_);
    server_.bind();
  }
  std::string description() const override { return "xdyn's waves at " + server_.address(); }
  void start() override { server_.start(); }
  void stop() override { server_.stop(); }

 private:
  rpc::XdynWaves waves_;
  rpc::RpcServer server_;
};

void requirePoints(const GrpcServiceOptions& options) {
  // 2e6 points with heights are 48 MB of a message's 64 MiB.
  requireInRange("--grpc-most-points", static_cast<double>(options.mostPoints),
                 Range::within(1.0, 2e6), "points");
}

}  // namespace

void prepareGrpc(const GrpcServiceOptions& options) {
  if (!options.address.empty() || !options.xdynAddress.empty()) rpc::prepareRpcProcess();
}

void addGrpcOptions(CLI::App& command, GrpcServiceOptions& options) {
  const char* group = "gRPC";
  const auto add = [&](const char* name, auto& value, const char* help) {
    return command.add_option(name, value, help)->group(group);
  };
  add("--grpc", options.address, "[HOST:]PORT or unix:PATH to serve seaway.v1.Water on");
  add("--xdyn", options.xdynAddress, "[HOST:]PORT or unix:PATH to serve xdyn's Waves on");
  add("--grpc-tls-cert", options.certificateFile, "PEM file with the certificate of --grpc");
  add("--grpc-tls-key", options.keyFile, "PEM file with its key");
  add("--grpc-token-file", options.tokenFile,
      "file with the token that calls must carry as `authorization: Bearer TOKEN`");
  command
      .add_flag("--grpc-insecure", options.insecure,
                "serve --grpc and --xdyn beyond this machine without TLS or without a token")
      ->group(group);
  add("--grpc-most-points", options.mostPoints, "points of one request, at most 2000000")
      ->capture_default_str();
}

std::unique_ptr<Endpoint> makeGrpcEndpoint(const GrpcServiceOptions& options, ServedSea& sea,
                                           const ServeClock& clock, FrameMaker& frames) {
  requirePoints(options);
  if (options.address.empty()) return nullptr;
  const std::string address = rpc::rpcAddress("--grpc", options.address);
  rpc::WaterLimits limits;
  limits.points = options.mostPoints;
  return std::make_unique<WaterEndpoint>(
      serverOptions("--grpc", address,
                    rpc::makeCredentials("--grpc", address, securityOf(options))),
      limits, sea, clock, frames);
}

std::unique_ptr<Endpoint> makeXdynEndpoint(const GrpcServiceOptions& options, ServedSea& sea) {
  requirePoints(options);
  if (options.xdynAddress.empty()) return nullptr;
  const std::string address = rpc::rpcAddress("--xdyn", options.xdynAddress);
  return std::make_unique<XdynEndpoint>(
      serverOptions("--xdyn", address,
                    rpc::makeOpenCredentials("--xdyn", address, securityOf(options))),
      options.mostPoints, sea);
}

}  // namespace seaway::bridge
