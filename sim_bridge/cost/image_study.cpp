#include <algorithm>
#include <cmath>

#include "render/technique_choice.h"
#include "sim_bridge/cost/image_truth.h"
#include "sim_bridge/cost/study.h"
#include "sim_bridge/scene/partial_sea.h"

namespace seaway::bridge {
namespace {

/// One way of drawing, timed and held against the truth.
struct Drawn {
  std::string setting;
  double dial = 0.0;
  Timing timing;
  ImageErrors errors;
};

Drawn draw(const ImageTruth& truth, const render::View& view, const render::TechniqueChoice& choice,
           std::string setting, const StudyOptions& options) {
  const auto technique = render::makeTechnique(choice);
  render::Frame frame;
  // Vertices a side of a square of as many.
  const double side = std::sqrt(static_cast<double>(choice.grid.x) * choice.grid.y);
  Drawn drawn{std::move(setting), side, {}, {}};
  drawn.timing = timeRepeated([&] { frame = technique->draw(view); }, options.quick ? 3 : 5);
  drawn.errors = truth.errorsOf(frame);
  return drawn;
}

void add(const Drawn& drawn, double error, Study& study) {
  study.points.push_back(
      {drawn.setting, error, 1e3 * drawn.timing.median, 1e3 * drawn.timing.spread, drawn.dial});
}

std::vector<Study> studyGrids(const ImageTruth& truth, glm::ivec2 own,
                              const StudyOptions& options) {
  Study place{
      "image_position_grid",
      "place of the surface in the picture, rms away from silhouettes; truth: a ray through "
      "every pixel" +
          truth.where(),
      "px",
      "ms/frame",
      {}};
  Study depth{"image_depth_grid",
              "axial depth of water pixels, median; truth: ray-march of the field" + truth.where(),
              "m",
              "ms/frame",
              {}};
  Study height{"image_height_grid",
               "height of the drawn surface against the field queried there, rms" + truth.where(),
               "m",
               "ms/frame",
               {}};
  const std::vector<int> grids = options.quick ? std::vector<int>{32, 128, 512}
                                               : std::vector<int>{32, 64, 128, 256, 512, 1024};
  std::vector<glm::ivec2> all;
  for (const int side : grids) all.push_back({side, side});
  if (std::find(all.begin(), all.end(), own) == all.end()) all.push_back(own);
  std::stable_sort(all.begin(), all.end(),
                   [](const glm::ivec2& a, const glm::ivec2& b) { return a.x * a.y < b.x * b.y; });
  for (const glm::ivec2& grid : all) {
    const Drawn drawn = draw(truth, truth.view(), {.grid = grid, .backend = options.backend},
                             "grid " + sizeText(grid), options);
    add(drawn, drawn.errors.position, place);
    add(drawn, drawn.errors.depth, depth);
    add(drawn, drawn.errors.height, height);
  }
  for (Study* study : {&place, &depth, &height}) study->chosen = "grid " + sizeText(own);
  return {place, depth, height};
}

std::vector<Study> studyTechniques(const ImageTruth& truth, const StudyOptions& options) {
  Study place{"image_position_technique",
              "place of the surface in the picture by technique, rms away from silhouettes; truth: "
              "a ray through every pixel" +
                  truth.where(),
              "px",
              "ms/frame",
              {}};
  Study depth{"image_depth_technique",
              "axial depth of water pixels by technique, median; truth: ray-march of the field" +
                  truth.where(),
              "m",
              "ms/frame",
              {}};
  const std::vector<int> grids =
      options.quick ? std::vector<int>{128, 512} : std::vector<int>{128, 256, 512, 1024};
  for (const char* technique : {"projected_grid", "radial_grid", "post_process"}) {
    for (const int side : grids) {
      Drawn drawn = draw(truth, truth.view(), {.technique = technique, .grid = {side, side}},
                         std::string(technique) + " " + sizeText({side, side}), options);
      drawn.dial = 0.0;
      add(drawn, drawn.errors.position, place);
      add(drawn, drawn.errors.depth, depth);
    }
  }
  return {place, depth};
}

Study studyOctaves(const ImageTruth& truth, const Scene& scene, const StudyOptions& options) {
  Study study{
      "image_octaves",
      "height of the drawn surface against the field queried there, rms, by how many octaves "
      "are drawn; truth: all octaves" +
          truth.where(),
      "m",
      "ms/frame",
      {}};
  const WaterSurface& water = *truth.view().water;
  const std::size_t all = water.waves().octaves().size();
  std::vector<std::size_t> counts{0};
  for (std::size_t kept = 1; kept < all; kept *= 2) counts.push_back(kept);
  if (all > 0) counts.push_back(all);
  for (const std::size_t kept : counts) {
    Sea fewer = buildPartialSea(scene, kept);
    fewer.surface.setDetail(water.extras().detail);
    const auto wakes = std::make_shared<DisturbanceFeed>();
    wakes->publish(water.disturbances());
    fewer.surface.setDisturbances(wakes);
    render::View view = truth.view();
    view.water = &fewer.surface;
    const std::string setting = "octaves " + std::to_string(kept);
    Drawn drawn = draw(truth, view, {.grid = scene.accuracy.grid, .backend = options.backend},
                       setting, options);
    drawn.dial = static_cast<double>(kept);
    add(drawn, drawn.errors.height, study);
  }
  study.chosen = "octaves " + std::to_string(all);
  return study;
}

}  // namespace

std::vector<Study> studyImages(const Scene& scene, const Sea& sea, const StudyOptions& options) {
  const ImageTruth truth(scene, sea, options);
  if (!truth.showsWater()) return {};
  std::vector<Study> studies = studyGrids(truth, scene.accuracy.grid, options);
  for (Study& study : studyTechniques(truth, options)) studies.push_back(std::move(study));
  studies.push_back(studyOctaves(truth, scene, options));
  return studies;
}

}  // namespace seaway::bridge
