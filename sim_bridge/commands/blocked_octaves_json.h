#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "surface/field/blocked_octaves.h"

namespace seaway::bridge {

/// Octaves that a current stops, as `run` and `query` report them; longest first.
inline nlohmann::ordered_json asJson(const std::vector<BlockedOctave>& blocked) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const BlockedOctave& octave : blocked) {
    list.push_back({{"wavelength_m", octave.wavelength},
                    {"group_speed_m_s", octave.groupSpeed},
                    {"current_against_m_s", octave.currentAgainst}});
  }
  return list;
}

}  // namespace seaway::bridge
