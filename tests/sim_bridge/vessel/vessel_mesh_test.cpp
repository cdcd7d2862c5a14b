#include "sim_bridge/vessel/vessel_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace seaway::bridge {
namespace {

VesselModel model(VesselShape shape) {
  VesselModel made;
  made.hull.length = 12.0;
  made.hull.beam = 3.6;
  made.hull.depth = 2.0;
  made.hull.givenDraft = 0.55;
  made.drawing.shape = shape;
  return made;
}

TEST(VesselMesh, HasTheDimensionsOfItsBox) {
  for (const VesselShape shape :
       {VesselShape::launch, VesselShape::openLaunch, VesselShape::buoy}) {
    glm::vec3 least(1e9f);
    glm::vec3 most(-1e9f);
    const render::Mesh mesh = vesselMesh(model(shape));
    for (const auto& part : mesh.parts) {
      EXPECT_EQ(part.vertices.size() % 3, 0u);
      for (const glm::vec3& vertex : part.vertices) {
        ASSERT_TRUE(std::isfinite(vertex.x + vertex.y + vertex.z));
        least = glm::min(least, vertex);
        most = glm::max(most, vertex);
        EXPECT_LE(glm::length(vertex), mesh.boundingRadius + 1e-4);
      }
    }
    EXPECT_NEAR(most.x - least.x, 12.0, 1.0);  // the stem leans over the box's end
    EXPECT_NEAR(most.y - least.y, 3.6, 0.05);
    EXPECT_NEAR(least.z, -0.55, 0.01);
  }
}

TEST(VesselMesh, PlatingFacesOutwards) {
  const render::Mesh mesh = launchMesh(model(VesselShape::launch).hull, {});
  for (std::size_t part = 0; part < 2; ++part) {  // bottom, topsides
    const auto& vertices = mesh.parts[part].vertices;
    for (std::size_t i = 0; i < vertices.size(); i += 3) {
      const glm::vec3 centre = (vertices[i] + vertices[i + 1] + vertices[i + 2]) / 3.0f;
      const glm::vec3 normal =
          glm::cross(vertices[i + 1] - vertices[i], vertices[i + 2] - vertices[i]);
      if (std::abs(centre.y) < 0.3f) continue;  // keel, stem and transom cross the centreline
      EXPECT_GE(normal.y * centre.y, -1e-5f) << part << " " << centre.x;
    }
  }
}

TEST(VesselMesh, AnOpenLaunchHasAHollowInsideItsHullThatReachesBelowTheWaterline) {
  const render::Mesh mesh = vesselMesh(model(VesselShape::openLaunch));
  ASSERT_EQ(mesh.hollows.size(), 1u);
  const auto& planes = mesh.hollows[0].planes;
  ASSERT_LE(planes.size(), render::Mesh::Hollow::mostPlanes);
  const auto holds = [&](glm::vec3 place) {
    return std::all_of(planes.begin(), planes.end(), [&](const glm::vec4& plane) {
      return glm::dot(glm::vec3(plane), place) < plane.w;
    });
  };
  EXPECT_TRUE(holds({-3.5f, 0.0f, -0.1f}));
  EXPECT_TRUE(holds({-3.5f, 0.9f, 0.1f}));
  for (const auto& part : mesh.parts) {
    for (const glm::vec3& vertex : part.vertices) EXPECT_FALSE(holds(vertex));
  }
}

TEST(VesselMesh, DeckFacesUp) {
  const render::Mesh mesh = launchMesh(model(VesselShape::launch).hull, {});
  const auto& deck = mesh.parts[2].vertices;
  for (std::size_t i = 0; i < deck.size(); i += 3) {
    EXPECT_GE(glm::cross(deck[i + 1] - deck[i], deck[i + 2] - deck[i]).z, -1e-5f);
  }
}

}  // namespace
}  // namespace seaway::bridge
