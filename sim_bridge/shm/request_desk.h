#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim_bridge/shm/host_sea.h"

namespace seaway::bridge::shm {

/// Answers the requests in one host's cells. Each request is copied once and checked; points and
/// poses are copied before they are looked at, so that a host that writes meanwhile spoils its own
/// answer and nothing else. One thread at a time.
class RequestDesk {
 public:
  /// `backing` and `layout` outlive the desk.
  RequestDesk(const Backing& backing, const seaway_shm_header& layout);

  /// Answers the request `number` that lies in `cell` (layout.cell_size bytes), whatever is there;
  /// never throws.
  void answer(std::byte* cell, std::uint32_t number, HostSea& sea) noexcept;

 private:
  std::size_t answered(const seaway_shm_request& request, std::byte* arrays, HostSea& sea,
                       seaway_shm_answer& answer);
  void sample(const seaway_shm_request& request, double t, std::byte* arrays, HostSea& sea);
  void placeHulls(const seaway_shm_request& request, double t, const std::byte* arrays,
                  HostSea& sea);
  void describe(std::byte* arrays, const HostSea& sea, seaway_shm_answer& answer) const;

  const Backing& backing_;
  const seaway_shm_header& layout_;
  std::vector<double> x_, y_;
  std::vector<seaway_shm_pose> poses_;
};

/// A request's time by its flags. Throws Refused where the server has no clock.
double timeOf(const Backing& backing, double asked, std::uint32_t flags);

/// The text of a refusal, cut to its place.
void write(char (&to)[SEAWAY_SHM_TEXT], const std::string& message);

}  // namespace seaway::bridge::shm
