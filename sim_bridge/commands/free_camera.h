#pragma once

#include "sim_bridge/commands/render.h"
#include "sim_bridge/scene/scene.h"

namespace seaway::bridge {

/// The camera that `--from` and its angles describe, as a fixed one named "free". Throws InputError
/// for values out of range.
SceneCamera freeCamera(const RenderOptions& options);

/// Throws InputError where angles of a free camera are given without `--from`.
void refuseFreeCameraOptions(const RenderOptions& options);

}  // namespace seaway::bridge
