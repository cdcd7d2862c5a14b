#pragma once

#include <cstdint>
#include <mutex>
#include <optional>

#include "sim_bridge/shm/host_sea.h"
#include "sim_bridge/shm/segment.h"

namespace seaway::bridge::shm {

/// The pictures that one slot's host asks for, one at a time. Thread-safe: the slot's worker says
/// who the host is, another thread draws.
class SlotPictures {
 public:
  /// `segment` outlives this.
  SlotPictures(Segment& segment, std::uint32_t slot) : segment_(segment), slot_(slot) {}

  void begin(std::uint32_t session);
  void end();

  struct Job {
    std::uint32_t session, number;
    seaway_shm_picture_request request;  ///< a copy, unchecked
  };
  /// What the host asks for and has not been given.
  std::optional<Job> asked();

  /// Where a job's picture of time `t` lies, once copied there for the host that asked, if that is
  /// still there. Throws `Refused` where the machine has no memory for it.
  seaway_shm_picture_answer stored(const Job& job, double t, const Picture& picture);
  /// Tells the host that asked, if that is still there.
  void answer(const Job& job, const seaway_shm_picture_answer& drawn);
  void refuse(const Job& job, const Refused& why);

 private:
  bool isFor(const Job& job) const { return session_ != 0 && session_ == job.session; }

  Segment& segment_;
  const std::uint32_t slot_;
  std::mutex mutex_;
  std::uint32_t session_ = 0;  // 0: no host
  std::uint32_t drawn_ = 0;
};

}  // namespace seaway::bridge::shm
