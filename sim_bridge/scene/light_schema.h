#pragma once

#include "sim_bridge/scene/scene.h"
#include "sim_bridge/scene/schema.h"

namespace seaway::bridge {

Mapping<LightSettings> lightSchema();
Mapping<SceneLamp> lampSchema(const Mapping<Place>& place);
/// Of a vessel file.
Mapping<VesselLights> vesselLightsSchema();

}  // namespace seaway::bridge
