#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "render/headless_context.h"
#include "render/png.h"
#include "render/technique_choice.h"
#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene_view.h"

/// A scene's cameras drawn by every variant through one context, against the processor's pictures
/// of the same program and, where given, against pictures that another context drew before:
///
///   compare_pictures configs/scenes/crater_lake.yaml --write FOLDER             with OSMesa
///   compare_pictures configs/scenes/crater_lake.yaml --backend egl:0 --against FOLDER
///
/// JSON on standard output: for each picture its classes, pixels of another class than the
/// processor's, those of them that have none of their class within 2 pixels there, relative
/// differences of depth, and differences of colour.
namespace {

using namespace seaway;
using namespace seaway::render;
using Json = nlohmann::ordered_json;

struct Options {
  std::string scene, backend = "osmesa", write, against;
  double time = 5.0;
  glm::ivec2 size{640, 360}, grid{256, 256};
};

constexpr GridVariant variants[] = {GridVariant::cpuVertices, GridVariant::gpu,
                                    GridVariant::cpuVerticesGpuNormals, GridVariant::marched};

/// Pixels of `one` with none of their class within 2 pixels in `other`.
std::size_t strays(const Frame& one, const Frame& other) {
  const glm::ivec2 size = one.depth.size;
  std::size_t found = 0;
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const PixelClass wanted = one.classes[static_cast<std::size_t>(y) * size.x + x];
      bool near = false;
      for (int v = std::max(0, y - 2); v <= std::min(size.y - 1, y + 2); ++v) {
        for (int u = std::max(0, x - 2); u <= std::min(size.x - 1, x + 2); ++u) {
          near = near || other.classes[static_cast<std::size_t>(v) * size.x + u] == wanted;
        }
      }
      found += !near;
    }
  }
  return found;
}

Json colourDifference(const ColourImage& a, const ColourImage& b) {
  double sum = 0.0;
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
    int largest = 0;
    for (std::size_t c = i; c < i + 3; ++c) {
      const int difference = std::abs(int{a.rgb[c]} - int{b.rgb[c]});
      sum += difference;
      largest = std::max(largest, difference);
    }
    beyond += largest > 4;
  }
  const auto pixels = static_cast<double>(a.rgb.size()) / 3.0;
  return {{"mean_of_255", sum / (3.0 * pixels)},
          {"pixels_beyond_4_of_255_percent", 100.0 * static_cast<double>(beyond) / pixels}};
}

Json depthDifference(const Frame& a, const Frame& b) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < a.classes.size(); ++i) {
    if (a.classes[i] != b.classes[i] || a.classes[i] == PixelClass::sky) continue;
    ratios.push_back(std::abs(a.depth.metres[i] / b.depth.metres[i] - 1.0));
  }
  if (ratios.empty()) return nullptr;
  std::sort(ratios.begin(), ratios.end());
  return {{"median", ratios[ratios.size() / 2]}, {"p99", ratios[ratios.size() * 99 / 100]}};
}

Json difference(const Frame& frame, const Frame& truth) {
  std::size_t other = 0, notNumbers = 0;
  for (std::size_t i = 0; i < frame.classes.size(); ++i) {
    other += frame.classes[i] != truth.classes[i];
    notNumbers += !(frame.depth.metres[i] > 0.0f);
  }
  return {{"other_class_px", other},
          {"far_px", strays(frame, truth) + strays(truth, frame)},
          {"not_a_number", notNumbers},
          {"depth_relative", depthDifference(frame, truth)},
          {"colour", colourDifference(frame.colour, truth.colour)}};
}

Json classesOf(const Frame& frame) {
  const auto count = [&](PixelClass wanted) {
    return std::count(frame.classes.begin(), frame.classes.end(), wanted);
  };
  return {{"sky", count(PixelClass::sky)},
          {"water", count(PixelClass::water)},
          {"object", count(PixelClass::object)},
          {"ground", count(PixelClass::ground)}};
}

Json effectsThatAreOn(const EffectLedger& ledger) {
  Json names = Json::array();
  for (const EffectReport& report : ledger.report()) {
    if (report.state != EffectState::on) continue;
    names.push_back(std::string(effectName(report.effect)));
  }
  return names;
}

Json comparedPicture(const Options& options, const std::string& name, const Frame& frame,
                     const Frame& truth) {
  Json entry{{"picture", name}, {"classes", classesOf(frame)}};
  entry["against_processor"] = difference(frame, truth);
  if (!options.write.empty()) writePng(options.write + '/' + name + ".png", frame.colour);
  if (!options.against.empty()) {
    entry["against_picture"] =
        colourDifference(frame.colour, readPng(options.against + '/' + name + ".png"));
  }
  return entry;
}

Json compareScene(const Options& options) {
  const bridge::Scene scene = bridge::loadScene(options.scene);
  const bridge::Sea sea = bridge::buildSea(scene);
  const bridge::Simulation simulation = bridge::Simulation::replayed(scene, sea, options.time);
  bridge::SceneView sceneView(scene);
  const auto context = makeHeadlessContext(options.backend);
  const auto onProcessor = makeSoftwareGrid({.grid = options.grid});
  Json pictures = Json::array();
  for (const GridVariant variant : variants) {
    const auto technique = makeProjectedGrid(*context, {.grid = options.grid, .variant = variant});
    for (const bridge::SceneCamera& camera : scene.cameras) {
      EffectLedger ledger(scene.effects);
      const View view = sceneView.view(simulation, camera, options.size, ledger);
      const Frame truth = onProcessor->draw(view);
      const Frame frame = technique->draw(view);
      const std::string name = camera.name + '_' + std::string(gridVariantName(variant));
      pictures.push_back(comparedPicture(options, name, frame, truth));
      pictures.back()["effects"] = effectsThatAreOn(ledger);
    }
  }
  return {{"scene", options.scene},
          {"backend", options.backend},
          {"renderer", context->renderer()},
          {"size", {options.size.x, options.size.y}},
          {"grid", {options.grid.x, options.grid.y}},
          {"pictures", pictures}};
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("A scene's pictures through a context against the processor's");
  app.add_option("SCENE", options.scene)->required();
  app.add_option("--backend", options.backend);
  app.add_option("--time", options.time, "s since the scene's epoch");
  app.add_option("--width", options.size.x);
  app.add_option("--height", options.size.y);
  app.add_option("--write", options.write, "folder for the pictures");
  app.add_option("--against", options.against, "folder of pictures written before");
  CLI11_PARSE(app, argc, argv);
  try {
    std::cout << compareScene(options).dump(2) << '\n';
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
  return 0;
}
