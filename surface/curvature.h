#pragma once

#include <algorithm>
#include <cmath>

#include "surface/constants.h"

/// The curved sea: renderer, unprojection and ray-march all bend the sea with these functions.
namespace seaway {

/// How far the sea's level lies below the tangent plane at the camera's foot, `distance` m away
/// along that plane: distance² / 2R, m ≥ 0.
///
/// A paraboloid instead of the sphere. It puts the horizon at a dip of atan √(2h/R) where the
/// sphere has acos(R/(R + h)): their tangents differ by a factor of 1 + h/4R, which is below a
/// tenth of a pixel (60° over 720 pixels) for eye heights up to 30 km
/// (tests/surface/curvature_test.cpp). Finite for every finite distance.
inline double seaDrop(double distance) { return distance * distance / (2.0 * earthMeanRadius); }

/// Distance from an eye at `height` m above still water to its horizon of still water, m.
inline double horizonDistance(double height) {
  return std::sqrt(2.0 * earthMeanRadius * std::max(height, 0.0));
}

/// Distance beyond which no crest of `bound` m shows above the horizon, m.
inline double crestReach(double height, double bound) {
  return horizonDistance(height) + horizonDistance(bound);
}

}  // namespace seaway
