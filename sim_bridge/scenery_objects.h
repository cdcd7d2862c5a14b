#pragma once

#include "render/render_technique.h"
#include "sim_bridge/scene/scenery.h"
#include "surface/geodesy.h"
#include "surface/water_surface.h"

namespace seaway::bridge {

/// The mesh of a thing of the scenery as it is drawn: in metres, scaled, coloured.
render::Mesh sceneryMesh(const SceneryObject& object);

/// Where it is at a time: fixed, or, if it floats, on the water there, tilted as waves longer than
/// itself are. `mesh` must outlive what is returned.
render::SceneObject placedScenery(const SceneryObject& object, const render::Mesh& mesh,
                                  const Geodesy& geodesy, const WaterSurface& water, double time);

}  // namespace seaway::bridge
