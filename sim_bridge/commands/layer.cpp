#include "sim_bridge/commands/layer.h"

#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "sim_bridge/commands/options.h"
#include "sim_bridge/output/atomic_file.h"
#include "sim_bridge/output/unfinished_files.h"
#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene/sea.h"
#include "sim_bridge/scene/vessel_launch.h"
#include "sim_bridge/scene_detail.h"
#include "sim_bridge/scene_view.h"
#include "surface/disturbance/layers/layer_file.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

namespace fs = std::filesystem;

void describe(const std::vector<GridSummary>& grids, bool asJson, std::ostream& out) {
  if (asJson) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const GridSummary& grid : grids) {
      list.push_back({{"name", grid.name},
                      {"type", grid.type},
                      {"voxels", grid.voxels},
                      {"voxel_m", grid.voxelSize},
                      {"lower_m", {grid.lower.x, grid.lower.y}},
                      {"upper_m", {grid.upper.x, grid.upper.y}}});
    }
    out << nlohmann::ordered_json{{"grids", std::move(list)}}.dump(2) << '\n';
    return;
  }
  out << fmt::format("{:<16} {:<8} {:>10} {:>9}  {}\n", "grid", "type", "voxels", "voxel m",
                     "east and north of the anchor, m");
  for (const GridSummary& grid : grids) {
    out << fmt::format("{:<16} {:<8} {:>10} {:>9g}  [{:.2f}, {:.2f}] x [{:.2f}, {:.2f}]\n",
                       grid.name, grid.type, grid.voxels, grid.voxelSize, grid.lower.x,
                       grid.upper.x, grid.lower.y, grid.upper.y);
  }
}

/// Written beside and renamed: the file is whole or not there.
void writeWhole(const fs::path& file, const std::vector<LayerGrid>& layers, double t,
                const std::map<std::string, std::string>& notes) {
  requireWritableFile(file);
  const fs::path beside = file.string() + ".part.vdb";
  const UnfinishedFile unfinished(beside);
  try {
    writeLayers(beside, layers, t, notes);
    fs::rename(beside, file);
  } catch (...) {
    std::error_code ignored;
    fs::remove(beside, ignored);
    throw;
  }
}

std::vector<LayerGrid> gridsOf(const SurfaceDetail* detail) {
  std::vector<LayerGrid> grids;
  if (!detail) return grids;
  const auto add = [&](const char* name, const std::shared_ptr<const SurfaceLayer>& layer) {
    if (layer) grids.push_back({name, layer.get()});
  };
  add("foam", detail->cover.foam);
  add("smooth", detail->cover.smooth);
  add("oil", detail->cover.oil);
  return grids;
}

/// Where a vessel is free, only its motion tells where its trail lies.
std::shared_ptr<const SurfaceDetail> detailAt(const Scene& scene, const Sea& sea, double t) {
  if (anySailsFreely(scene)) {
    return replayWithProgress(scene, sea, t).surface().extras().detail;
  }
  SceneDetail detail(scene, sea);
  detail.advance(t);
  return detail.detail();
}

}  // namespace

int runLayer(const LayerOptions& options, std::ostream& out) {
  const fs::path input(options.input);
  if (input.extension() == ".vdb") {
    if (!options.out.empty()) {
      throw InputError("--out: is for scenes; an OpenVDB file is only described");
    }
    describe(describeGrids(input), options.json, out);
    return 0;
  }
  if (options.out.empty()) throw InputError("--out: is wanted with a scene: an OpenVDB file");
  if (fs::path(options.out).extension() != ".vdb") {
    throw InputError("--out: '" + options.out + "' is not allowed; must end in .vdb");
  }
  const Scene scene = loadScene(input);
  const double time = requireTime(options.time);
  requireWritableFile(options.out);
  const Sea sea = buildSea(scene);
  const std::shared_ptr<const SurfaceDetail> detail = detailAt(scene, sea, time);
  const std::vector<LayerGrid> grids = gridsOf(detail.get());
  if (grids.empty()) {
    throw InputError(input.string(), 0,
                     "nothing lies on the water at " + std::to_string(time) +
                         " s: no vessel under way, no splash, no `layers`");
  }
  writeWhole(options.out, grids, time,
             {{"anchor_latitude_deg", std::to_string(scene.sea.anchor.latitude_deg)},
              {"anchor_longitude_deg", std::to_string(scene.sea.anchor.longitude_deg)},
              {"scene", input.filename().string()}});
  describe(describeGrids(options.out), options.json, out);
  return 0;
}

void addLayerCommand(CLI::App& app, ChosenCommand& chosen) {
  auto* command = app.add_subcommand(
      "layer",
      "Write what lies on the water (foam, smoothed water, oil) as OpenVDB, or describe it");
  auto options = std::make_shared<LayerOptions>();
  command->add_option("INPUT", options->input, "scene file, or an OpenVDB file to describe")
      ->required();
  command->add_option("--time", options->time, "seconds since the scene's epoch >= 0 (default 0)");
  command->add_option("--out", options->out, "OpenVDB file to write")->check(mustBeNamed);
  command->add_flag("--json", options->json, "machine-readable");
  command->footer(
      "Example:\n  seaway layer configs/scenes/canaveral.yaml --time 20 --out layers.vdb");
  command->callback([=, &chosen] { chosen = [=] { return runLayer(*options, std::cout); }; });
}

}  // namespace seaway::bridge
