#include "sim_bridge/gallery/gallery_drawing.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "render/technique_choice.h"
#include "sim_bridge/output/stopwatch.h"
#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene_view.h"
#include "surface/angles.h"

namespace seaway::bridge {
namespace {

SceneCamera cameraOf(const Scene& scene, const GalleryPicture& picture) {
  if (!picture.from) return findCamera(scene, picture.camera);
  SceneCamera camera;
  camera.name = "free";
  camera.place = picture.from;
  camera.yaw_deg = picture.yaw_deg;
  camera.pitch_deg = picture.pitch_deg;
  camera.roll_deg = picture.roll_deg;
  camera.fieldOfView_deg = picture.fieldOfView_deg;
  return camera;
}

std::string describe(const SceneCamera& description, const render::Camera& camera,
                     const Geodesy& geodesy) {
  const GeodeticPosition place = geodesy.geodeticFromSeaPlane(glm::dvec2(camera.position));
  const glm::dvec3 forward = camera.forward();
  const double heading = geodesy.trueHeadingFromDirection(glm::dvec2(camera.position),
                                                          std::atan2(forward.y, forward.x));
  return fmt::format(
      "camera '{}' at {:.5f}°, {:.5f}°, {:.1f} m up, towards {:.0f}°, pitch {:.0f}°, {:.0f}° high",
      description.name, place.latitude_deg, place.longitude_deg, camera.position.z, heading,
      degreesFromRadians(std::asin(std::clamp(forward.z, -1.0, 1.0))),
      degreesFromRadians(2.0 * std::atan(camera.halfPicture().y)));
}

}  // namespace

DrawnPicture drawPicture(const Gallery& gallery, const GalleryPicture& picture, glm::ivec2 size,
                         const std::string& backend, int repeats) {
  const Scene scene = loadScene(gallery.sceneOf(picture));
  const SceneCamera camera = cameraOf(scene, picture);
  const auto technique = render::makeTechnique({.technique = picture.technique,
                                                .variant = picture.variant,
                                                .grid = scene.accuracy.grid,
                                                .backend = backend});
  const Sea sea = buildSea(scene);
  Simulation simulation = replayWithProgress(scene, sea, picture.time);
  simulation.attend({.cameras = {camera}, .places = {}});
  SceneView sceneView(scene);
  DrawnPicture drawn;
  std::vector<double> times;
  for (int i = 0; i <= repeats; ++i) {
    EffectLedger ledger(scene.effects);
    const render::View view = sceneView.view(simulation, camera, size, ledger);
    const Stopwatch watch;
    technique->drawInto(view, drawn.frame);
    times.push_back(watch.milliseconds());
    if (i < repeats) continue;
    drawn.seen = describe(camera, view.camera, sea.geodesy);
    for (EffectReport& effect : ledger.report()) {
      if (effect.state == EffectState::on) drawn.effects.push_back(std::move(effect));
    }
  }
  if (repeats > 0) times.erase(times.begin());
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2),
                   times.end());
  drawn.milliseconds = times[times.size() / 2];
  return drawn;
}

render::ColourImage contactSheet(const std::vector<render::ColourImage>& pictures, int columns) {
  constexpr int gap = 4;
  const int rows = (static_cast<int>(pictures.size()) + columns - 1) / columns;
  const glm::ivec2 cell = pictures.front().size + gap;
  render::ColourImage sheet;
  sheet.size = glm::ivec2(columns, rows) * cell - gap;
  sheet.rgb.assign(std::size_t{3} * sheet.size.x * sheet.size.y, 255);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const int n = static_cast<int>(i);
    const glm::ivec2 corner = glm::ivec2(n % columns, n / columns) * cell;
    const std::size_t bytes = std::size_t{3} * pictures[i].size.x;
    for (int y = 0; y < pictures[i].size.y; ++y) {
      std::copy_n(pictures[i].rgb.begin() + static_cast<std::ptrdiff_t>(bytes * y), bytes,
                  sheet.rgb.begin() + 3 * (std::ptrdiff_t{corner.y + y} * sheet.size.x + corner.x));
    }
  }
  return sheet;
}

PictureDifference differenceOf(const render::ColourImage& a, const render::ColourImage& b,
                               int far) {
  PictureDifference difference;
  std::size_t farPixels = 0;
  double sum = 0.0;
  for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
    int largest = 0;
    for (std::size_t c = i; c < i + 3; ++c) {
      const int apart = std::abs(int{a.rgb[c]} - int{b.rgb[c]});
      sum += apart;
      largest = std::max(largest, apart);
    }
    farPixels += largest > far;
    difference.largest = std::max(difference.largest, largest);
  }
  difference.meanAbsolute = sum / static_cast<double>(a.rgb.size());
  difference.farShare = 3.0 * static_cast<double>(farPixels) / static_cast<double>(a.rgb.size());
  return difference;
}

render::ColourImage differencePicture(const render::ColourImage& a, const render::ColourImage& b) {
  render::ColourImage picture = a;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    picture.rgb[i] =
        static_cast<std::uint8_t>(std::clamp(128 + 8 * (int{a.rgb[i]} - int{b.rgb[i]}), 0, 255));
  }
  return picture;
}

}  // namespace seaway::bridge
