#pragma once

#include <glm/vec3.hpp>

#include "surface/hull/hull_loads.h"

namespace seaway::bridge {

/// A screw propeller. K_T falls linearly with the advance ratio, K_T = K₀ (1 − J/J₀), the same
/// ahead and astern; thrust scales with the part of the disc that is under water.
struct Propeller {
  double diameter = 0.0;           ///< m; 0: none
  glm::dvec3 position{0.0};        ///< of the disc's centre, body frame, m
  double bollardThrust = 0.4;      ///< K₀, K_T at J = 0
  double zeroThrustAdvance = 1.0;  ///< J₀: about 1.05 of the pitch ratio
  double wakeFraction = 0.2;       ///< w: inflow is (1 − w) of the speed through the water
  double thrustDeduction = 0.15;   ///< t: the hull feels (1 − t) of the thrust
  double mostRevolutions = 10.0;   ///< 1/s, either way
};

/// A rudder behind the propeller. Normal force ½ρA f_α V² sin α with Fujii's slope
/// f_α = 6.13 Λ/(Λ + 2.25), as in the MMG model (Yasukawa & Yoshimura 2015).
struct Rudder {
  double area = 0.0;            ///< m²; 0: none
  double aspectRatio = 1.5;     ///< Λ, height over chord
  glm::dvec3 position{0.0};     ///< body frame, m
  double mostAngle_deg = 35.0;  ///< either side
  double mostRate_deg = 5.0;    ///< °/s
};

/// What is asked of them.
struct Helm {
  double revolutions = 0.0;  ///< 1/s, negative astern
  double rudder = 0.0;       ///< rad, positive turns the bow to starboard
};

/// Force in the body frame and moment about its origin: N, N·m. `speed` and `turning` are those of
/// the origin through the water, body frame; `immersion` in [0, 1] the wet part of the disc.
Load propellerLoad(const Propeller& propeller, double revolutions, const glm::dvec3& speed,
                   double immersion);
/// The same of a rudder in the slipstream of a propeller that gives `thrust` N.
Load rudderLoad(const Rudder& rudder, double angle, const glm::dvec3& speed,
                const glm::dvec3& turning, const Propeller& propeller, double thrust);

}  // namespace seaway::bridge
