#pragma once

#include <string>

#include "sim_bridge/commands/command.h"
#include "sim_bridge/service/cigi_service.h"
#include "sim_bridge/service/metrics_service.h"

namespace seaway::bridge {

struct ServeOptions {
  std::string scene;
  std::string clock = "host";      ///< host, real or xN
  std::string logFormat = "text";  ///< or json
  CigiServiceOptions cigi;
  MetricsServiceOptions metrics;
};

/// `seaway serve`: lets others ask a scene's sea until SIGINT or SIGTERM, then answers what has
/// arrived and ends with status 0. Each endpoint tells its address when it begins and what it has
/// counted when it ends, on standard error. All addresses are taken before any is served.
/// SIGHUP loads the scene's file anew while all is served on (ServedSea::replaceScene); a bad one
/// is told, and the old scene stays.
int runServe(const ServeOptions& options);
void addServeCommand(CLI::App& app, ChosenCommand& chosen);

}  // namespace seaway::bridge
