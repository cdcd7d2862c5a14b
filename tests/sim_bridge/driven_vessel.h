#pragma once

#include <string>

namespace seaway::bridge::test {

/// A vessel file's text: a hull of 120 triangles with a propeller and a rudder.
inline const std::string drivenVessel = R"(hull:
  length_m: 12
  beam_m: 3.0
  depth_m: 1.8
  mass_kg: 13131
  centre_of_gravity_above_keel_m: 0.9
mesh: {source: "wigley:12,3,0.8,1", triangles: 120, form_drag: 0.2, level: mesh}
propeller: {diameter_m: 0.6, position_m: [-5, 0, -0.45], most_revolutions_s: 25}
rudder: {area_m2: 0.35, position_m: [-5.6, 0, -0.4], most_rate_deg_s: 15}
)";

}  // namespace seaway::bridge::test
