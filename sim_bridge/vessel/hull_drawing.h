#pragma once

#include "render/render_technique.h"
#include "sim_bridge/scene/vessel_model.h"

namespace seaway::bridge {

/// A vessel drawn as a mesh has it (VesselShape::mesh), its waterline at rest at z = 0: upward
/// faces in the deck's colour, what is under water at rest in red lead, the rest in the hull's; the
/// rooms of its hollows (roomsOf) keep the sea out. Throws InputError for a mesh that cannot be
/// read.
render::Mesh hullDrawing(const VesselModel& model);

}  // namespace seaway::bridge
