#include "sim_bridge/commands/serve.h"

#include <pthread.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene/sea.h"
#include "sim_bridge/service/service_log.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

/// SIGINT, SIGTERM and SIGHUP held back from every thread that is started from now on, to be waited
/// for.
class EndSignals {
 public:
  EndSignals() {
    sigemptyset(&signals_);
    sigaddset(&signals_, SIGINT);
    sigaddset(&signals_, SIGTERM);
    sigaddset(&signals_, SIGHUP);
    pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
  }
  int wait() const {
    int signal = 0;
    sigwait(&signals_, &signal);
    return signal;
  }

 private:
  sigset_t signals_;
};

using Endpoints = std::vector<std::unique_ptr<Endpoint>>;

std::vector<std::string> descriptionsOf(const Endpoints& endpoints) {
  std::vector<std::string> all;
  for (const auto& endpoint : endpoints) all.push_back(endpoint->description());
  return all;
}

// A new kind of endpoint is one line here. The one that tells of the others ends first.
void makeEndpoints(const ServeOptions& options, ServedSea& sea, const ServeClock& clock,
                   FrameMaker& frames, Endpoints& endpoints) {
  const auto add = [&](std::unique_ptr<Endpoint> made) {
    if (made) endpoints.push_back(std::move(made));
  };
  add(makeMetricsEndpoint(options.metrics, sea, clock, frames,
                          [&endpoints] { return descriptionsOf(endpoints); }));
  add(makeCigiEndpoint(options.cigi, sea, clock, frames));
  add(makeGrpcEndpoint(options.grpc, sea, clock, frames));
  add(makeXdynEndpoint(options.grpc, sea));
  add(makeShmEndpoint(options.shm, sea, clock, frames));
  if (endpoints.empty()) {
    throw InputError("nothing to serve; give one of: --cigi, --grpc, --xdyn, --shm, --metrics");
  }
}

/// Free vessels sail along with a clock of the service's own, also while nobody asks.
void followClock(const std::stop_token& stop, const ServeClock& clock, ServedSea& sea) {
  std::mutex mutex;
  std::condition_variable_any ended;
  std::unique_lock lock(mutex);
  while (!stop.stop_requested()) {
    if (sea.hasFreeVessels()) sea.attend(clock.now(), {});
    ended.wait_for(lock, stop, std::chrono::milliseconds(250), [] { return false; });
  }
}

void reload(const std::string& file, ServedSea& sea) {
  try {
    const Scene scene = loadScene(file);
    sea.replaceScene(scene, buildSea(scene));
    spdlog::info("{} is loaded anew", file);
  } catch (const std::exception& fault) {
    spdlog::error("the scene stays as it was: {}", fault.what());
  }
}

}  // namespace

int runServe(const ServeOptions& options) {
  prepareGrpc(options.grpc);
  const EndSignals signals;
  beginServiceLog("--log-format", options.logFormat);
  const ServeClock clock = ServeClock::parse("--clock", options.clock);
  const Scene scene = loadScene(options.scene);
  ServedSea sea(scene, buildSea(scene));
  FrameMaker frames(sea);
  Endpoints endpoints;
  makeEndpoints(options, sea, clock, frames, endpoints);
  for (const auto& endpoint : endpoints) {
    endpoint->start();
    spdlog::info("{} serves {}", endpoint->description(), options.scene);
  }
  std::jthread follower;
  if (!clock.isHosts()) {
    follower = std::jthread([&](const std::stop_token& stop) { followClock(stop, clock, sea); });
  }
  int signal = signals.wait();
  for (; signal == SIGHUP; signal = signals.wait()) reload(options.scene, sea);
  spdlog::info("{}: ending", signal == SIGINT ? "interrupted" : "terminated");
  for (const auto& endpoint : endpoints) endpoint->stop();
  return 0;
}

void addServeCommand(CLI::App& app, ChosenCommand& chosen) {
  auto* command =
      app.add_subcommand("serve", "Let other simulators ask a scene's sea until it is ended");
  auto options = std::make_shared<ServeOptions>();
  command->add_option("SCENE", options->scene, "scene file")->required();
  command
      ->add_option(
          "--clock", options->clock,
          "whose time: host (each request's own), real (from 0 on), or xN, N times as fast")
      ->capture_default_str();
  command->add_option("--log-format", options->logFormat, "text, or json: one object a line")
      ->capture_default_str();
  addMetricsOptions(*command, options->metrics);
  addCigiOptions(*command, options->cigi);
  addGrpcOptions(*command, options->grpc);
  addShmOptions(*command, options->shm);
  command->footer(
      "Example:\n  seaway serve configs/scenes/canaveral.yaml --cigi 8004 "
      "--metrics 9100");
  command->callback([=, &chosen] { chosen = [=] { return runServe(*options); }; });
}

}  // namespace seaway::bridge
