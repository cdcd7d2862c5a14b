#pragma once

#include <array>
#include <vector>

#include "render/render_technique.h"
#include "sim_bridge/scene/vessel_model.h"

namespace seaway::bridge {

/// The drawing of a vessel, built from its box's dimensions and colours, in its body frame (origin:
/// centre of the waterplane at rest). Parts are closed or seen from outside only.
render::Mesh vesselMesh(const VesselModel& model);

/// A launch: raked stem, flared bow, chine, sheer, transom; wheelhouse with windows; mast. An open
/// one has a cockpit abaft the wheelhouse, its floor below the waterline, and the hollow that keeps
/// the sea out of it.
render::Mesh launchMesh(const BoxHull& hull, const VesselDrawing& drawing);

/// One side of a launch's cross-section, upwards from the keel by the chine to the rail, body
/// frame, m.
using LaunchSection = std::array<glm::vec3, 3>;
/// The lines of the hull that launchMesh draws, from the transom to the stem.
std::vector<LaunchSection> launchSections(const BoxHull& hull);

/// A discus buoy: round hull, tripod tower with a lantern.
render::Mesh buoyMesh(const BoxHull& hull, const VesselDrawing& drawing);

}  // namespace seaway::bridge
