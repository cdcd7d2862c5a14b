#include "sim_bridge/vessel/box_hull.h"

#include <algorithm>
#include <cmath>

#include "sim_bridge/output/number_text.h"
#include "surface/constants.h"

namespace seaway::bridge {
namespace {

std::string metres(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g m", value);
  return text;
}

// Places of `count` columns along an edge of `size` m.
double columnPlace(int index, int count, double size) {
  const double outward = count / std::sqrt(static_cast<double>(count) * count - 1.0);
  return ((index + 0.5) / count - 0.5) * size * outward;
}

}  // namespace

double BoxHull::mass() const {
  return givenMass ? *givenMass : seaWaterDensity * waterplaneArea() * givenDraft.value_or(0.0);
}

double BoxHull::draft() const { return mass() / (seaWaterDensity * waterplaneArea()); }

double BoxHull::transverseMetacentricHeight() const {
  return draft() / 2.0 + beam * beam / (12.0 * draft()) - centreOfGravityAboveKeel;
}

double BoxHull::longitudinalMetacentricHeight() const {
  return draft() / 2.0 + length * length / (12.0 * draft()) - centreOfGravityAboveKeel;
}

double BoxHull::heaveFrequency() const { return std::sqrt(standardGravity / draft()); }

double BoxHull::rollFrequency() const {
  return std::sqrt(standardGravity * transverseMetacentricHeight()) / rollGyradius();
}

double BoxHull::pitchFrequency() const {
  return std::sqrt(standardGravity * longitudinalMetacentricHeight()) / pitchGyradius();
}

/// rad/s: a 1 mm cube of water's density heaves at 140.
constexpr double fastestMotion = 1000.0;

std::optional<std::string> BoxHull::fault() const {
  if (givenDraft.has_value() == givenMass.has_value()) {
    return "needs exactly one of draft_m and mass_kg";
  }
  if (draft() >= depth) {
    return "would sink: its draft of " + metres(draft()) + " is not below its depth of " +
           metres(depth);
  }
  const double least = std::min(transverseMetacentricHeight(), longitudinalMetacentricHeight());
  if (least <= 0.0) {
    return "would capsize at rest: its metacentric height is " + metres(least) +
           "; lower centre_of_gravity_above_keel_m";
  }
  const double fastest = std::max({heaveFrequency(), rollFrequency(), pitchFrequency()});
  if (!(fastest <= fastestMotion)) {
    return "would move too fast to be integrated: its natural frequency is " + numberText(fastest) +
           " rad/s, more than " + numberText(fastestMotion) + "; raise its draft or gyradii";
  }
  return std::nullopt;
}

std::vector<HullColumn> hullColumns(const BoxHull& hull) {
  std::vector<HullColumn> columns;
  const double area = hull.waterplaneArea() / (hull.columns.x * hull.columns.y);
  for (int along = 0; along < hull.columns.x; ++along) {
    for (int across = 0; across < hull.columns.y; ++across) {
      columns.push_back({{columnPlace(along, hull.columns.x, hull.length),
                          columnPlace(across, hull.columns.y, hull.beam)},
                         area});
    }
  }
  return columns;
}

}  // namespace seaway::bridge
