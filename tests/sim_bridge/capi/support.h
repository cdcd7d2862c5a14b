#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "sim_bridge/seaway.h"

namespace seaway::bridge::test {

struct DestroySea {
  void operator()(seaway_sea* sea) const { seaway_sea_destroy(sea); }
};
struct DestroyHull {
  void operator()(seaway_hull* hull) const { seaway_hull_destroy(hull); }
};
using SeaPointer = std::unique_ptr<seaway_sea, DestroySea>;
using HullPointer = std::unique_ptr<seaway_hull, DestroyHull>;

/// A sea from a scene's text, whose files are those of configs/scenes.
inline SeaPointer seaFrom(const std::string& yaml) {
  seaway_sea* sea = nullptr;
  const seaway_status status =
      seaway_sea_from_text(yaml.c_str(), SEAWAY_SOURCE_DIR "/configs/scenes", nullptr, &sea);
  EXPECT_EQ(status, SEAWAY_OK) << seaway_last_error();
  return SeaPointer(sea);
}

/// A measured sea without vessels, of twelve group octaves.
inline const std::string openSea = R"(sea:
  anchor: {latitude_deg: 28.878, longitude_deg: -78.467}
  seed: 7
  state: {jonswap: {hm0_m: 1.12, tp_s: 5.6, from_deg: 196, octaves: 12}}
run: {size: [64, 48], step_s: 0.02}
)";

/// Flat water, one boat under way to the north, another at rest 40 m east of its track.
inline const std::string boats = R"(sea:
  anchor: {latitude_deg: 51.98, longitude_deg: 4.05}
  seed: 4
  state: {calm: {}}
vessels:
  - name: pilot
    model: ../vessels/launch_12m.yaml
    start: {latitude_deg: 51.98, longitude_deg: 4.05, heading_deg: 0}
    speed_m_s: 6
  - name: drifter
    model: ../vessels/launch_12m.yaml
    start: {latitude_deg: 51.98, longitude_deg: 4.0506, heading_deg: 0}
    speed_m_s: 0
cameras:
  - {name: bow, mount: pilot, position_m: [3, 0, 3.2], fov_deg: 60}
  - name: mast
    place: {latitude_deg: 51.9795, longitude_deg: 4.05, height_m: 30}
    pitch_deg: -15
effects: {trail: off}
run: {size: [64, 48], step_s: 0.02}
)";

/// Points on a line through a sea's anchor, m.
struct Line {
  std::vector<double> east, north;
  explicit Line(std::size_t count, double spacing = 3.7) : east(count), north(count) {
    for (std::size_t i = 0; i < count; ++i) {
      east[i] = spacing * (static_cast<double>(i) - 0.5 * static_cast<double>(count));
      north[i] = 0.61 * east[i] + 11.0;
    }
  }
  seaway_points points() const {
    seaway_points points = seaway_points_default();
    points.count = east.size();
    points.first = east.data();
    points.second = north.data();
    return points;
  }
};

/// Heights of a sea at points; a failure of the call is one of the test.
inline std::vector<double> heightsOf(const seaway_sea* sea, double t, const seaway_points& points,
                                     const seaway_sample_options* options = nullptr) {
  std::vector<double> heights(points.count, -777.0);
  seaway_samples samples = seaway_samples_default();
  samples.height = heights.data();
  EXPECT_EQ(seaway_sea_sample(sea, t, &points, options, &samples), SEAWAY_OK)
      << seaway_last_error();
  return heights;
}

}  // namespace seaway::bridge::test
