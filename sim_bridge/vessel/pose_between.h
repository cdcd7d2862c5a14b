#pragma once

#include <cmath>
#include <glm/common.hpp>

#include "sim_bridge/vessel/vessel_pose.h"
#include "surface/constants.h"

namespace seaway::bridge {

/// The pose a part of the way from `a` to `b`, each angle the short way round; a part above 1 goes
/// on beyond `b`.
inline VesselPose poseBetween(const VesselPose& a, const VesselPose& b, double part) {
  const auto turned = [&](double from, double to) {
    return from + part * std::remainder(to - from, 2.0 * pi);
  };
  return {glm::mix(a.position, b.position, part), turned(a.direction, b.direction),
          glm::mix(a.height, b.height, part), turned(a.pitch, b.pitch), turned(a.roll, b.roll)};
}

}  // namespace seaway::bridge
