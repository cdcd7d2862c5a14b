#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim_bridge/cigi/codec.h"

namespace seaway::bridge::cigi {

/// What a host's frame number says about its datagram.
enum class Arrival : std::uint8_t {
  next,      ///< newer than all before
  repeated,  ///< the last one again, byte by byte
  late,      ///< older than one already served
  restart,   ///< the host has begun again
};

/// Follows the frame numbers of a host, which UDP may lose, double and reorder.
class HostFrames {
 public:
  /// `lost` becomes how many frames were passed over. A number behind the last is late, however far
  /// behind, until eight in a row are: then the host has begun again.
  Arrival arrival(std::uint32_t frame, Bytes datagram, std::uint32_t& lost);

 private:
  std::optional<std::uint32_t> last_;
  std::vector<std::byte> lastDatagram_;
  int lateInARow_ = 0;
};

/// A host's time, s, by its time stamps of 10 µs, which wrap after 12 hours, or, for frames without
/// one, by its frame numbers. Begins at the first time stamp, else at 0; from one frame to the next
/// it may go less than 6 hours either way.
class HostTime {
 public:
  double at(std::uint32_t frame, std::optional<std::uint32_t> timestamp, double framePeriod);

 private:
  bool begun_ = false;
  std::uint32_t frame_ = 0;
  std::optional<std::uint32_t> timestamp_;
  double origin_ = 0.0;     // s, what frames without a time stamp have added
  std::int64_t ticks_ = 0;  // the first time stamp and what further ones have added
};

}  // namespace seaway::bridge::cigi
