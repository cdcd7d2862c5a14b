#pragma once

#include "sim_bridge/scene/vessel_model.h"
#include "surface/disturbance/hull_footprint.h"

namespace seaway::bridge {

/// How a vessel's hull presses on the water, as its `wake.form` says: the lines below the water of
/// the hull that is drawn, its box, or Wigley's parabolic hull in the box's dimensions. Body frame
/// of BoxHull, m.
HullFootprint wakeFootprint(const VesselModel& model);

}  // namespace seaway::bridge
