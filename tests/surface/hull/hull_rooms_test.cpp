#include "surface/hull/hull_rooms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "surface/hull/analytic_hulls.h"
#include "surface/hull/mesh_check.h"
#include "surface/input_error.h"

namespace seaway {
namespace {

bool isInside(const std::vector<HullRoom>& rooms, const glm::dvec3& point) {
  return std::any_of(rooms.begin(), rooms.end(), [&](const HullRoom& room) {
    return std::all_of(room.planes.begin(), room.planes.end(), [&](const glm::dvec4& plane) {
      return glm::dot(glm::dvec3(plane), point) < plane.w;
    });
  });
}

constexpr double length = 8.0, beam = 2.4, draft = 0.5, freeboard = 0.6, wall = 0.12;
constexpr double step = length / 160.0;  // of the lattice on which rooms are found

TriangleMesh openBoat() { return openWigleyMesh(length, beam, draft, freeboard, wall, 1200); }

/// Whether a point is within Wigley's form of a length, beam and draft; facets lie within.
bool isWithin(const glm::dvec3& p, double itsLength, double itsBeam, double itsDraft) {
  const double along = 2.0 * p.x / itsLength, down = std::clamp(p.z / itsDraft, -1.0, 0.0);
  const double half = 0.5 * itsBeam * (1.0 - along * along) * (1.0 - down * down);
  return p.z > -itsDraft && std::abs(along) < 1.0 && std::abs(p.y) < half;
}

TEST(HullRooms, FillTheHollowOfAnOpenBoatAndNoSeaOutsideIt) {
  const TriangleMesh boat = openBoat();
  ASSERT_TRUE(checkMesh(boat).watertight());
  ASSERT_TRUE(checkMesh(boat).facesOutward);
  const std::vector<HullRoom> rooms = roomsOf(boat);
  ASSERT_FALSE(rooms.empty());
  int hollow = 0, filled = 0, seaTaken = 0, sea = 0;
  for (double x = -4.2; x < 4.2; x += 0.061) {
    for (double y = -1.4; y < 1.4; y += 0.043) {
      // Where the sea may stand about it.
      for (double z = -0.3; z < 0.5; z += 0.07) {
        const glm::dvec3 point(x, y, z);
        const bool inside = isInside(rooms, point);
        if (isWithin(point, length - 2.0 * wall, beam - 2.0 * wall, draft - wall)) {
          ++hollow;
          filled += inside;
        } else if (!isWithin(point, length + 2.0 * step, beam + 2.0 * step, draft + step)) {
          ++sea;
          seaTaken += inside;
        }
      }
    }
  }
  ASSERT_GT(hollow, 10000);
  // Chords of six pieces along a parabola leave 4 % of it, half a lattice step all round 3 %.
  EXPECT_GT(filled, 0.9 * hollow) << filled << " of " << hollow;
  EXPECT_EQ(seaTaken, 0) << "of " << sea;
}

TEST(HullRooms, ADeckedHullHasNone) {
  EXPECT_TRUE(roomsOf(wigleyMesh(8.0, 2.4, 0.5, 0.6, 800)).empty());
  EXPECT_TRUE(roomsOf(boxMesh(4.0, 2.0, 1.0, 0.5, 300)).empty());
}

TEST(HullRooms, StayWithinThePlanesThatPicturesTake) {
  for (const HullRoom& room : roomsOf(openBoat())) {
    EXPECT_LE(room.planes.size(), 12u);
    for (const glm::dvec4& plane : room.planes) {
      EXPECT_NEAR(glm::length(glm::dvec3(plane)), 1.0, 1e-12);
    }
  }
}

TEST(HullRoomsHard, WallsThatCannotBeAreRefused) {
  EXPECT_THROW(openWigleyMesh(8.0, 2.4, 0.5, 0.6, 0.0), InputError);
  EXPECT_THROW(openWigleyMesh(8.0, 2.4, 0.5, 0.6, 0.5), InputError);
}

}  // namespace
}  // namespace seaway
