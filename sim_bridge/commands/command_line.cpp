#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <new>
#include <string_view>

#include "sim_bridge/commands/buoy.h"
#include "sim_bridge/commands/command.h"
#include "sim_bridge/commands/cost.h"
#include "sim_bridge/commands/explain.h"
#include "sim_bridge/commands/fit.h"
#include "sim_bridge/commands/gallery.h"
#include "sim_bridge/commands/hull.h"
#include "sim_bridge/commands/layer.h"
#include "sim_bridge/commands/query.h"
#include "sim_bridge/commands/render.h"
#include "sim_bridge/commands/run.h"
#include "sim_bridge/commands/sail.h"
#include "sim_bridge/commands/schema_command.h"
#include "sim_bridge/commands/selftest.h"
#include "sim_bridge/commands/serve.h"
#include "sim_bridge/commands/soak.h"
#include "sim_bridge/commands/tune.h"
#include "sim_bridge/commands/wake.h"
#include "sim_bridge/output/unfinished_files.h"
#include "sim_bridge/scene/schema.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

// A new command is one line here.
constexpr AddCommand commands[] = {
    addRunCommand,     addQueryCommand, addRenderCommand, addFitCommand,      addExplainCommand,
    addCostCommand,    addBuoyCommand,  addWakeCommand,   addLayerCommand,    addServeCommand,
    addHullCommand,    addSailCommand,  addSchemaCommand, addSelftestCommand, addTuneCommand,
    addGalleryCommand, addSoakCommand,
};

constexpr int failed = 1;
constexpr int badInput = 2;

int runChosen(const ChosenCommand& chosen) {
  try {
    const int status = chosen();
    std::cout.flush();
    if (std::cout) return status;
    spdlog::error("standard output could not be written (disk full or closed?)");
    return failed;
  } catch (const InputError& fault) {
    spdlog::error("{}", fault.what());
    return badInput;
  } catch (const std::bad_alloc&) {
    spdlog::error("not enough memory");
    return failed;
  } catch (const std::exception& fault) {
    spdlog::error("{}", fault.what());
    return failed;
  }
}

/// What is wrong with the command's name; empty where nothing is.
std::string faultOfCommand(const CLI::App& app, std::string_view word) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  const bool known = std::find(names.begin(), names.end(), word) != names.end();
  if (known || word.substr(0, 1) == "-") return "";
  const std::string nearest = nearestName(std::string(word), names);
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return "'" + std::string(word) + "' is no command; " +
         (nearest.empty() ? "" : "did you mean '" + nearest + "'? ") + "must be one of: " + all;
}

void logToStandardError() {
  const auto logger = std::make_shared<spdlog::logger>(
      "seaway", std::make_shared<spdlog::sinks::stderr_color_sink_mt>());
  logger->set_pattern("seaway: %^%l%$: %v");
  spdlog::set_default_logger(logger);
}

}  // namespace

int runCommandLine(int argc, const char* const* argv) {
  logToStandardError();
  removeUnfinishedFilesOnSignals();
  CLI::App app("One sea for vehicle simulators: queried, rendered and geo-referenced.", "seaway");
  app.require_subcommand(1);
  app.set_version_flag("--version", SEAWAY_VERSION);
  app.footer("`seaway COMMAND --help` shows a command's options and an example.");
  ChosenCommand chosen;
  for (const AddCommand add : commands) add(app, chosen);
  const std::string unknown = argc > 1 ? faultOfCommand(app, argv[1]) : "";
  if (!unknown.empty()) {
    spdlog::error("{}", unknown);
    return badInput;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& fault) {
    return app.exit(fault) == 0 ? 0 : badInput;
  }
  return runChosen(chosen);
}

}  // namespace seaway::bridge
