#pragma once

#include <string>
#include <vector>

#include "sim_bridge/cost/calibration.h"
#include "sim_bridge/cost/study.h"

namespace seaway::bridge {

/// Heights' error against cost, by number of octaves and by other ways to make a like sea, as SVG:
/// the report's first figure. Throws std::runtime_error where it cannot be drawn.
std::string heightErrorFigure(const std::vector<Study>& studies);

/// The cost report as a self-contained HTML page: what the figures advise, each study as a table,
/// each dial as a figure of error against cost with the scene's own setting marked, pictures as
/// figures of pixel and metre error against the grid's size and against cost, predicted against
/// measured errors. Throws std::runtime_error where figures cannot be drawn.
std::string costReport(const std::vector<Study>& studies, const Calibration& calibration,
                       const std::string& scene);

}  // namespace seaway::bridge
