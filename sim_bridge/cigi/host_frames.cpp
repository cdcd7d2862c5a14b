#include "sim_bridge/cigi/host_frames.h"

#include <algorithm>

namespace seaway::bridge::cigi {
namespace {

constexpr int mostLateInARow = 8;
constexpr double ticksPerSecond = 1e5;

std::int32_t difference(std::uint32_t later, std::uint32_t earlier) {
  return static_cast<std::int32_t>(later - earlier);
}

}  // namespace

Arrival HostFrames::arrival(std::uint32_t frame, Bytes datagram, std::uint32_t& lost) {
  lost = 0;
  Arrival result = Arrival::next;
  if (last_) {
    const std::int32_t ahead = difference(frame, *last_);
    if (ahead == 0 &&
        std::equal(datagram.begin(), datagram.end(), lastDatagram_.begin(), lastDatagram_.end())) {
      return Arrival::repeated;
    }
    if (ahead < 0 && ++lateInARow_ < mostLateInARow) return Arrival::late;
    if (ahead < 0) result = Arrival::restart;
    if (ahead > 1) lost = static_cast<std::uint32_t>(ahead) - 1;
  }
  lateInARow_ = 0;
  last_ = frame;
  lastDatagram_.assign(datagram.begin(), datagram.end());
  return result;
}

double HostTime::at(std::uint32_t frame, std::optional<std::uint32_t> timestamp,
                    double framePeriod) {
  // Ticks are added up as integers: times stay multiples of a tick for as long as a host runs.
  if (timestamp && timestamp_) {
    ticks_ += difference(*timestamp, *timestamp_);
  } else if (timestamp && !begun_) {
    ticks_ = *timestamp;
  } else if (begun_) {
    origin_ += difference(frame, frame_) * framePeriod;
  }
  timestamp_ = timestamp;
  begun_ = true;
  frame_ = frame;
  return origin_ + static_cast<double>(ticks_) / ticksPerSecond;
}

}  // namespace seaway::bridge::cigi
