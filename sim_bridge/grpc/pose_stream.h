#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "seaway/v1/water.pb.h"
#include "sim_bridge/grpc/water_host.h"

namespace seaway::bridge::rpc {

/// The hulls of one stream of SubmitPoses: they are there until `leave`. For one thread at a time.
class PoseStream {
 public:
  /// `host` must outlive the stream.
  explicit PoseStream(WaterHost& host) : host_(&host) {}
  PoseStream(PoseStream&& other) noexcept
      : host_(other.host_), hulls_(std::exchange(other.hulls_, {})) {}
  ~PoseStream() { leave(); }

  /// Places hulls, adds those that come by a new name, takes away those that are gone. All or,
  /// where something is not allowed, nothing. Throws RpcFault.
  void submit(const v1::PosesRequest& request, v1::PosesResponse& response);

  /// Takes all hulls away.
  void leave();

 private:
  void check(const v1::PosesRequest& request) const;
  std::size_t vesselOf(const v1::HullPose& pose, const std::string& field) const;
  std::uint32_t hullOf(const v1::HullPose& pose);
  void remove(const std::string& name);

  WaterHost* host_;
  std::map<std::string, std::uint32_t> hulls_;  // by the host's own name
};

}  // namespace seaway::bridge::rpc
