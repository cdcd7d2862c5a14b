#pragma once

#include <vector>

#include "render/render_technique.h"
#include "sim_bridge/scene/vessel_model.h"
#include "sim_bridge/vessel/vessel_pose.h"

namespace seaway::bridge {

/// Adds the lights that a vessel shows, by the collision regulations (COLREG 1972, Rules 21–23 and
/// 30): arcs of 225° (masthead), 112.5° (sides) and 135° (stern), intensities for the ranges that
/// Rule 22 asks of its length. A second masthead light of vessels of 50 m and more is left out.
/// `isUnderWay` counts where the model says `auto`.
void addNavigationLights(const VesselModel& model, const VesselPose& pose, bool isUnderWay,
                         std::vector<render::Lamp>& lamps);

}  // namespace seaway::bridge
