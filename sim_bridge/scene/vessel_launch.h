#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "sim_bridge/scene/scene.h"
#include "sim_bridge/scene/sea.h"
#include "sim_bridge/vessel/vessel.h"

namespace seaway::bridge {

/// Whether a vessel moves freely: it is to, and neither `hull_loads` nor `vessel_motion` is off.
bool sailsFreely(const Scene& scene, const SceneVessel& vessel);
bool anySailsFreely(const Scene& scene);

/// Why a vessel cannot steer to its waypoints; null where it can, or has none.
const char* whyUnsteered(const SceneVessel& vessel);

/// Velocity of the air over a scene, sea plane at its anchor, m/s; nothing where its direction is
/// not given.
std::optional<glm::dvec2> windOver(const Scene& scene, const Geodesy& geodesy);

/// A vessel free on its mesh at its start, at time 0, at rest in still water but for its speed;
/// under an autopilot where it has propeller and rudder. Throws InputError for a mesh that cannot
/// float and for waypoints without propeller and rudder.
FreeVessel launchFree(const Scene& scene, const SceneVessel& vessel, const Sea& sea);

/// The vessel as its scene has it move.
Vessel launch(const Scene& scene, const SceneVessel& vessel, const Sea& sea);

}  // namespace seaway::bridge
