#pragma once

#include "seaway/v1/water.pb.h"
#include "sim_bridge/grpc/water_host.h"

namespace seaway::bridge::rpc {

/// Answers one StepRequest at a time.
class WakeStep {
 public:
  /// `host` must outlive the step.
  explicit WakeStep(WaterHost& host) : host_(&host) {}

  /// Calls for the wakes when it is asked first; true, with the response filled, once they are
  /// where the request wants them, or at once where it does not wait. Throws RpcFault.
  bool isThere(const v1::StepRequest& request, v1::StepResponse& response);
  /// The next request is another.
  void forget() { called_ = false; }

 private:
  void call(const v1::StepRequest& request);

  WaterHost* host_;
  bool called_ = false;
  double time_ = 0.0;
};

}  // namespace seaway::bridge::rpc
