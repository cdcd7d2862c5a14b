#include <cmath>
#include <cstring>

#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene/sea.h"
#include "surface/surface_ray.h"
#include "surface/water_kinematics.h"
#include "tests/sim_bridge/capi/support.h"
#include "tests/support/allocation_counter.h"

namespace seaway::bridge::test {
namespace {

const Sea& librarysSea() {
  static const Sea sea = buildSea(sceneFromText(openSea, SEAWAY_SOURCE_DIR "/configs/scenes"));
  return sea;
}

const seaway_sea* openWater() {
  static const SeaPointer sea = seaFrom(openSea);
  return sea.get();
}

std::vector<glm::dvec2> placesOf(const Line& line) {
  std::vector<glm::dvec2> places;
  for (std::size_t i = 0; i < line.east.size(); ++i)
    places.emplace_back(line.east[i], line.north[i]);
  return places;
}

/// Every field of an answer, one array each.
struct Answers {
  std::vector<double> fields[9];
  std::vector<std::uint32_t> status;
  explicit Answers(std::size_t count) : status(count, 77u) {
    for (auto& field : fields) field.assign(count, -777.0);
  }
  seaway_samples samples() {
    seaway_samples out = seaway_samples_default();
    double** const pointers[] = {
        &out.height,       &out.slope_east,    &out.slope_north, &out.vertical_velocity,
        &out.orbital_east, &out.orbital_north, &out.orbital_up,  &out.error,
        &out.bound};
    for (std::size_t i = 0; i < 9; ++i) *pointers[i] = fields[i].data();
    out.status = status.data();
    return out;
  }
};

TEST(CapiSampling, GivesTheBitsOfTheLibrary) {
  const Line line(1000);
  Answers answers(1000);
  const seaway_points points = line.points();
  const seaway_samples out = answers.samples();
  ASSERT_EQ(seaway_sea_sample(openWater(), 12.5, &points, nullptr, &out), SEAWAY_OK);
  std::vector<SurfaceSample> truth(1000);
  librarysSea().surface.sample(placesOf(line), 12.5, truth, {.orbitalVelocity = true});
  for (std::size_t i = 0; i < 1000; ++i) {
    const SurfaceSample& s = truth[i];
    const double expected[] = {s.height,
                               s.slope.x,
                               s.slope.y,
                               s.verticalVelocity,
                               s.orbitalVelocity.x,
                               s.orbitalVelocity.y,
                               s.orbitalVelocity.z,
                               s.error,
                               s.bound};
    for (std::size_t k = 0; k < 9; ++k)
      EXPECT_EQ(answers.fields[k][i], expected[k]) << i << " " << k;
    EXPECT_EQ(answers.status[i], static_cast<std::uint32_t>(s.status));
  }
}

TEST(CapiSampling, GivesTheSameBitsWithoutOrbitalVelocity) {
  Line line(700);
  line.east[5] = NAN;
  line.north[300] = 2e12;
  for (const double tolerance : {0.0, 0.07}) {
    for (const double t : {12.5, static_cast<double>(INFINITY)}) {
      Answers answers(700);
      const seaway_points points = line.points();
      seaway_samples out = answers.samples();
      out.orbital_east = out.orbital_north = out.orbital_up = nullptr;
      seaway_sample_options options = seaway_sample_options_default();
      options.tolerance = tolerance;
      ASSERT_EQ(seaway_sea_sample(openWater(), t, &points, &options, &out), SEAWAY_OK);
      std::vector<SurfaceSample> truth(700);
      librarysSea().surface.sample(placesOf(line), t, truth, {.tolerance = tolerance});
      for (std::size_t i = 0; i < 700; ++i) {
        const SurfaceSample& s = truth[i];
        const double expected[] = {s.height,           s.slope.x, s.slope.y,
                                   s.verticalVelocity, s.error,   s.bound};
        const double given[] = {answers.fields[0][i], answers.fields[1][i], answers.fields[2][i],
                                answers.fields[3][i], answers.fields[7][i], answers.fields[8][i]};
        for (std::size_t k = 0; k < 6; ++k) {
          EXPECT_TRUE(given[k] == expected[k] || (std::isnan(given[k]) && std::isnan(expected[k])))
              << i << " " << k << " " << given[k] << " " << expected[k];
        }
        EXPECT_EQ(answers.status[i], static_cast<std::uint32_t>(s.status)) << i;
      }
    }
  }
}

TEST(CapiSampling, ThreadsGiveTheSameBits) {
  const Line line(30000, 0.83);
  seaway_sample_options options = seaway_sample_options_default();
  const std::vector<double> alone = heightsOf(openWater(), 3.0, line.points(), &options);
  options.parallel = 1;
  EXPECT_EQ(heightsOf(openWater(), 3.0, line.points(), &options), alone);
}

TEST(CapiSampling, LeavesOutWhatATolerancePermitsAndSaysSo) {
  const Line line(50);
  const seaway_points points = line.points();
  seaway_sample_options options = seaway_sample_options_default();
  options.tolerance = 0.1;
  Answers answers(50);
  const seaway_samples out = answers.samples();
  ASSERT_EQ(seaway_sea_sample(openWater(), 1.0, &points, &options, &out), SEAWAY_OK);
  const SurfaceSample truth =
      librarysSea().surface.sample({line.east[0], line.north[0]}, 1.0, {.tolerance = 0.1});
  EXPECT_EQ(answers.fields[0][0], truth.height);
  EXPECT_GT(answers.fields[7][0], 0.0);
  EXPECT_LE(answers.fields[7][0], 0.1);
  EXPECT_EQ(answers.status[0], SEAWAY_SAMPLE_TRUNCATED);
}

TEST(CapiSampling, PassesOverPointsThatAreNotWanted) {
  const Line line(700);
  std::vector<std::uint8_t> wanted(700);
  for (std::size_t i = 0; i < 700; ++i) wanted[i] = i % 3 == 1;
  seaway_points points = line.points();
  const std::vector<double> all = heightsOf(openWater(), 2.0, points);
  points.wanted = wanted.data();
  const std::vector<double> some = heightsOf(openWater(), 2.0, points);
  for (std::size_t i = 0; i < 700; ++i) EXPECT_EQ(some[i], wanted[i] ? all[i] : -777.0) << i;
}

TEST(CapiSampling, AnswersGeodeticPointsInTrueEastAndNorth) {
  const double latitude_deg[] = {30.2, 28.878, 30.2}, longitude_deg[] = {-77.0, -78.467, 90.0};
  seaway_points points = seaway_points_default();
  points.frame = SEAWAY_GEODETIC;
  points.count = 3;
  points.first = latitude_deg;
  points.second = longitude_deg;
  Answers answers(3);
  const seaway_samples out = answers.samples();
  ASSERT_EQ(seaway_sea_sample(openWater(), 4.0, &points, nullptr, &out), SEAWAY_OK);
  const SeaPlanePoint place = librarysSea().geodesy.seaPlaneFromGeodetic(30.2, -77.0);
  const SurfaceSample truth = librarysSea().surface.sample(place.position, 4.0);
  const glm::dvec2 trueEast(std::cos(place.convergence), std::sin(place.convergence));
  // The placer is within 0.5 mm of the geodesic; slopes of this sea change by 0.1 a metre at most.
  EXPECT_NEAR(answers.fields[0][0], truth.height, 5e-4);
  EXPECT_NEAR(answers.fields[1][0], glm::dot(truth.slope, trueEast), 1e-4);
  EXPECT_GT(std::abs(place.convergence), 0.01);
  EXPECT_EQ(answers.status[2], SEAWAY_SAMPLE_OUT_OF_RANGE);
  EXPECT_TRUE(std::isnan(answers.fields[0][2]));
}

TEST(CapiSampling, GivesMotionAndPressureBelowTheSurface) {
  const Line line(300);
  const seaway_points points = line.points();
  const std::vector<double> heights(300, -2.5);
  std::vector<double> up(300), pressure(300);
  seaway_motions out = seaway_motions_default();
  out.velocity_up = up.data();
  out.pressure = pressure.data();
  ASSERT_EQ(seaway_sea_sample_motion(openWater(), 8.0, &points, heights.data(), nullptr, &out),
            SEAWAY_OK);
  std::vector<glm::dvec3> places;
  for (const glm::dvec2& place : placesOf(line)) places.emplace_back(place, -2.5);
  std::vector<WaterKinematics> truth(300);
  sampleKinematics(librarysSea().surface.at(8.0), places, truth);
  for (std::size_t i = 0; i < 300; ++i) {
    EXPECT_EQ(up[i], truth[i].velocity.z);
    EXPECT_EQ(pressure[i], truth[i].pressure);
  }
}

TEST(CapiSampling, CastsRaysAsTheLibraryDoes) {
  const double origins[] = {0, 0, 10, 0, 0, 10, 0, 0, 10};
  const double directions[] = {2, 0, -1, 0, 0, 1, NAN, 0, 0};
  double distances[3];
  ASSERT_EQ(seaway_sea_cast_rays(openWater(), 2.0, 3, origins, directions, nullptr, distances),
            SEAWAY_OK);
  const auto truth = distanceToWater(librarysSea().surface.at(2.0), {0, 0, 10},
                                     glm::normalize(glm::dvec3(2, 0, -1)));
  EXPECT_EQ(distances[0], truth.value());
  EXPECT_EQ(distances[1], INFINITY);
  EXPECT_TRUE(std::isnan(distances[2]));
}

TEST(CapiSampling, AllocatesNothingInTheSeaPlaneOnceWarm) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitizer has allocation functions of its own";
#endif
  const Line line(1000);
  const seaway_points points = line.points();
  Answers answers(1000);
  const seaway_samples out = answers.samples();
  const auto ask = [&](double t) {
    return seaway_sea_sample(openWater(), t, &points, nullptr, &out);
  };
  ASSERT_EQ(ask(0.0), SEAWAY_OK);
  const std::size_t before = test_support::allocationCount();
  for (int i = 1; i <= 10; ++i) ASSERT_EQ(ask(0.1 * i), SEAWAY_OK);
  EXPECT_EQ(test_support::allocationCount(), before);
}

TEST(CapiPlaces, RoundTripsWithinAMillimetre) {
  const double latitude_deg[] = {28.878, 30.0, NAN}, longitude_deg[] = {-78.467, -77.0, 0.0};
  double east[3], north[3], convergence_deg[3], back_deg[3], across_deg[3];
  ASSERT_EQ(seaway_sea_plane_from_geodetic(openWater(), 3, latitude_deg, longitude_deg, east, north,
                                           convergence_deg),
            SEAWAY_OK);
  ASSERT_EQ(seaway_sea_geodetic_from_plane(openWater(), 3, east, north, back_deg, across_deg),
            SEAWAY_OK);
  constexpr double millimetre_deg = 1e-3 / 111e3;
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(back_deg[i], latitude_deg[i], millimetre_deg);
    EXPECT_NEAR(across_deg[i], longitude_deg[i], 1.2 * millimetre_deg);  // 1/cos 30°
  }
  EXPECT_NEAR(east[0], 0.0, 1e-3);
  EXPECT_TRUE(std::isnan(east[2]) && std::isnan(back_deg[2]) && std::isnan(convergence_deg[2]));
}

TEST(CapiPlaces, TellsTheStillWaterLevel) {
  const double latitude_deg[] = {28.878, 95.0}, longitude_deg[] = {-78.467, 0.0};
  double level[2];
  ASSERT_EQ(seaway_sea_still_water_level(openWater(), 2, latitude_deg, longitude_deg, level),
            SEAWAY_OK);
  EXPECT_EQ(level[0], librarysSea().level.ellipsoidalHeight(28.878, -78.467));
  EXPECT_TRUE(std::isnan(level[1]));
}

}  // namespace
}  // namespace seaway::bridge::test
