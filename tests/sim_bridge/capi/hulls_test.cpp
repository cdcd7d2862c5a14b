#include <cmath>

#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene/sea.h"
#include "surface/hull/analytic_hulls.h"
#include "surface/hull/hull_loads.h"
#include "tests/sim_bridge/capi/support.h"

namespace seaway::bridge::test {
namespace {

seaway_hull_options threeTonnes() {
  seaway_hull_options options = seaway_hull_options_default();
  options.mass = 3e3;
  return options;
}

HullPointer hullFrom(const char* shape, const seaway_hull_options& options) {
  seaway_hull* hull = nullptr;
  EXPECT_EQ(seaway_hull_from_file(shape, &options, &hull), SEAWAY_OK) << seaway_last_error();
  return HullPointer(hull);
}

seaway_loads loadsOn(const seaway_sea* sea, const seaway_hull* hull, double t,
                     const seaway_body& body, const seaway_load_options* options = nullptr) {
  seaway_loads loads = seaway_loads_default();
  EXPECT_EQ(seaway_sea_hull_loads(sea, hull, t, &body, options, &loads), SEAWAY_OK)
      << seaway_last_error();
  return loads;
}

TEST(CapiHulls, FeelTheBitsOfTheLibrarysLoads) {
  const SeaPointer sea = seaFrom(openSea);
  const HullPointer hull = hullFrom("wigley:10,1,0.625,0.4", threeTonnes());
  ASSERT_TRUE(hull);
  seaway_body body = seaway_body_default();
  body.position[2] = -0.1;
  body.velocity[0] = 2.0;
  body.angular_velocity[1] = 0.05;
  seaway_load_options options = seaway_load_options_default();
  options.wind_east = -8.0;
  options.wind_north = 1.0;
  const seaway_loads loads = loadsOn(sea.get(), hull.get(), 6.0, body, &options);

  const Sea truth = buildSea(sceneFromText(openSea, "."));
  HullSettings settings;
  settings.mass = 3e3;
  const HullModel model(wigleyMesh(10, 1, 0.625, 0.4), settings);
  LoadScratch scratch;
  const HullLoads expected =
      seaway::loads(model, {{0, 0, -0.1}, {1, 0, 0, 0}, {2, 0, 0}, {0, 0.05, 0}}, truth.surface,
                    6.0, scratch, {.ownWake = 0, .wind = glm::dvec2(-8.0, 1.0)});
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(loads.force[i], expected.total().force[i]);
    EXPECT_EQ(loads.moment[i], expected.total().moment[i]);
    EXPECT_EQ(loads.wind_force[i], expected.wind.force[i]);
    EXPECT_EQ(loads.drag_moment[i], expected.drag.moment[i]);
  }
  EXPECT_EQ(loads.submerged_volume, expected.submergedVolume);
  EXPECT_EQ(loads.left_out, expected.leftOut);
}

TEST(CapiHulls, AreCarriedByTheirWeightOfStillWaterAtRest) {
  const SeaPointer sea = seaFrom(boats);
  seaway_hull* made = nullptr;
  ASSERT_EQ(seaway_hull_from_vessel(sea.get(), 0, &made), SEAWAY_OK) << seaway_last_error();
  const HullPointer hull(made);
  seaway_hull_facts facts = seaway_hull_facts_default();
  ASSERT_EQ(seaway_hull_describe(hull.get(), &facts), SEAWAY_OK);
  EXPECT_GT(facts.triangles, 100u);
  seaway_body body = seaway_body_default();
  body.position[2] = facts.rest_height;
  seaway_load_options options = seaway_load_options_default();
  options.own_vessel = 1;
  const seaway_loads loads = loadsOn(sea.get(), hull.get(), 0.0, body, &options);
  const double weight = facts.mass * 9.80665;
  EXPECT_NEAR(loads.buoyancy_force[2], weight, 1e-6 * weight);  // the solver's tolerance of rest
  EXPECT_NEAR(loads.submerged_volume, facts.rest_volume, 1e-6 * facts.rest_volume);
}

TEST(CapiHulls, ComeFromTriangles) {
  const double vertices[] = {-2, -1, -1, 2, -1, -1, 2, 1, -1, -2, 1, -1,
                             -2, -1, 1,  2, -1, 1,  2, 1, 1,  -2, 1, 1};
  const std::uint32_t triangles[] = {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                                     1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};
  seaway_hull_options options = seaway_hull_options_default();
  options.mass = 1026.0 * 8.0;  // half of 4 m x 2 m x 2 m
  seaway_hull* made = nullptr;
  ASSERT_EQ(seaway_hull_from_triangles(8, vertices, 12, triangles, &options, &made), SEAWAY_OK)
      << seaway_last_error();
  const HullPointer hull(made);
  seaway_hull_facts facts = seaway_hull_facts_default();
  ASSERT_EQ(seaway_hull_describe(hull.get(), &facts), SEAWAY_OK);
  EXPECT_EQ(facts.triangles, 12u);
  EXPECT_NEAR(facts.rest_height, 0.0, 1e-9);
  EXPECT_NEAR(facts.rest_volume, 8.0, 1e-9);
  EXPECT_EQ(facts.upper[0], 2.0);
}

TEST(CapiHulls, OutliveTheirSea) {
  SeaPointer sea = seaFrom(boats);
  seaway_hull* made = nullptr;
  ASSERT_EQ(seaway_hull_from_vessel(sea.get(), 0, &made), SEAWAY_OK);
  const HullPointer hull(made);
  sea.reset();
  seaway_hull_facts facts = seaway_hull_facts_default();
  EXPECT_EQ(seaway_hull_describe(hull.get(), &facts), SEAWAY_OK);
  EXPECT_GT(facts.mass, 0.0);
}

TEST(CapiHulls, RefuseWhatIsNoHull) {
  seaway_hull* hull = nullptr;
  seaway_hull_options options = threeTonnes();
  EXPECT_EQ(seaway_hull_from_file("wigley:10,1", &options, &hull), SEAWAY_BAD_INPUT);
  EXPECT_NE(std::string(seaway_last_error()).find("wigley:LENGTH"), std::string::npos);
  EXPECT_EQ(seaway_hull_from_file("no/such/hull.stl", &options, &hull), SEAWAY_BAD_INPUT);
  options.mass = 1e9;
  EXPECT_EQ(seaway_hull_from_file("box:4,2,2", &options, &hull), SEAWAY_BAD_INPUT);
  const double vertices[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::uint32_t open[] = {0, 1, 2}, wrong[] = {0, 1, 3};
  options = threeTonnes();
  EXPECT_EQ(seaway_hull_from_triangles(3, vertices, 1, open, &options, &hull), SEAWAY_BAD_INPUT);
  EXPECT_EQ(seaway_hull_from_triangles(3, vertices, 1, wrong, &options, &hull),
            SEAWAY_BAD_ARGUMENT);
  EXPECT_EQ(hull, nullptr);
}

}  // namespace
}  // namespace seaway::bridge::test
