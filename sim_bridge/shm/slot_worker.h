#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>

#include "sim_bridge/shm/request_desk.h"
#include "sim_bridge/shm/segment.h"
#include "sim_bridge/shm/slot_pictures.h"

namespace seaway::bridge::shm {

/// Serves the hosts of one slot, one after the other, on a thread of its own, so that no host waits
/// for another. After an answer the thread looks for the next request for `spin` seconds, then
/// sleeps; a host that has died is found within 0.2 s of its last request, and its hulls go.
class SlotWorker {
 public:
  /// `segment` and `backing` outlive the worker.
  SlotWorker(Segment& segment, std::uint32_t slot, const Backing& backing, double spin);
  /// As stop().
  ~SlotWorker();

  /// Starts the thread where a host has come and it does not run; it ends by itself a second after
  /// the last host has gone. For one thread.
  void tend();
  /// Answers what has been asked, and ends.
  void stop();

  SlotPictures& pictures() { return pictures_; }

 private:
  enum class Ending { left, died, misbehaved };
  void run();
  void greet(std::uint32_t session);
  seaway_shm_status makeRoom();
  void letGo(Ending how);
  void expel();
  bool answerAsked();
  void waitForMore();
  void giveMemoryBack();
  bool stays(std::uint32_t asked) const;

  Segment& segment_;
  const std::uint32_t slot_;
  const Backing& backing_;
  const double spin_;
  RequestDesk desk_;
  SlotPictures pictures_;
  std::unique_ptr<HostSea> sea_;  // null for a host that is not served any more
  std::uint32_t session_ = 0;     // 0: no host
  std::uint32_t answered_ = 0;
  double heard_ = 0.0;  // s, when a host last asked, came or went
  bool usesMemory_ = false, warned_ = false;
  std::atomic<bool> stopping_{false}, running_{false};
  std::thread thread_;
};

}  // namespace seaway::bridge::shm
