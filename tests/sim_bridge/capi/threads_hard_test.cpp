#include <atomic>
#include <cmath>
#include <thread>

#include "tests/sim_bridge/capi/support.h"

namespace seaway::bridge::test {
namespace {

/// With waves and trails.
const std::string boatsAtSea = [] {
  std::string scene = boats;
  const auto replace = [&](const std::string& from, const std::string& to) {
    scene.replace(scene.find(from), from.size(), to);
  };
  replace("{calm: {}}", "{jonswap: {hm0_m: 0.5, tp_s: 4, from_deg: 196, octaves: 8}}");
  replace("{trail: off}", "{trail: auto}");
  return scene;
}();

/// Runs until told to end; counts how often.
class Loop {
 public:
  template <class Body>
  Loop(const std::atomic<bool>& ended, Body body)
      : thread_([this, &ended, body] {
          while (!ended) body(), ++count_;
        }) {}
  ~Loop() { thread_.join(); }
  long count() const { return count_; }

 private:
  std::atomic<long> count_{0};
  std::thread thread_;
};

TEST(CapiThreadsHard, AskOneSeaWhileOthersStepPlaceDrawAndDescribeIt) {
  const SeaPointer sea = seaFrom(boatsAtSea);
  const Line far(300, 50.0);  // mostly beyond the wakes
  const std::vector<double> expected = heightsOf(sea.get(), 5.0, far.points());
  seaway_hull* made = nullptr;
  ASSERT_EQ(seaway_hull_from_vessel(sea.get(), 0, &made), SEAWAY_OK);
  const HullPointer hull(made);
  std::atomic<bool> ended{false};
  std::atomic<int> faults{0};
  {
    const auto sample = [&] {
      std::vector<double> heights(300);
      seaway_samples samples = seaway_samples_default();
      samples.height = heights.data();
      const seaway_points points = far.points();
      if (seaway_sea_sample(sea.get(), 5.0, &points, nullptr, &samples) != SEAWAY_OK) ++faults;
      // 7 km from the boats there is nothing but waves: the same bits whatever else goes on.
      if (heights.front() != expected.front() || heights.back() != expected.back()) ++faults;
    };
    const auto load = [&] {
      const seaway_body body = seaway_body_default();
      seaway_loads loads = seaway_loads_default();
      if (seaway_sea_hull_loads(sea.get(), hull.get(), 5.0, &body, nullptr, &loads) != SEAWAY_OK ||
          !std::isfinite(loads.force[2])) {
        ++faults;
      }
    };
    const auto describe = [&] {
      std::vector<char> text(1 << 16);
      if (seaway_sea_describe(sea.get(), text.data(), text.size(), nullptr) != SEAWAY_OK) ++faults;
    };
    const auto draw = [&] {
      std::vector<float> depth(32 * 24);
      seaway_image image = seaway_image_default();
      image.width = 32;
      image.height = 24;
      image.depth = depth.data();
      image.depth_size = depth.size();
      if (seaway_sea_render(sea.get(), "bow", nullptr, nullptr, &image) != SEAWAY_OK) ++faults;
    };
    const Loop first(ended, sample), second(ended, sample), third(ended, load),
        fourth(ended, describe), fifth(ended, draw);
    seaway_pose pose = seaway_pose_default();
    for (int i = 1; i <= 40; ++i) {
      const double t = 0.02 * i;
      pose.north = 200.0 + 6.0 * t;
      EXPECT_EQ(seaway_sea_place_vessel(sea.get(), 1, t, &pose), SEAWAY_OK) << seaway_last_error();
      EXPECT_EQ(seaway_sea_step_to(sea.get(), t), SEAWAY_OK) << seaway_last_error();
    }
    while (first.count() < 5 || third.count() < 5 || fifth.count() < 2) std::this_thread::yield();
    ended = true;
  }
  EXPECT_EQ(faults, 0);
  EXPECT_NEAR(seaway_sea_time(sea.get()), 0.8, 1e-9);
}

TEST(CapiThreadsHard, KeepTheirOwnMessages) {
  seaway_sea* sea = nullptr;
  EXPECT_EQ(seaway_sea_from_file("/no/such.yaml", nullptr, &sea), SEAWAY_BAD_INPUT);
  std::thread([] { EXPECT_STREQ(seaway_last_error(), ""); }).join();
  EXPECT_NE(std::string(seaway_last_error()).find("/no/such.yaml"), std::string::npos);
}

TEST(CapiThreadsHard, MakeAndEndSeasSideBySide) {
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([] {
      for (int k = 0; k < 3; ++k) {
        const SeaPointer sea = seaFrom(boatsAtSea);
        const Line line(20);
        heightsOf(sea.get(), 1.0, line.points());
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
}

}  // namespace
}  // namespace seaway::bridge::test
