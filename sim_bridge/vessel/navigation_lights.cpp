#include "sim_bridge/vessel/navigation_lights.h"

#include "surface/angles.h"

namespace seaway::bridge {
namespace {

constexpr glm::vec3 white(1.0f, 0.88f, 0.70f), red(1.0f, 0.03f, 0.02f), green(0.02f, 1.0f, 0.25f),
    yellow(1.0f, 0.62f, 0.05f);

/// Candela that are seen at 1, 2, 3, 5 and 6 nautical miles (COLREG, Annex I, 8).
constexpr double oneMile = 0.9, twoMiles = 4.3, threeMiles = 12.0, fiveMiles = 52.0,
                 sixMiles = 94.0;

struct Intensities {
  double masthead, side, stern, allRound;
};

/// Rule 22.
Intensities intensitiesOf(double length) {
  if (length >= 50.0) return {sixMiles, threeMiles, threeMiles, threeMiles};
  if (length >= 20.0) return {fiveMiles, twoMiles, twoMiles, twoMiles};
  if (length >= 12.0) return {threeMiles, twoMiles, twoMiles, twoMiles};
  return {twoMiles, oneMile, twoMiles, twoMiles};
}

glm::dvec3 givenOr(glm::dvec3 given, glm::dvec3 otherwise) {
  return given == glm::dvec3(0.0) ? otherwise : given;
}

/// Places on the drawn launch, or on any hull of such a size: on the mast, on the sides of the
/// house, on the transom.
VesselLights placesOn(const VesselModel& model) {
  const double length = model.hull.length, freeboard = model.hull.depth - model.hull.draft();
  const bool isBuoy = model.drawing.shape == VesselShape::buoy;
  VesselLights lights = model.lights;
  lights.masthead =
      givenOr(lights.masthead, isBuoy ? glm::dvec3(0, 0, freeboard + 1.42 * length)
                                      : glm::dvec3(-0.02 * length, 0.0, freeboard + 0.30 * length));
  lights.sidelight =
      givenOr(lights.sidelight, {0.08 * length, 0.33 * model.hull.beam, freeboard + 0.13 * length});
  lights.stern = givenOr(lights.stern, {-0.51 * length, 0.0, 0.95 * freeboard});
  return lights;
}

LightsShown shownBy(const VesselModel& model, bool isUnderWay) {
  if (model.lights.shown != LightsShown::automatic) return model.lights.shown;
  if (model.drawing.shape == VesselShape::buoy) return LightsShown::atAnchor;
  return isUnderWay ? LightsShown::underWay : LightsShown::atAnchor;
}

}  // namespace

void addNavigationLights(const VesselModel& model, const VesselPose& pose, bool isUnderWay,
                         std::vector<render::Lamp>& lamps) {
  const LightsShown shown = shownBy(model, isUnderWay);
  if (shown == LightsShown::none) return;
  const VesselLights places = placesOn(model);
  const Intensities candela = intensitiesOf(model.hull.length);
  const glm::dquat worldFromBody = pose.worldFromBody();
  const auto add = [&](glm::dvec3 place, glm::vec3 colour, double intensity, double middle_deg,
                       double arc_deg) {
    const glm::dvec2 towards = unitVector(radiansFromDegrees(middle_deg));
    lamps.push_back({glm::dvec3(pose.position, pose.height) + worldFromBody * place, colour,
                     intensity, worldFromBody * glm::dvec3(towards, 0.0),
                     worldFromBody * glm::dvec3(0, 0, 1), radiansFromDegrees(arc_deg)});
  };
  if (shown == LightsShown::atAnchor) {
    const bool isBuoy = model.drawing.shape == VesselShape::buoy;
    add(places.masthead, isBuoy ? yellow : white, candela.allRound, 0.0, 360.0);
    return;
  }
  const glm::dvec3 starboard(places.sidelight.x, -places.sidelight.y, places.sidelight.z);
  add(places.masthead, white, candela.masthead, 0.0, 225.0);
  add(places.sidelight, red, candela.side, 56.25, 112.5);
  add(starboard, green, candela.side, -56.25, 112.5);
  add(places.stern, white, candela.stern, 180.0, 135.0);
}

}  // namespace seaway::bridge
