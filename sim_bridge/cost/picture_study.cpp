#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "render/technique_choice.h"
#include "sim_bridge/cost/study.h"
#include "sim_bridge/scene_view.h"

namespace seaway::bridge {
namespace {

constexpr int truthSamples = 6;  // a side

std::string sizeText(glm::ivec2 size) {
  return std::to_string(size.x) + "x" + std::to_string(size.y);
}

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
        camera_(findCamera(scene, "")) {}

  glm::ivec2 size() const { return options_.quick ? glm::ivec2(320, 180) : glm::ivec2(640, 360); }
  std::string where() const { return "camera '" + camera_.name + "', " + sizeText(size()); }

  struct Drawn {
    render::ColourImage colour;
    Timing timing;
    std::vector<EffectReport> effects;
  };
  /// Draws as the scene does, so many times over.
  Drawn draw(glm::ivec2 size, int samplesPerSide, const EffectSettings& settings,
             bool timed = true) {
    const auto technique =
        render::makeTechnique({.grid = scene_.accuracy.grid, .backend = options_.backend});
    EffectLedger ledger(settings);
    render::View view = sceneView_.view(simulation_, camera_, size, ledger);
    view.samplesPerSide = samplesPerSide;
    view.light.dithers = false;
    render::Frame frame;
    Drawn drawn;
    const auto work = [&] { technique->drawInto(view, frame); };
    if (timed) drawn.timing = timeRepeated(work, options_.quick ? 3 : 5);
    if (!timed) work();
    drawn.colour = std::move(frame.colour);
    drawn.effects = ledger.report();
    return drawn;
  }

 private:
  const Scene& scene_;
  const StudyOptions& options_;
  Simulation simulation_;
  SceneView sceneView_;
  const SceneCamera& camera_;
};

CostPoint pointOf(std::string setting, double error, const Timing& timing, double dial = 0.0) {
  return {std::move(setting), error, 1e3 * timing.median, 1e3 * timing.spread, dial};
}

Study studyResolution(Stage& stage, const Scene& scene) {
  const glm::ivec2 full = stage.size();
  Study study{
      "picture_resolution",
      "colours, rms of 255, by the picture's size, enlarged to " + sizeText(full) +
          ", and by samples a pixel; truth: " + std::to_string(truthSamples * truthSamples) +
          " samples a pixel; " + stage.where() + " pixels",
      "of 255",
      "ms/frame",
      {}};
  const render::ColourImage truth = stage.draw(full, truthSamples, scene.effects, false).colour;
  for (const int part : {8, 4, 2, 1}) {
    const Stage::Drawn drawn = stage.draw(full / part, 1, scene.effects);
    study.points.push_back(pointOf(sizeText(full / part), colourError(drawn.colour, truth),
                                   drawn.timing, full.x / part));
  }
  for (const int samples : {2, 3}) {
    const Stage::Drawn drawn = stage.draw(full, samples, scene.effects);
    study.points.push_back(
        pointOf(sizeText(full) + ", " + std::to_string(samples * samples) + " samples",
                colourError(drawn.colour, truth), drawn.timing, full.x * samples));
  }
  study.chosen = sizeText(full);
  return study;
}

Study studyEffects(Stage& stage, const Scene& scene) {
  Study study{"picture_effects",
              "colours, rms of 255, where an effect that the picture calls for is left out, and "
              "what the frame costs without it; truth: all of them; " +
                  stage.where() + " pixels",
              "of 255",
              "ms/frame",
              {}};
  const Stage::Drawn all = stage.draw(stage.size(), 1, scene.effects);
  study.chosen = "all effects";
  study.points.push_back(pointOf(study.chosen, 0.0, all.timing));
  for (const EffectReport& report : all.effects) {
    if (report.state != EffectState::on) continue;
    EffectSettings without = scene.effects;
    without[static_cast<std::size_t>(report.effect)] = EffectSetting::off;
    const Stage::Drawn drawn = stage.draw(stage.size(), 1, without);
    study.points.push_back(pointOf("without " + std::string(effectName(report.effect)),
                                   colourError(drawn.colour, all.colour), drawn.timing));
  }
  return study;
}

}  // namespace

std::vector<Study> studyPictures(const Scene& scene, const Sea& sea, const StudyOptions& options) {
  Stage stage(scene, sea, options);
  return {studyResolution(stage, scene), studyEffects(stage, scene)};
}

}  // namespace seaway::bridge
