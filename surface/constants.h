#pragma once

/// Physical constants shared by all layers. SI units.
namespace seaway {

/// Standard acceleration of gravity, m/s² (CGPM 1901).
inline constexpr double standardGravity = 9.80665;

/// Density of sea water at 15 °C and 35 g/kg, kg/m³ (ITTC 7.5-02-01-03).
inline constexpr double seaWaterDensity = 1026.0;

/// Mean radius of the Earth, m: curvature of the drawn sea.
inline constexpr double earthMeanRadius = 6371000.0;

inline constexpr double pi = 3.14159265358979323846;

}  // namespace seaway
