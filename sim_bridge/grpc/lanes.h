#pragma once

#include <functional>
#include <memory>

namespace seaway::bridge::rpc {

/// Where a request is answered.
enum class Lane {
  here,   ///< at once, by the thread that took it off the network: well below a millisecond
  large,  ///< by threads for large batches, as many as the machine has cores
  slow,   ///< by two threads for what takes a second: pictures, fits
};

/// Cores that the calling thread may run on; at least 1.
int coreCount();

/// The threads behind those lanes. Thread-safe.
class Lanes {
 public:
  Lanes();
  /// Waits for what was posted.
  ~Lanes();

  /// False where so much is waiting in the lane that more would only grow old; `work` is then not
  /// done. Not for Lane::here.
  bool post(Lane lane, std::function<void()> work);

  /// Of one lane, beyond what is being worked on.
  static constexpr int mostWaiting = 256;

 private:
  struct Threads;
  std::unique_ptr<Threads> large_, slow_;
};

}  // namespace seaway::bridge::rpc
