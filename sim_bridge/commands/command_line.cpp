#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "sim_bridge/commands/buoy.h"
#include "sim_bridge/commands/command.h"
#include "sim_bridge/commands/cost.h"
#include "sim_bridge/commands/explain.h"
#include "sim_bridge/commands/fit.h"
#include "sim_bridge/commands/query.h"
#include "sim_bridge/commands/render.h"
#include "sim_bridge/commands/run.h"
#include "sim_bridge/commands/schema_command.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

// A new command is one line here.
constexpr AddCommand commands[] = {
    addRunCommand,     addQueryCommand, addRenderCommand, addFitCommand,
    addExplainCommand, addCostCommand,  addBuoyCommand,   addSchemaCommand,
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
  } catch (const std::exception& fault) {
    spdlog::error("{}", fault.what());
    return failed;
  }
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
  CLI::App app("One sea for vehicle simulators: queried, rendered and geo-referenced.", "seaway");
  app.require_subcommand(1);
  app.set_version_flag("--version", SEAWAY_VERSION);
  app.footer("`seaway COMMAND --help` shows a command's options and an example.");
  ChosenCommand chosen;
  for (const AddCommand add : commands) add(app, chosen);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& fault) {
    return app.exit(fault) == 0 ? 0 : badInput;
  }
  return runChosen(chosen);
}

}  // namespace seaway::bridge
