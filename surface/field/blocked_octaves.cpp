#include "surface/field/blocked_octaves.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "surface/angles.h"
#include "surface/dispersion.h"

namespace seaway {

std::vector<BlockedOctave> blockedOctaves(std::span<const Octave> octaves, double depth,
                                          glm::dvec2 current) {
  std::vector<BlockedOctave> blocked;
  for (const Octave& octave : octaves) {
    if (octave.kind == OctaveKind::perlin || octave.standardDeviation == 0.0) continue;
    const double speed = groupSpeed(octave.waveNumber, depth);
    const double against = -glm::dot(current, unitVector(octave.toward));
    if (against >= speed) blocked.push_back({dominantWavelength(octave), speed, against});
  }
  std::sort(blocked.begin(), blocked.end(),
            [](const auto& a, const auto& b) { return a.wavelength > b.wavelength; });
  return blocked;
}

}  // namespace seaway
