#pragma once

#include <string>

#include "sim_bridge/service/service_status.h"

namespace seaway::bridge {

/// A service's figures in Prometheus' text format (version 0.0.4), names beginning with `seaway_`.
std::string metricsText(const ServiceFigures& figures);

}  // namespace seaway::bridge
