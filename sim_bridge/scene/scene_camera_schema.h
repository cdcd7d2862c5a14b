#pragma once

#include "sim_bridge/scene/scene.h"
#include "sim_bridge/scene/schema.h"

namespace seaway::bridge {

/// Keys of one of a scene's `cameras`.
Mapping<SceneCamera> cameraSchema();

}  // namespace seaway::bridge
