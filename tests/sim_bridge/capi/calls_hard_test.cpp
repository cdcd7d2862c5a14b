#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/sim_bridge/capi/support.h"

namespace seaway::bridge::test {
namespace {

TEST(CapiCallsHard, RefuseNullPointersWithAMessage) {
  const SeaPointer sea = seaFrom(openSea);
  const Line line(4);
  const seaway_points points = line.points();
  const seaway_samples samples = seaway_samples_default();
  const seaway_motions motions = seaway_motions_default();
  const seaway_body body = seaway_body_default();
  const seaway_hull_options hull_options = seaway_hull_options_default();
  seaway_loads loads = seaway_loads_default();
  seaway_sea* made = nullptr;
  seaway_hull* hull = nullptr;
  std::size_t number = 0;
  double numbers[4] = {};
  const seaway_status statuses[] = {
      seaway_sea_from_file(nullptr, nullptr, &made),
      seaway_sea_from_file("scene.yaml", nullptr, nullptr),
      seaway_sea_from_text(nullptr, nullptr, nullptr, &made),
      seaway_sea_step(nullptr),
      seaway_sea_step_to(nullptr, 1.0),
      seaway_sea_restart(nullptr, 0.0),
      seaway_sea_sample(nullptr, 0.0, &points, nullptr, &samples),
      seaway_sea_sample(sea.get(), 0.0, nullptr, nullptr, &samples),
      seaway_sea_sample(sea.get(), 0.0, &points, nullptr, nullptr),
      seaway_sea_sample_motion(sea.get(), 0.0, &points, nullptr, nullptr, &motions),
      seaway_sea_cast_rays(sea.get(), 0.0, 1, nullptr, numbers, nullptr, numbers),
      seaway_sea_plane_from_geodetic(sea.get(), 1, numbers, numbers, nullptr, numbers, nullptr),
      seaway_sea_geodetic_from_plane(nullptr, 1, numbers, numbers, numbers, numbers),
      seaway_sea_still_water_level(sea.get(), 1, nullptr, numbers, numbers),
      seaway_sea_listen(sea.get(), 1, nullptr),
      seaway_sea_find_vessel(sea.get(), nullptr, &number),
      seaway_hull_from_file(nullptr, &hull_options, &hull),
      seaway_hull_from_file("box:4,2,2", nullptr, &hull),
      seaway_hull_from_triangles(3, nullptr, 1, nullptr, &hull_options, &hull),
      seaway_hull_from_vessel(nullptr, 0, &hull),
      seaway_hull_describe(nullptr, nullptr),
      seaway_sea_hull_loads(sea.get(), nullptr, 0.0, &body, nullptr, &loads),
      seaway_sea_render(sea.get(), nullptr, nullptr, nullptr, nullptr),
      seaway_sea_picture_size(sea.get(), nullptr, nullptr),
      seaway_sea_describe(sea.get(), nullptr, 10, &number)};
  int call = 0;
  for (const seaway_status status : statuses) {
    EXPECT_EQ(status, SEAWAY_BAD_ARGUMENT) << "call " << call;
    ++call;
  }
  EXPECT_STREQ(seaway_last_error(), "buffer is NULL");
}

TEST(CapiCallsHard, TakeNullForNothing) {
  seaway_sea_destroy(nullptr);
  seaway_hull_destroy(nullptr);
  seaway_points_init(nullptr, sizeof(seaway_points));
  EXPECT_TRUE(std::isnan(seaway_sea_time(nullptr)));
  EXPECT_TRUE(std::isnan(seaway_sea_step_length(nullptr)));
  EXPECT_EQ(seaway_sea_vessel_count(nullptr), 0u);
  EXPECT_EQ(seaway_sea_camera_name(nullptr, 0), nullptr);
}

TEST(CapiCallsHard, RefuseStructuresOfUnknownSize) {
  const SeaPointer sea = seaFrom(openSea);
  const Line line(4);
  std::vector<double> heights(4, -777.0);
  seaway_samples samples = seaway_samples_default();
  samples.height = heights.data();
  const auto ask = [&](const seaway_points& points, const seaway_sample_options& options) {
    return seaway_sea_sample(sea.get(), 0.0, &points, &options, &samples);
  };
  for (const std::uint32_t size : {0u, 4u, 12u, 4096u, 0xFFFFFFFFu}) {
    seaway_points points = line.points();
    seaway_sample_options options = seaway_sample_options_default();
    points.struct_size = size;
    EXPECT_EQ(ask(points, options), SEAWAY_BAD_STRUCT);
    options.struct_size = size;
    EXPECT_EQ(ask(line.points(), options), SEAWAY_BAD_STRUCT);
    samples.struct_size = size;
    EXPECT_EQ(ask(line.points(), seaway_sample_options_default()), SEAWAY_BAD_STRUCT);
    samples.struct_size = sizeof samples;
  }
  EXPECT_NE(std::string(seaway_last_error()).find("4294967295"), std::string::npos);
  EXPECT_EQ(heights, std::vector<double>(4, -777.0));
}

TEST(CapiCallsHard, FillNoMoreOfAStructureThanThereIs) {
  // An older program's structure ends earlier; a later one's has more, which is 0.
  unsigned char memory[2 * sizeof(seaway_camera)];
  std::fill(std::begin(memory), std::end(memory), 0xAB);
  seaway_camera_init(reinterpret_cast<seaway_camera*>(memory), 16);
  EXPECT_EQ(memory[16], 0xAB);
  seaway_camera_init(reinterpret_cast<seaway_camera*>(memory), sizeof memory);
  EXPECT_EQ(memory[sizeof memory - 1], 0);
}

TEST(CapiCallsHard, AnswerPointsAndTimesThatAreNotFinite) {
  const SeaPointer sea = seaFrom(openSea);
  const double inf = std::numeric_limits<double>::infinity();
  Line line(300);
  const std::vector<double> sound = heightsOf(sea.get(), 5.0, line.points());
  line.east[3] = NAN;
  line.north[257] = inf;
  line.east[299] = 1e13;
  std::vector<std::uint32_t> status(300);
  std::vector<double> heights(300);
  seaway_samples samples = seaway_samples_default();
  samples.status = status.data();
  samples.height = heights.data();
  const seaway_points points = line.points();
  ASSERT_EQ(seaway_sea_sample(sea.get(), 5.0, &points, nullptr, &samples), SEAWAY_OK);
  for (std::size_t i = 0; i < 300; ++i) {
    const bool spoilt = i == 3 || i == 257 || i == 299;
    EXPECT_EQ(std::isnan(heights[i]), spoilt) << i;
    EXPECT_TRUE(spoilt || heights[i] == sound[i]) << i;
  }
  EXPECT_EQ(status[3], SEAWAY_SAMPLE_NOT_FINITE);
  EXPECT_EQ(status[257], SEAWAY_SAMPLE_NOT_FINITE);
  EXPECT_EQ(status[299], SEAWAY_SAMPLE_OUT_OF_RANGE);
  for (const double t : {static_cast<double>(NAN), inf, -inf}) {
    ASSERT_EQ(seaway_sea_sample(sea.get(), t, &points, nullptr, &samples), SEAWAY_OK);
    EXPECT_TRUE(std::isnan(heights[0]));
    EXPECT_EQ(status[0], SEAWAY_SAMPLE_NOT_FINITE);
  }
}

TEST(CapiCallsHard, AnswerMillionsOfPointsAndNone) {
  const SeaPointer sea = seaFrom(openSea);
  const Line line(1'000'000, 1e-3);
  seaway_points points = line.points();
  const std::vector<double> heights = heightsOf(sea.get(), 2.0, points);
  EXPECT_EQ(std::count_if(heights.begin(), heights.end(),
                          [](double height) { return !(std::abs(height) < 5.0); }),
            0);
  points.first += 123'456;
  points.second += 123'456;
  points.count = 1;
  EXPECT_EQ(heightsOf(sea.get(), 2.0, points)[0], heights[123'456]);
  points = seaway_points_default();
  EXPECT_TRUE(heightsOf(sea.get(), 2.0, points).empty());
}

TEST(CapiCallsHard, RefuseOptionsOutOfRange) {
  const SeaPointer sea = seaFrom(openSea);
  const Line line(4);
  const seaway_points points = line.points();
  const seaway_samples samples = seaway_samples_default();
  const auto ask = [&](const seaway_sample_options& options) {
    return seaway_sea_sample(sea.get(), 0.0, &points, &options, &samples);
  };
  seaway_sample_options options = seaway_sample_options_default();
  options.tolerance = NAN;
  EXPECT_EQ(ask(options), SEAWAY_BAD_ARGUMENT);
  options = seaway_sample_options_default();
  options.shortest_wavelength = -1.0;
  EXPECT_EQ(ask(options), SEAWAY_BAD_ARGUMENT);
  options = seaway_sample_options_default();
  options.own_vessel = 1;
  EXPECT_EQ(ask(options), SEAWAY_NOT_FOUND);
  seaway_points other = points;
  other.frame = 7;
  EXPECT_EQ(seaway_sea_sample(sea.get(), 0.0, &other, nullptr, &samples), SEAWAY_BAD_ARGUMENT);
  EXPECT_EQ(seaway_sea_step_to(sea.get(), NAN), SEAWAY_BAD_ARGUMENT);
  EXPECT_EQ(seaway_sea_step_to(sea.get(), INFINITY), SEAWAY_BAD_ARGUMENT);
  EXPECT_EQ(seaway_sea_restart(sea.get(), -1.0), SEAWAY_BAD_ARGUMENT);
}

TEST(CapiCallsHard, RefuseTextsThatAreNoScene) {
  for (const char* yaml : {"", "sea: [", "- a\n- b\n", "sea: {}", "\xff\xfe",
                           "sea: 7\n---\nsea: 8\n", "vessels: [{name: a, model: none.yaml}]"}) {
    seaway_sea* sea = reinterpret_cast<seaway_sea*>(1);
    EXPECT_EQ(seaway_sea_from_text(yaml, nullptr, nullptr, &sea), SEAWAY_BAD_INPUT) << yaml;
    EXPECT_EQ(sea, nullptr);
    EXPECT_NE(std::string(seaway_last_error()).find("<text>"), std::string::npos);
  }
  seaway_sea* sea = nullptr;
  EXPECT_EQ(seaway_sea_from_file("/", nullptr, &sea), SEAWAY_BAD_INPUT);
}

TEST(CapiCallsHard, MessagesOfAnyLengthFit) {
  seaway_sea* sea = nullptr;
  const std::string path = "/no/" + std::string(3000, 'x') + std::string(2000, '\xc3');
  EXPECT_EQ(seaway_sea_from_file(path.c_str(), nullptr, &sea), SEAWAY_BAD_INPUT);
  EXPECT_LE(std::string(seaway_last_error()).size(), 4095u);
  EXPECT_GE(std::string(seaway_last_error()).size(), 3000u);
}

TEST(CapiCallsHard, SayWhereMemoryIsShort) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers need address space of their own";
#endif
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const SeaPointer sea = seaFrom(openSea);
    rlimit limit{};
    getrlimit(RLIMIT_AS, &limit);
    limit.rlim_cur = 1;  // no more pages
    setrlimit(RLIMIT_AS, &limit);
    seaway_hull_options options = seaway_hull_options_default();
    options.mass = 1e6;
    options.triangles = 4'000'000;
    seaway_hull* hull = nullptr;
    const seaway_status status = seaway_hull_from_file("sphere:10", &options, &hull);
    _exit(status == SEAWAY_OUT_OF_MEMORY && seaway_last_error()[0] != '\0' ? 0 : 1);
  }
  int status = -1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
}

TEST(CapiSeaHard, StandsStillWhereAVesselRunsAground) {
  const std::string lake = R"(sea:
  anchor: {latitude_deg: 42.94, longitude_deg: -122.11}
  outline: ../outlines/crater_lake.geojson
  state: {calm: {}}
vessels:
  - name: boat
    model: ../vessels/launch_12m.yaml
    start: {latitude_deg: 42.94, longitude_deg: -122.11, heading_deg: 0}
    speed_m_s: 50
effects: {wake: off, trail: off}
run: {step_s: 0.5}
)";
  const SeaPointer sea = seaFrom(lake);
  ASSERT_TRUE(sea);
  EXPECT_EQ(seaway_sea_step_to(sea.get(), 1000.0), SEAWAY_BAD_INPUT);
  EXPECT_NE(std::string(seaway_last_error()).find("aground"), std::string::npos);
  const double stopped = seaway_sea_time(sea.get());
  const Line line(10);
  heightsOf(sea.get(), 0.0, line.points());
  EXPECT_EQ(seaway_sea_step(sea.get()), SEAWAY_BAD_INPUT);
  EXPECT_EQ(seaway_sea_time(sea.get()), stopped);
  EXPECT_EQ(seaway_sea_restart(sea.get(), 0.0), SEAWAY_OK);
  EXPECT_EQ(seaway_sea_step(sea.get()), SEAWAY_OK);
}

}  // namespace
}  // namespace seaway::bridge::test
