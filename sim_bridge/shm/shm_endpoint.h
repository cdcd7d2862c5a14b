#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "sim_bridge/service/endpoint.h"
#include "sim_bridge/shm/host_sea.h"
#include "sim_bridge/shm/segment.h"

namespace seaway::bridge::shm {

struct ShmOptions {
  std::string option = "--shm";  ///< begins the messages of InputError
  std::string name;              ///< of the segment
  SegmentSettings segment;
  /// s that a thread looks for a host's next request before it sleeps: a request that finds it
  /// awake is answered 10 to 20 µs sooner (tests/bench/shm_bench.cpp), a 1 kHz host costs 5 % of a
  /// core for it.
  double spin = 50e-6;
  Backing backing;
};

/// A sea in shared memory (seaway_shm_layout.h): a thread for each host that is connected, one for
/// pictures, one that sees to them. Where a host takes the memory away underneath or spoils the
/// header, a new segment of the same name is made, and hosts have to connect again.
class ShmEndpoint : public Endpoint {
 public:
  /// Makes the segment. Throws InputError where the name is in use or not allowed.
  explicit ShmEndpoint(ShmOptions options);
  ~ShmEndpoint() override;

  std::string description() const override;
  void start() override;
  void stop() override;

 private:
  class Serving;
  void keep();
  void replace();

  ShmOptions options_;
  std::mutex replacing_;
  std::unique_ptr<Serving> serving_;  // replaced by the keeper alone, under the lock
  std::atomic<bool> stopping_{false};
  std::thread keeper_;
};

}  // namespace seaway::bridge::shm
