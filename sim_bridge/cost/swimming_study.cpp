#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render/swimming.h"
#include "render/technique_choice.h"
#include "sim_bridge/cost/study.h"
#include "sim_bridge/scene_view.h"
#include "surface/angles.h"

namespace seaway::bridge {

std::vector<Study> studySwimming(const Scene& scene, const Sea& sea, const StudyOptions& options) {
  const glm::ivec2 size = options.quick ? glm::ivec2(160, 90) : glm::ivec2(640, 360);
  const int frames = options.quick ? 2 : 8;
  const Simulation simulation(scene, sea);
  SceneView sceneView(scene);
  EffectLedger ledger(scene.effects);
  const render::View view = sceneView.view(simulation, findCamera(scene, ""), size, ledger);
  const glm::dvec2 ahead(view.camera.forward());
  const glm::dvec2 way = ahead / std::max(glm::length(ahead), 1e-9);
  const std::string where = ", camera '" + findCamera(scene, "").name + "', " +
                            std::to_string(size.x) + "x" + std::to_string(size.y) + " pixels";
  const auto study = [&](const char* name, const std::string& what) {
    return Study{name,
                 "change of the drawn surface of a frozen sea a frame, rms, " + what + where,
                 "px",
                 "ms/frame",
                 {}};
  };
  Study sailing = study("image_swimming", "the camera moving 0.25 m ahead a frame");
  Study turning = study("image_swimming_turning", "the camera turning 0.5 degrees a frame");
  const render::CameraMotion sails{glm::dvec3(0.25 * way, 0.0), 0.0};
  const render::CameraMotion turns{glm::dvec3(0.0), radiansFromDegrees(0.5)};
  for (const int side : options.quick ? std::vector<int>{32, 128, 512}
                                      : std::vector<int>{32, 64, 128, 256, 512, 1024}) {
    const auto technique =
        render::makeTechnique({.grid = {side, side}, .backend = options.backend});
    render::Frame frame;
    const Timing timing =
        timeRepeated([&] { technique->drawInto(view, frame); }, options.quick ? 3 : 5);
    const std::string setting = "grid " + std::to_string(side) + "x" + std::to_string(side);
    for (auto& [motion, into] : {std::pair{&sails, &sailing}, std::pair{&turns, &turning}}) {
      into->points.push_back({setting, render::swimming(*technique, view, *motion, frames),
                              1e3 * timing.median, 1e3 * timing.spread});
    }
  }
  return {sailing, turning};
}

}  // namespace seaway::bridge
