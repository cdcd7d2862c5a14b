#pragma once

#include <optional>
#include <vector>

#include "render/render_technique.h"

namespace seaway::render {

/// The effect that draws objects of a kind.
Effect effectOf(ObjectKind kind);

/// `view` without objects whose effect is switched off; where there are such, what is left is put
/// into `kept`, which must outlive what is returned.
View withoutSwitchedOff(const View& view, std::vector<SceneObject>& kept);

/// Decides on the meshes of scene objects with the view's ledger, each kind by its own effect.
/// Returns which effect pays for the pass that draws them all; empty: none is drawn.
std::optional<Effect> decideObjects(const View& view);

}  // namespace seaway::render
