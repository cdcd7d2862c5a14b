#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <string>

#include "sim_bridge/scene/scene.h"
#include "sim_bridge/vessel/free_vessel.h"
#include "surface/input_error.h"
#include "surface/surface_sample.h"
#include "surface/terrain/terrain_map.h"

namespace seaway::bridge {

/// What a scene says of a vessel a part of which is outside the sea's outline.
InputError aground(const Scene& scene, const std::string& vessel, double t);

/// Throws InputError where terrain stands as high as a box's keel at one of the places that its
/// water was sampled at: the mean height of that water less the draft, m.
void requireClearOfGround(const Scene& scene, const std::string& vessel, double t, double draft,
                          const TerrainMap& terrain, std::span<const glm::dvec2> places,
                          std::span<const SurfaceSample> water);

/// Throws InputError where a free vessel has run ashore or onto the bed in its last `advance`, or
/// where a trough has laid the bed dry under it.
void requireFreeToMove(const Scene& scene, const std::string& name, const FreeVessel& vessel);

}  // namespace seaway::bridge
