#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

#include "sim_bridge/grpc/hosted_hulls.h"
#include "sim_bridge/grpc/rpc_fault.h"
#include "sim_bridge/service/frame_maker.h"
#include "sim_bridge/service/serve_clock.h"
#include "sim_bridge/service/served_sea.h"

namespace seaway::bridge::rpc {

struct WaterLimits {
  std::size_t points = 250000;  ///< a request
  std::uint32_t pixels = 4096;  ///< along each side of a picture
  std::size_t hulls = 64;       ///< a stream
  std::size_t places = 1000;    ///< of a step
  std::size_t octaves = 256;    ///< that a host may set
  int messageBytes = 64 << 20;  ///< of a request
};

/// The significant wave height that a host has asked for, and what it got. Thread-safe.
class AskedSea {
 public:
  void set(double asked, double realised) {
    const std::lock_guard lock(mutex_);
    asked_ = asked;
    realised_ = realised;
  }
  /// What was asked of a sea of that height; nothing where it was not this one.
  std::optional<double> of(double realised) const {
    const std::lock_guard lock(mutex_);
    return realised == realised_ ? std::optional(asked_) : std::nullopt;
  }

 private:
  mutable std::mutex mutex_;
  double asked_ = 0.0, realised_ = -1.0;  // m
};

/// What the methods of a Water service ask. What it refers to must outlive it.
struct WaterHost {
  ServedSea& sea;
  ServeClock clock;
  FrameMaker& frames;
  WaterLimits limits{};
  HostedHulls hulls{};
  AskedSea asked{};

  /// A request's own time, or, where it says none, the clock's. Throws RpcFault where there is
  /// neither.
  template <class Request>
  double timeOf(const Request& request) const {
    if (request.has_time_s()) return request.time_s();
    if (!clock.isHosts()) return clock.now();
    throw RpcFault(grpc::StatusCode::FAILED_PRECONDITION, Refusal::badValue,
                   "time_s: is missing, and the service has no clock of its own (--clock real)");
  }

  /// What leaves out a hull's own waves. Throws RpcFault where there is no such hull; 0 is none.
  std::uint32_t ownWakeOf(std::uint32_t hull, const char* field) const {
    if (hull == 0) return 0;
    if (!hulls.has(hull)) {
      throw RpcFault(grpc::StatusCode::NOT_FOUND, Refusal::notFound,
                     std::string(field) + ": " + std::to_string(hull) +
                         " is no hull now; must be one that SubmitPoses has answered with, and "
                         "whose stream is open");
    }
    return sea.ownWake(hull);
  }
};

}  // namespace seaway::bridge::rpc
