#pragma once

#include <string>

#include "sim_bridge/scene/scene.h"
#include "sim_bridge/vessel/free_vessel.h"
#include "surface/input_error.h"

namespace seaway::bridge {

/// What a scene says of a vessel a part of which is outside the sea's outline.
InputError aground(const Scene& scene, const std::string& vessel, double t);

/// Throws InputError where a free vessel has run ashore or onto the bed in its last `advance`, or
/// where a trough has laid the bed dry under it.
void requireFreeToMove(const Scene& scene, const std::string& name, const FreeVessel& vessel);

}  // namespace seaway::bridge
