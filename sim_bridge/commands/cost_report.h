#pragma once

#include <string>
#include <vector>

#include "sim_bridge/cost/calibration.h"
#include "sim_bridge/cost/study.h"

namespace seaway::bridge {

/// The cost report as a self-contained HTML page: each study as a table, each dial as a figure of
/// error against cost with the scene's own setting marked, pictures as figures of pixel and metre
/// error against the grid's size and against cost, predicted against measured errors. Throws
/// std::runtime_error where figures cannot be drawn.
std::string costReport(const std::vector<Study>& studies, const Calibration& calibration,
                       const std::string& scene);

}  // namespace seaway::bridge
