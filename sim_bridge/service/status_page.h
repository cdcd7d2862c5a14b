#pragma once

#include <string>

#include "sim_bridge/service/service_status.h"

namespace seaway::bridge {

/// A service's figures as a page for people, which brings itself up to date every two seconds. It
/// asks nobody but the service: `/` again, and `/camera/NAME.png?t=…` for `camera`; no picture
/// where that is empty.
std::string statusPage(const ServiceFigures& figures, const std::string& camera);

}  // namespace seaway::bridge
