#pragma once

#include <atomic>
#include <chrono>

#include "sim_bridge/grpc/rpc_fault.h"

namespace seaway::bridge::rpc {

/// Whether a call is still worth working for. `check` in one thread while another cancels.
class CallWatch {
 public:
  void renew() { cancelled_ = false; }
  void setDeadline(std::chrono::system_clock::time_point deadline) { deadline_ = deadline; }
  void cancel() { cancelled_ = true; }

  /// Throws RpcFault where the host has gone or its deadline has passed: to be called between
  /// pieces of work of about a millisecond.
  void check() const {
    const bool late = std::chrono::system_clock::now() >= deadline_;
    if (!late && !cancelled_) return;
    throw RpcFault(late ? grpc::StatusCode::DEADLINE_EXCEEDED : grpc::StatusCode::CANCELLED,
                   Refusal::tooLate,
                   late ? "the deadline has passed; the rest was left undone"
                        : "the call was cancelled; the rest was left undone");
  }

 private:
  std::chrono::system_clock::time_point deadline_;
  std::atomic<bool> cancelled_{false};
};

}  // namespace seaway::bridge::rpc
