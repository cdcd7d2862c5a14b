#pragma once

#include <grpcpp/completion_queue.h>
#include <grpcpp/server_context.h>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <string>

#include "sim_bridge/grpc/lanes.h"
#include "sim_bridge/service/meter.h"

namespace seaway::bridge::rpc {

/// Something that a completion queue hands back.
class Arrival {
 public:
  virtual ~Arrival() = default;
  virtual void arrived(bool ok) = 0;
};

/// What the calls of a server share.
class CallHost {
 public:
  CallHost(Meter& counts, std::string token, std::size_t mostBytes)
      : meter(counts), mostMessageBytes(mostBytes), token_(std::move(token)) {}

  /// Throws RpcFault unless the call carries the token that is asked for.
  void authorise(const grpc::ServerContext& context) const;

  /// Slots that listen or answer; a queue is shut when there are none.
  void slotOpens();
  void slotCloses();
  void waitForSlots();

  Meter& meter;
  const std::size_t mostMessageBytes;  ///< of one message from a host
  Lanes lanes;
  std::atomic<bool> ending{false};  ///< no new call is listened for, streams end

 private:
  std::string token_;  // empty: none is asked for
  std::mutex mutex_;
  int slots_ = 0;
  std::condition_variable none_;
};

}  // namespace seaway::bridge::rpc
