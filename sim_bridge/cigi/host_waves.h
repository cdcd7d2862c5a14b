#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "sim_bridge/cigi/packets.h"
#include "sim_bridge/cigi/water.h"

namespace seaway::bridge::cigi {

/// The global waves that a host has enabled.
class HostWaves {
 public:
  /// False, and nothing is changed, for a wave that cannot be: not finite, of negative height, or
  /// with neither wavelength nor period above 0.
  bool set(const WaveControl& control);

  /// Whether the waves have changed since this was last asked; by rising number if so.
  bool changed(std::vector<HostWave>& waves);

 private:
  std::map<std::uint8_t, HostWave> waves_;
  bool changed_ = false;
};

}  // namespace seaway::bridge::cigi
