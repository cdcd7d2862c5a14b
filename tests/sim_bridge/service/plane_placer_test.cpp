#include "sim_bridge/service/plane_placer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "surface/angles.h"

namespace seaway::bridge {
namespace {

/// Places up to a distance of an anchor, in its geodesy.
template <class Action>
void forRandomPlaces(const Geodesy& geodesy, double farthest, int count, Action action) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> angle(0.0, 2.0 * pi), part(0.0, 1.0);
  for (int i = 0; i < count; ++i) {
    const double distance = farthest * std::sqrt(part(random));
    action(geodesy.geodeticFromSeaPlane(distance * unitVector(angle(random))));
  }
}

TEST(PlanePlacer, PlacesPointsWhereTheGeodesicDoesWithinHalfAMillimetre) {
  for (const double latitude : {0.0, 28.878, -60.0, 75.0, 89.0}) {
    const Geodesy geodesy({latitude, 179.5, 0.0});
    PlanePlacer placer(geodesy);
    double worst = 0.0;
    double worstTurn = 0.0;
    forRandomPlaces(geodesy, 490e3, 20000, [&](const GeodeticPosition& at) {
      const SeaPlanePoint truth = geodesy.seaPlaneFromGeodetic(at.latitude_deg, at.longitude_deg);
      const PlacedPoint point = placer.place(at.latitude_deg, at.longitude_deg);
      worst = std::max(worst, glm::length(point.position - truth.position));
      worstTurn = std::max(worstTurn, glm::length(point.turn - unitVector(truth.convergence)));
    });
    EXPECT_LT(worst, 5e-4) << latitude;
    EXPECT_LT(worstTurn, 1e-5) << latitude;
  }
}

TEST(PlanePlacer, APointsPlaceDoesNotDependOnThoseBefore) {
  const Geodesy geodesy({28.878, -78.467, 0.0});
  PlanePlacer used(geodesy);
  forRandomPlaces(geodesy, 20e3, 2000, [&](const GeodeticPosition& at) {
    const PlacedPoint point = used.place(at.latitude_deg, at.longitude_deg);
    PlanePlacer fresh(geodesy);
    EXPECT_EQ(point.position, fresh.place(at.latitude_deg, at.longitude_deg).position);
  });
}

TEST(PlanePlacer, SmallTrueVectorsEndWhereTheGeodesicSays) {
  for (const double latitude : {28.878, -60.0}) {
    const Geodesy geodesy({latitude, -78.467, 0.0});
    PlanePlacer placer(geodesy);
    double worst = 0.0;
    forRandomPlaces(geodesy, 490e3, 500, [&](GeodeticPosition at) {
      const PlacedPoint point = placer.place(at.latitude_deg, at.longitude_deg);
      const glm::dmat3 enu = Geodesy::enuFromEcef(at);
      for (const glm::dvec2 offset : {glm::dvec2(100, 0), glm::dvec2(0, -100)}) {
        const GeodeticPosition end = Geodesy::geodeticFromEcef(
            Geodesy::ecefFromGeodetic(at) + glm::transpose(enu) * glm::dvec3(offset, 0.0));
        const glm::dvec2 truth =
            geodesy.seaPlaneFromGeodetic(end.latitude_deg, end.longitude_deg).position;
        worst = std::max(worst, glm::length(point.position + point.planeFromTrue(offset) - truth));
      }
    });
    // The expansion's own 0.2 mm, the place's 0.5 mm, and 100 m times the convergence's 1e-5.
    EXPECT_LT(worst, 1.7e-3) << latitude;
  }
}

TEST(PlanePlacerHard, WhatIsNoPlaceOrTooFarIsNaN) {
  const Geodesy geodesy({0.0, 0.0, 0.0});
  PlanePlacer placer(geodesy);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  for (const auto& [latitude, longitude] : {std::pair{nan, 0.0},
                                            {0.0, nan},
                                            {inf, 0.0},
                                            {0.0, -inf},
                                            {1e300, 1e300},
                                            {0.0, 5.0},
                                            {45.0, 0.0},
                                            {0.0, 180.0}}) {
    EXPECT_TRUE(std::isnan(placer.place(latitude, longitude).position.x)) << longitude;
  }
  EXPECT_EQ(placer.place(0.0, 360.0).position, placer.place(0.0, 0.0).position);
}

}  // namespace
}  // namespace seaway::bridge
