#include <cmath>

#include "render/technique_choice.h"
#include "sim_bridge/cost/study.h"
#include "sim_bridge/scene_view.h"

namespace seaway::bridge {
namespace {

constexpr int truthSamples = 6;  // a side

std::string sampleText(int side) {
  return std::to_string(side * side) + (side == 1 ? " sample" : " samples");
}

/// Root of the mean square of differences over the mean, of all channels, %.
double relativeRms(std::span<const glm::vec3> drawn, std::span<const glm::vec3> truth) {
  double squares = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      squares += std::pow(double{drawn[i][c]} - truth[i][c], 2);
      sum += truth[i][c];
    }
  }
  const double count = 3.0 * static_cast<double>(truth.size());
  return 100.0 * std::sqrt(squares / count) / (sum / count);
}

/// The first camera that is under water or cut by the surface; null: none.
const SceneCamera* cameraUnderWater(const Scene& scene, const Simulation& simulation,
                                    SceneView& sceneView, render::RenderTechnique& technique) {
  for (const SceneCamera& camera : scene.cameras) {
    EffectLedger ledger(scene.effects);
    technique.draw(sceneView.view(simulation, camera, {32, 18}, ledger));
    const auto report = ledger.report()[static_cast<std::size_t>(Effect::underWater)];
    if (report.state == EffectState::on) return &camera;
  }
  return nullptr;
}

}  // namespace

std::vector<Study> studyUnderWater(const Scene& scene, const Sea& sea,
                                   const StudyOptions& options) {
  const Simulation simulation(scene, sea);
  SceneView sceneView(scene);
  const auto technique =
      render::makeTechnique({.grid = scene.accuracy.grid, .backend = options.backend});
  const SceneCamera* camera = cameraUnderWater(scene, simulation, sceneView, *technique);
  if (!camera) return {};
  const glm::ivec2 size = options.quick ? glm::ivec2(160, 90) : glm::ivec2(320, 180);
  EffectLedger ledger(scene.effects);
  render::View view = sceneView.view(simulation, *camera, size, ledger);
  view.wantsRadiance = true;
  view.samplesPerSide = truthSamples;
  const render::Frame truth = technique->draw(view);
  Study study{"light_under_water",
              "radiance, rms in % of its mean, by samples a pixel; truth: " +
                  std::to_string(truthSamples * truthSamples) + " samples; camera '" +
                  camera->name + "', " + std::to_string(size.x) + "x" + std::to_string(size.y) +
                  " pixels",
              "%",
              "ms/frame",
              {}};
  for (int samples = 1; samples <= 4; ++samples) {
    view.samplesPerSide = samples;
    render::Frame frame;
    const Timing timing =
        timeRepeated([&] { technique->drawInto(view, frame); }, options.quick ? 3 : 5);
    study.points.push_back({sampleText(samples), relativeRms(frame.radiance, truth.radiance),
                            1e3 * timing.median, 1e3 * timing.spread,
                            static_cast<double>(samples)});
  }
  study.chosen = sampleText(1);
  return {study};
}

}  // namespace seaway::bridge
