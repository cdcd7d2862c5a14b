#pragma once

#include "sim_bridge/scene/scene.h"
#include "sim_bridge/scene/schema.h"

namespace seaway::bridge {

/// Keys of `sea.state` in a scene: exactly one kind of sea.
Mapping<SeaState> seaStateSchema();

}  // namespace seaway::bridge
