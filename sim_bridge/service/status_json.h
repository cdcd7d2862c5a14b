#pragma once

#include <string>

#include "sim_bridge/service/service_status.h"

namespace seaway::bridge {

/// A service's figures as JSON; units are in the keys, what is not known is null.
std::string statusJson(const ServiceFigures& figures);

}  // namespace seaway::bridge
