#pragma once

#include "sim_bridge/scene/scene.h"
#include "sim_bridge/vessel/course.h"
#include "surface/geodesy.h"

namespace seaway::bridge {

/// The course that a scene prescribes for a vessel.
Course courseOf(const SceneVessel& vessel, const Geodesy& geodesy);

}  // namespace seaway::bridge
