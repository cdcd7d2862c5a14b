#pragma once

#include "render/shading/shading_constants.h"

namespace seaway::render {

// Light of the night is given a thousand times brighter beside the sun's than it is: what the eye,
// used to the dark, makes of it, and what half floats carry.

/// Unit vector to what stands at an elevation and a direction, rad.
glm::vec3 skyDirection(double elevation, double direction);

/// A moon's irradiance over the sun's, by its phase: Allen's magnitudes as Krisciunas & Schaefer
/// 1991 (doi:10.1086/132921, Eq. 9) give them; falls off over the last degrees of the sun.
float moonPart(const Moon& moon, glm::vec3 sunDirection);

/// Puts the moon in the place of the sun, which is below the horizon.
void setMoon(ShadingConstants& c, const Lighting& lighting);

/// The lamps that the camera sees, at most ShadingConstants::mostLamps: those that are brightest
/// there.
void setLamps(ShadingConstants& c, const View& view);

/// Stars come out as the sun sinks from 7° to 14° below the horizon.
void setStars(ShadingConstants& c, const Lighting& lighting);

}  // namespace seaway::render
