#pragma once

#include <string>
#include <vector>

#include "sim_bridge/cost/study.h"

namespace seaway::bridge {

/// The cost report as a self-contained HTML page: each study as a table, each dial as a figure of
/// error against cost, pictures as figures of pixel and metre error against the grid's size and
/// against cost. Throws std::runtime_error where figures cannot be drawn.
std::string costReport(const std::vector<Study>& studies, const std::string& scene);

}  // namespace seaway::bridge
