#include "sim_bridge/scene_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <string>

#include "render/compare_frames.h"
#include "render/technique_choice.h"
#include "sim_bridge/scene/scene_loader.h"
#include "surface/angles.h"
#include "tests/sim_bridge/test_support.h"

// Pictures from places on the Earth where plane geometry breaks: by poles, on the antimeridian, far
// from the anchor, after a long time.
namespace seaway::bridge {
namespace {

struct Spot {
  std::string name;
  double anchorLatitude_deg, anchorLongitude_deg, latitude_deg, longitude_deg;
};

const Spot spots[] = {{"beyond the pole", 89.9, 0.0, 89.97, 170.0},
                      {"at the pole", 89.9, 30.0, 90.0, 0.0},
                      {"over the antimeridian", 10.0, 180.0, 10.01, -179.98},
                      {"150 km from the anchor", 60.0, 0.0, 60.0, 2.69}};

Scene sceneAt(const Spot& spot) {
  const auto place = [](double latitude_deg, double longitude_deg) {
    return "latitude_deg: " + std::to_string(latitude_deg) +
           ", longitude_deg: " + std::to_string(longitude_deg);
  };
  const test::TempFolder folder;
  return loadScene(test::writeScene(
      folder, {{"anchor: {latitude_deg: 28.878, longitude_deg: -78.467",
                "anchor: {" + place(spot.anchorLatitude_deg, spot.anchorLongitude_deg)},
               {"start: {latitude_deg: 28.878, longitude_deg: -78.467",
                "start: {" + place(spot.latitude_deg, spot.longitude_deg)},
               {"hm0_m: 1.12", "hm0_m: 3"},
               {"tp_s: 5.6", "tp_s: 7"}}));
}

/// Direction of a pixel's ray in east, north, up at the camera, by the compass; not of unit length:
/// 1 along the camera's axis.
glm::dvec3 rayOf(const SceneCamera& camera, glm::ivec2 size, glm::ivec2 pixel) {
  const double yaw = radiansFromDegrees(camera.yaw_deg),
               pitch = radiansFromDegrees(camera.pitch_deg);
  const glm::dvec3 forward(std::sin(yaw) * std::cos(pitch), std::cos(yaw) * std::cos(pitch),
                           std::sin(pitch));
  const glm::dvec3 right(std::cos(yaw), -std::sin(yaw), 0.0);
  const glm::dvec3 up = glm::cross(right, forward);
  const double perPixel = 2.0 * std::tan(0.5 * radiansFromDegrees(camera.fieldOfView_deg)) / size.y;
  const glm::dvec2 off = (glm::dvec2(pixel) - 0.5 * glm::dvec2(size - 1)) * perPixel;
  return forward + off.x * right - off.y * up;
}

/// Rms of the field's height where a picture's points lie on the Earth, by way of ECEF, against the
/// points' own heights, m.
double heightError(const Sea& sea, double time, const SceneCamera& camera,
                   const render::Frame& frame) {
  const CameraPlace& place = *camera.place;
  const GeodeticPosition eye{place.latitude_deg, place.longitude_deg, place.height};
  const glm::dmat3 ecefFromEnu = glm::transpose(Geodesy::enuFromEcef(eye));
  const glm::ivec2 size = frame.depth.size;
  double squares = 0.0;
  int count = 0;
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * size.x + x;
      if (frame.classes[i] != render::PixelClass::water) continue;
      const glm::dvec3 enu = rayOf(camera, size, {x, y}) * double{frame.depth.metres[i]};
      const GeodeticPosition point =
          Geodesy::geodeticFromEcef(Geodesy::ecefFromGeodetic(eye) + ecefFromEnu * enu);
      const glm::dvec2 onPlane =
          sea.geodesy.seaPlaneFromGeodetic(point.latitude_deg, point.longitude_deg).position;
      squares += std::pow(sea.surface.sample(onPlane, time).height - point.height, 2);
      ++count;
    }
  }
  EXPECT_EQ(count, size.x * size.y);
  return std::sqrt(squares / count);
}

class SceneViewHard : public ::testing::TestWithParam<int> {
 protected:
  const Spot& spot_ = spots[GetParam()];
  const Scene scene_ = sceneAt(spot_);
  const Sea sea_ = buildSea(scene_);
};

TEST_P(SceneViewHard, PixelsShowTheFieldAtTheirPlaceOnTheEarth) {
  const double time = 1e7;
  Scene bare = scene_;
  bare.vessels.clear();
  const Simulation simulation = Simulation::replayed(bare, sea_, time);
  SceneView sceneView(bare);
  EffectLedger ledger;
  SceneCamera camera;
  camera.place = CameraPlace{spot_.latitude_deg, spot_.longitude_deg, 30.0};
  camera.pitch_deg = -40.0;
  camera.fieldOfView_deg = 40.0;
  for (const char* variant :
       {"software", "cpu_vertices", "gpu", "cpu_vertices_gpu_normals", "marched"}) {
    const auto technique = render::makeTechnique({.variant = variant, .grid = {256, 256}});
    for (const double yaw : {0.0, 75.0, 200.0}) {
      camera.yaw_deg = yaw;
      const render::View view = sceneView.view(simulation, camera, {33, 21}, ledger);
      const render::Frame frame = technique->draw(view);
      const double error = heightError(sea_, time, camera, frame);
      // Turned by the convergence that 150 km from the anchor make, the same picture is wrong.
      SceneCamera turned = camera;
      turned.yaw_deg += 2.3;
      const double turnedError = heightError(sea_, time, turned, frame);
      std::printf("%s, %s, yaw %g: %.4f m rms, turned %.3f\n", spot_.name.c_str(), variant, yaw,
                  error, turnedError);
      // Waves of 3 m: chords of the grid, a coarse one where only normals are fine.
      const bool isCoarse = std::string(variant) == "cpu_vertices_gpu_normals";
      EXPECT_LT(error, isCoarse ? 0.15 : 0.02);
      if (!isCoarse) {
        EXPECT_GT(turnedError, 0.08);
      }
    }
  }
}

TEST_P(SceneViewHard, AVesselsCameraSeesWhatRaysFind) {
  const Simulation simulation = Simulation(scene_, sea_).movedTo(1.0);
  SceneView sceneView(scene_);
  EffectLedger ledger;
  render::View view = sceneView.view(simulation, findCamera(scene_, "bow"), {64, 48}, ledger);
  view.wantsNormals = true;
  const auto draw = [&](const char* technique, const char* variant) {
    return render::makeTechnique({.technique = technique, .variant = variant, .grid = {256, 256}})
        ->draw(view);
  };
  const auto c = render::compareFrames(view.camera, draw("projected_grid", "software"),
                                       draw("reference", "automatic"));
  EXPECT_GT(c.compared, 100u);
  EXPECT_LE(c.positionRms, 0.5);
  EXPECT_LE(c.positionPercentile99, 3.0);
  EXPECT_EQ(c.misplaced, 0u);
  EXPECT_LE(c.missing + c.extra, 3u);
}

INSTANTIATE_TEST_SUITE_P(Each, SceneViewHard, ::testing::Range(0, 4));

}  // namespace
}  // namespace seaway::bridge
