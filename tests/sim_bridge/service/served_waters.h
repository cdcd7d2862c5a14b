#pragma once

#include <string>
#include <vector>

#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/service/served_sea.h"
#include "tests/sim_bridge/driven_vessel.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge::test {

/// Calm water about 0° N 0° E: a pilot boat that sails north from the origin at 5 m/s and a buoy
/// moored 40 m abeam; windows of 128 m in cells of 1 m, which take milliseconds.
inline std::string pilotScene(const std::string& more = "", const std::string& speed = "5") {
  return "sea: {anchor: {latitude_deg: 0, longitude_deg: 0}, state: {calm: {}}}\n"
         "vessels:\n"
         "  - {name: pilot, model: launch.yaml, start: {latitude_deg: 0, longitude_deg: 0, "
         "heading_deg: 0}, speed_m_s: " +
         speed +
         "}\n"
         "  - {name: buoy, model: launch.yaml, start: {latitude_deg: 0, longitude_deg: 0.00036, "
         "heading_deg: 0}}\n"
         "cameras:\n"
         "  - {name: bow, mount: pilot, position_m: [3, 0, 3.2]}\n"
         "  - {name: mast, place: {latitude_deg: 0, longitude_deg: 0, height_m: 40}, pitch_deg: "
         "-30}\n"
         "accuracy: {wakes: {cell_m: 1, window_m: 128}}\n" +
         more + "run: {step_s: 0.05, size: [96, 64]}\n";
}

/// For pilotScene: oil, and a float that bobs ahead of the buoy, far from both hulls; no wakes.
inline const std::string oilAndRipples =
    "effects: {wake: off}\n"
    "layers: [{kind: oil, place: {latitude_deg: 0.0008, longitude_deg: 0}, radius_m: 8, "
    "cover: 0.9}]\n"
    "ripples: [{place: {latitude_deg: 0.0004, longitude_deg: 0.0004}, height_m: 0.05}]\n";

/// A free launch that steers north from the origin and then east, another moored abeam of its way.
inline std::string freeScene(const std::string& more = "", const std::string& depth = "") {
  return "sea: {anchor: {latitude_deg: 0, longitude_deg: 0}, " + depth +
         "state: {jonswap: {hm0_m: 0.4, tp_s: 4, from_deg: 30, spread_s: 10, octaves: 8}}}\n"
         "vessels:\n"
         "  - {name: pilot, model: driven.yaml, motion: free, start: {latitude_deg: 0, "
         "longitude_deg: 0, heading_deg: 0}, speed_m_s: 4, waypoints: [{latitude_deg: 0.0006, "
         "longitude_deg: 0}, {latitude_deg: 0.0006, longitude_deg: 0.01}]}\n"
         "  - {name: moored, model: launch.yaml, start: {latitude_deg: 0.0004, longitude_deg: "
         "0.00015}}\n"
         "cameras:\n  - {name: bow, mount: pilot, position_m: [3, 0, 3]}\n"
         "accuracy: {wakes: {cell_m: 1, window_m: 128}}\n" +
         more + "run: {step_s: 0.05, size: [64, 48]}\n";
}

inline Scene loadText(const std::string& text) {
  const TempFolder folder;
  folder.write("driven.yaml", drivenVessel);
  folder.write("launch.yaml", vesselText());
  return loadScene(folder.write("scene.yaml", text));
}

/// A scene with its sea, served.
struct ServedWaters {
  explicit ServedWaters(const std::string& text = pilotScene()) : scene(loadText(text)) {}

  HostedPose poseAt(glm::dvec2 place, double heading_deg = 0.0) const {
    const GeodeticPosition at = sea.geodesy().geodeticFromSeaPlane(place);
    return {at.latitude_deg, at.longitude_deg, 0.0, heading_deg, 0.0, 0.0};
  }
  /// Wakes at `t` for someone at a place, as soon as they are there.
  void bringWakes(double t, glm::dvec2 place, std::uint32_t vessel = 0) {
    const WakeListener listener{place, 1.0, vessel};
    sea.attend(t, std::span(&listener, 1));
    EXPECT_TRUE(sea.awaitWakes(60.0));  // so long that something hangs
  }

  Scene scene;
  ServedSea sea{scene, buildSea(scene)};
};

/// The largest |η| on a line across a vessel's track.
inline double largestWave(const WaterSurface& surface, double t, double y,
                          const SampleOptions& options = {}) {
  double largest = 0.0;
  for (int i = 0; i < 200; ++i) {
    const double height = surface.sample({-20.0 + 0.2 * i, y}, t, options).height;
    largest = std::max(largest, std::abs(height));
  }
  return largest;
}

}  // namespace seaway::bridge::test
