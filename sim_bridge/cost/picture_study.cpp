#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <memory>

#include "render/technique_choice.h"
#include "sim_bridge/cost/image_truth.h"
#include "sim_bridge/cost/study.h"
#include "sim_bridge/scene_view.h"

namespace seaway::bridge {
namespace {

constexpr int truthSamples = 6;  // a side

/// The colour of a picture at `pixel`, whole numbers being pixels' centres: between those around it
/// as screens do that enlarge pictures.
glm::vec3 colourAt(const render::ColourImage& image, glm::vec2 pixel) {
  const glm::vec2 last = glm::vec2(image.size - 1);
  const glm::vec2 inside = glm::clamp(pixel, glm::vec2(0.0f), last);
  const glm::ivec2 low(inside), high = glm::min(low + 1, image.size - 1);
  const glm::vec2 part = inside - glm::vec2(low);
  const auto at = [&](int x, int y) {
    const std::size_t i = 3 * (static_cast<std::size_t>(y) * image.size.x + x);
    return glm::vec3(image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]);
  };
  return glm::mix(glm::mix(at(low.x, low.y), at(high.x, low.y), part.x),
                  glm::mix(at(low.x, high.y), at(high.x, high.y), part.x), part.y);
}

/// Root of the mean square of differences of colours, of 255, from `truth`; `drawn` is enlarged to
/// its size.
double colourError(const render::ColourImage& drawn, const render::ColourImage& truth) {
  const glm::vec2 scale = glm::vec2(drawn.size) / glm::vec2(truth.size);
  double squares = 0.0;
  for (int y = 0; y < truth.size.y; ++y) {
    for (int x = 0; x < truth.size.x; ++x) {
      const glm::vec3 off = colourAt(drawn, (glm::vec2(x, y) + 0.5f) * scale - 0.5f) -
                            colourAt(truth, glm::vec2(x, y));
      squares += double{glm::dot(off, off)};
    }
  }
  return std::sqrt(squares / (3.0 * truth.size.x * truth.size.y));
}

/// A scene's first camera at the scene's start.
class Stage {
 public:
  Stage(const Scene& scene, const Sea& sea, const StudyOptions& options)
      : scene_(scene),
        options_(options),
        simulation_(scene, sea),
        sceneView_(scene),
        camera_(findCamera(scene, "")),
        ledger_(scene.effects) {}

  glm::ivec2 size() const { return options_.quick ? glm::ivec2(320, 180) : glm::ivec2(640, 360); }
  std::string where() const { return "camera '" + camera_.name + "', " + sizeText(size()); }
  int repetitions() const { return options_.quick ? 3 : 5; }

  /// What the camera sees; valid until the next call.
  render::View view(glm::ivec2 size, int samplesPerSide) {
    render::View view = sceneView_.view(simulation_, camera_, size, ledger_);
    view.samplesPerSide = samplesPerSide;
    view.light.dithers = false;
    return view;
  }
  std::unique_ptr<render::RenderTechnique> technique() const {
    return render::makeTechnique({.grid = scene_.accuracy.grid, .backend = options_.backend});
  }

 private:
  const Scene& scene_;
  const StudyOptions& options_;
  Simulation simulation_;
  SceneView sceneView_;
  const SceneCamera& camera_;
  EffectLedger ledger_;
};

CostPoint pointOf(std::string setting, double error, const Timing& timing, double dial = 0.0) {
  return {std::move(setting), error, 1e3 * timing.median, 1e3 * timing.spread, dial};
}

Study studyResolution(Stage& stage) {
  const glm::ivec2 full = stage.size();
  Study study{
      "picture_resolution",
      "colours, rms of 255, by the picture's size, enlarged to " + sizeText(full) +
          ", and by samples a pixel; truth: " + std::to_string(truthSamples * truthSamples) +
          " samples a pixel; " + stage.where() + " pixels",
      "of 255",
      "ms/frame",
      {}};
  const render::Frame truth = stage.technique()->draw(stage.view(full, truthSamples));
  const auto add = [&](std::string setting, glm::ivec2 size, int samples) {
    const auto technique = stage.technique();
    const render::View view = stage.view(size, samples);
    render::Frame frame;
    const Timing timing =
        timeRepeated([&] { technique->drawInto(view, frame); }, stage.repetitions());
    study.points.push_back(pointOf(std::move(setting), colourError(frame.colour, truth.colour),
                                   timing, double(size.x) * samples));
  };
  for (const int part : {4, 2, 1}) add(sizeText(full / part), full / part, 1);
  for (const int samples : {2, 3}) {
    add(sizeText(full) + ", " + std::to_string(samples * samples) + " samples", full, samples);
  }
  return study;
}

/// A picture drawn again and again with some effects.
struct Repeated {
  Repeated(const Stage& stage, const render::View& seen, const EffectSettings& settings)
      : technique(stage.technique()), ledger(settings), view(seen) {
    view.effects = &ledger;
  }
  void draw() { technique->drawInto(view, frame); }

  std::unique_ptr<render::RenderTechnique> technique;
  EffectLedger ledger;
  render::View view;
  render::Frame frame;
};

Study studyEffects(Stage& stage, const Scene& scene) {
  Study study{"picture_effects",
              "colours, rms of 255, where an effect that the picture calls for is left out, and "
              "what the frame costs without it; truth: all of them; " +
                  stage.where() + " pixels",
              "of 255",
              "ms/frame",
              {},
              "all effects"};
  const render::View view = stage.view(stage.size(), 1);
  std::vector<std::string> settings{study.chosen};
  std::vector<std::unique_ptr<Repeated>> pictures;
  pictures.push_back(std::make_unique<Repeated>(stage, view, scene.effects));
  pictures.front()->draw();
  for (const EffectReport& report : pictures.front()->ledger.report()) {
    if (report.state != EffectState::on) continue;
    EffectSettings without = scene.effects;
    without[static_cast<std::size_t>(report.effect)] = EffectSetting::off;
    settings.push_back("without " + std::string(effectName(report.effect)));
    pictures.push_back(std::make_unique<Repeated>(stage, view, without));
  }
  std::vector<std::function<void()>> works;
  for (const auto& picture : pictures) works.push_back([&each = *picture] { each.draw(); });
  const std::vector<Timing> timings = timeByTurns(works, stage.repetitions());
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    study.points.push_back(
        pointOf(settings[i], colourError(pictures[i]->frame.colour, pictures.front()->frame.colour),
                timings[i]));
  }
  return study;
}

}  // namespace

std::vector<Study> studyPictures(const Scene& scene, const Sea& sea, const StudyOptions& options) {
  Stage stage(scene, sea, options);
  return {studyResolution(stage), studyEffects(stage, scene)};
}

}  // namespace seaway::bridge
