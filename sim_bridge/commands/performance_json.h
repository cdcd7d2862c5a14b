#pragma once

#include <nlohmann/json.hpp>

#include "sim_bridge/scene/scene.h"

namespace seaway::bridge {

/// What is known of a performance, by the keys that scenes have; units are in their names.
nlohmann::ordered_json performanceJson(const Performance& performance);

}  // namespace seaway::bridge
