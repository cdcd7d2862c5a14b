#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "surface/field/octave.h"

namespace seaway {

/// An octave whose groups a current carries backwards.
struct BlockedOctave {
  double wavelength = 0.0;      ///< dominant, m
  double groupSpeed = 0.0;      ///< c_g in still water, m/s
  double currentAgainst = 0.0;  ///< component of the current against the octave, m/s, ≥ c_g
};

/// The group octaves and regular waves that a uniform current stops: its component against them is
/// no less than their group speed, so their energy cannot travel upstream. A field evaluates them
/// all the same, carried along by the current; in nature they would have broken on the way there
/// (wave blocking; Peregrine 1976, "Interaction of water waves and currents", section II).
///
/// `depth` m, > 0 or infinite; `current` m/s (east, north). Longest waves first. Octaves without
/// energy and Perlin octaves, which have no groups, are left out. Thread-safe.
std::vector<BlockedOctave> blockedOctaves(std::span<const Octave> octaves, double depth,
                                          glm::dvec2 current);

}  // namespace seaway
