#include "sim_bridge/vessel/wake_footprint.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim_bridge/vessel/vessel_mesh.h"
#include "surface/constants.h"
#include "surface/hull/section_outline.h"

namespace seaway::bridge {
namespace {

/// Heights of waterlines as parts of the draft; four are enough for waves of 2 m and more
/// (Wigley's hull in tests/surface/disturbance/hull_footprint_test.cpp).
constexpr std::array heights{0.0, -0.2, -0.4, -0.7, -1.0};

/// Where a section's line, which rises from the keel, is at height z: along and aside, m.
std::optional<glm::dvec2> at(std::span<const glm::vec3> section, double z) {
  for (std::size_t i = 0; i + 1 < section.size(); ++i) {
    const glm::dvec3 low(section[i]), high(section[i + 1]);
    if (z < low.z || z > high.z) continue;
    const double part = (z - low.z) / std::max(high.z - low.z, 1e-9);
    return glm::dvec2(glm::mix(low, high, part));
  }
  return std::nullopt;
}

/// Port side aft to forward, then starboard back. Sections whose keel is above have no water.
Waterline waterlineOf(const std::vector<LaunchSection>& sections, double z) {
  Waterline line{z, {}};
  for (const LaunchSection& section : sections) {
    if (const auto place = at(section, z)) line.outline.push_back(*place);
  }
  for (std::size_t i = line.outline.size(); i-- > 0;) {
    line.outline.emplace_back(line.outline[i].x, -line.outline[i].y);
  }
  return line;
}

HullFootprint launchFootprint(const BoxHull& hull) {
  const std::vector<LaunchSection> sections = launchSections(hull);
  std::vector<Waterline> lines;
  for (const double part : heights) lines.push_back(waterlineOf(sections, part * hull.draft()));
  return HullFootprint(std::move(lines));
}

/// A cone up to 0.3 of the draft, a cylinder above, as drawn.
HullFootprint buoyFootprint(const BoxHull& hull) {
  constexpr int corners = 32;
  std::vector<Waterline> lines;
  for (const auto& [height, part] : {std::pair(0.0, 1.0), {-0.3, 1.0}, {-1.0, 0.6}}) {
    Waterline line{height * hull.draft(), {}};
    for (int i = 0; i < corners; ++i) {
      const double angle = 2.0 * pi * i / corners;
      line.outline.emplace_back(0.5 * part * hull.length * std::cos(angle),
                                0.5 * part * hull.beam * std::sin(angle));
    }
    lines.push_back(std::move(line));
  }
  return HullFootprint(std::move(lines));
}

/// Convex outlines of the mesh's sections: right for hulls whose waterlines do not curve inwards.
HullFootprint meshFootprint(const VesselModel& model) {
  const auto hull = hullModelOf(model.mesh, model.hull);
  const double rest = hull->restHeight(), draft = -rest - hull->bounds().lower.z;
  std::vector<Waterline> lines;
  for (const double part : heights) {
    // A hair above the keel, where a flat bottom has its area.
    const double z = std::max(part, -0.999) * draft;
    lines.push_back({part * draft, sectionOutline(hull->mesh(), z - rest)});
  }
  return HullFootprint(std::move(lines));
}

}  // namespace

HullFootprint wakeFootprint(const VesselModel& model) {
  const BoxHull& hull = model.hull;
  switch (model.wake.form) {
    case WakeForm::box:
      return HullFootprint::box(hull.length, hull.beam, hull.draft());
    case WakeForm::wigley:
      return HullFootprint::wigley(hull.length, hull.beam, hull.draft());
    case WakeForm::drawn:
      break;
  }
  if (model.drawing.shape == VesselShape::mesh) return meshFootprint(model);
  return model.drawing.shape == VesselShape::buoy ? buoyFootprint(hull) : launchFootprint(hull);
}

}  // namespace seaway::bridge
