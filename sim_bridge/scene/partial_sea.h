#pragma once

#include <cstddef>

#include "sim_bridge/scene/sea.h"

namespace seaway::bridge {

/// The sea of a scene with the `kept` largest of its octaves alone: the very waves that buildSea's
/// gives to who asks with a tolerance of WaveField::leftOut(kept). Throws as buildSea, warns of
/// nothing.
Sea buildPartialSea(const Scene& scene, std::size_t kept);

}  // namespace seaway::bridge
