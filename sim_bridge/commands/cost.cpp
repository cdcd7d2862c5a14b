#include "sim_bridge/commands/cost.h"

#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "render/headless_context.h"
#include "sim_bridge/commands/cost_report.h"
#include "sim_bridge/commands/options.h"
#include "sim_bridge/cost/advice.h"
#include "sim_bridge/cost/calibration.h"
#include "sim_bridge/cost/study.h"
#include "sim_bridge/output/atomic_file.h"
#include "sim_bridge/output/number_text.h"
#include "sim_bridge/output/progress.h"
#include "sim_bridge/report/plot.h"
#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene/sea.h"

namespace seaway::bridge {
namespace {

nlohmann::ordered_json asJson(const std::vector<Study>& studies, const std::string& scene) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Study& study : studies) {
    nlohmann::ordered_json points = nlohmann::ordered_json::array();
    for (const CostPoint& point : study.points) {
      points.push_back({{"setting", point.setting},
                        {"error", point.error},
                        {"cost", point.cost},
                        {"spread", point.spread}});
    }
    list.push_back({{"name", study.name},
                    {"summary", study.summary},
                    {"unit_error", study.unitError},
                    {"unit_cost", study.unitCost},
                    {"points", std::move(points)}});
    if (!study.chosen.empty()) list.back()["chosen"] = study.chosen;
  }
  return {{"scene", scene}, {"machine", machineLine()}, {"studies", std::move(list)}};
}

void writeCsv(const std::vector<Study>& studies, std::ostream& out) {
  out << "study,setting,error,unit_error,cost,spread,unit_cost\n";
  for (const Study& study : studies) {
    for (const CostPoint& point : study.points) {
      out << study.name << ",\"" << point.setting << "\"," << numberText(point.error) << ','
          << study.unitError << ',' << numberText(point.cost) << ',' << numberText(point.spread)
          << ',' << study.unitCost << '\n';
    }
  }
}

void writeTables(const std::vector<Study>& studies, std::ostream& out) {
  for (const Study& study : studies) {
    out << study.name << ": " << study.summary << '\n';
    std::size_t width = 16;
    for (const CostPoint& point : study.points) width = std::max(width, point.setting.size());
    out << fmt::format("  {:<{}} {:>14} {:>14} {:>10}\n", "setting", width,
                       "error " + study.unitError, study.unitCost, "spread");
    for (const CostPoint& point : study.points) {
      out << fmt::format("  {:<{}} {:>14.3g} {:>14.4g} {:>10.2g}\n", point.setting, width,
                         point.error, point.cost, point.spread);
    }
  }
}

}  // namespace

int runCost(const CostOptions& options, std::ostream& out) {
  render::requireBackend(options.backend);
  const Scene scene = loadScene(options.scene);
  const std::filesystem::path folder = options.out;
  requireWritableFolder(folder);
  requirePlotter();
  const Sea sea = buildSea(scene);
  const StudyOptions studyOptions{.quick = options.quick, .backend = options.backend};
  std::vector<Study> studies;
  Calibration calibration;
  {
    Progress progress("cost", 9);
    studies.push_back(studyQueryOctaves(scene, sea, studyOptions));
    studies.push_back(studyQueryWays(sea, studyOptions));
    progress.update(1);
    for (Study& study : studyFieldModels(sea, studyOptions)) studies.push_back(std::move(study));
    progress.update(2);
    studies.push_back(studyFitOctaves(studyOptions));
    for (Study& study : studyHullLoads(sea, studyOptions)) studies.push_back(std::move(study));
    progress.update(3);
    for (Study& study : studyLayers(studyOptions)) studies.push_back(std::move(study));
    progress.update(4);
    if (!scene.cameras.empty()) {
      for (Study& study : studyImages(scene, sea, studyOptions)) {
        studies.push_back(std::move(study));
      }
    }
    progress.update(5);
    studies.push_back(studyVertexEfficiency(sea, studyOptions));
    progress.update(6);
    if (!scene.cameras.empty()) {
      for (Study& study : studySwimming(scene, sea, studyOptions)) {
        studies.push_back(std::move(study));
      }
    }
    if (!scene.cameras.empty()) {
      for (const auto& of : {studyPictures, studyTerrain, studyShadows, studyUnderWater}) {
        for (Study& study : of(scene, sea, studyOptions)) studies.push_back(std::move(study));
      }
    }
    progress.update(7);
    for (Study& study : studyWakes(scene, studyOptions)) studies.push_back(std::move(study));
    progress.update(8);
    calibration = calibrate(scene, sea, studyOptions);
    progress.update(9);
  }
  nlohmann::ordered_json json = asJson(studies, options.scene);
  json["calibration"] = asJson(calibration);
  json["advice"] = costAdvice(studies);
  AtomicFile jsonFile(folder / "cost.json"), csvFile(folder / "cost.csv"),
      report(folder / "report.html"), figure(folder / "height_error.svg");
  jsonFile.stream() << json.dump(2) << '\n';
  writeCsv(studies, csvFile.stream());
  report.stream() << costReport(studies, calibration, options.scene);
  figure.stream() << heightErrorFigure(studies);
  jsonFile.commit();
  csvFile.commit();
  report.commit();
  figure.commit();
  if (options.json) {
    out << json.dump(2) << '\n';
  } else {
    writeTables(studies, out);
    for (const std::string& sentence : costAdvice(studies)) out << sentence << '\n';
  }
  return 0;
}

void addCostCommand(CLI::App& app, ChosenCommand& chosen) {
  auto* command =
      app.add_subcommand("cost", "Measure what accuracy costs in time, on this machine");
  auto options = std::make_shared<CostOptions>();
  command->add_option("SCENE", options->scene, "scene file")->required();
  command
      ->add_option("--out", options->out,
                   "folder for report.html, height_error.svg, cost.json and cost.csv")
      ->required()
      ->check(mustBeNamed);
  command->add_flag("--quick", options->quick, "fewer points and repetitions");
  addBackendOption(*command, options->backend);
  command->add_flag("--json", options->json, "machine-readable");
  command->footer("Example:\n  seaway cost configs/scenes/canaveral.yaml --out out/cost --quick");
  command->callback([=, &chosen] { chosen = [=] { return runCost(*options, std::cout); }; });
}

}  // namespace seaway::bridge
