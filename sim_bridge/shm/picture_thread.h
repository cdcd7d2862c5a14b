#pragma once

#include <atomic>
#include <memory>
#include <span>
#include <thread>

#include "sim_bridge/shm/slot_worker.h"

namespace seaway::bridge::shm {

/// Draws what the hosts of all slots ask for, in turn, on a thread of its own, so that samples are
/// not held up.
class PictureThread {
 public:
  /// All outlive the thread.
  PictureThread(Segment& segment, std::span<const std::unique_ptr<SlotWorker>> workers,
                const Backing& backing);
  /// Finishes the picture at hand.
  ~PictureThread();

 private:
  void run();
  bool drawFor(SlotPictures& pictures);
  void refuse(SlotPictures& pictures, const SlotPictures::Job& job, const Refused& why);

  Segment& segment_;
  std::span<const std::unique_ptr<SlotWorker>> workers_;
  const Backing& backing_;
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

}  // namespace seaway::bridge::shm
