#include "sim_bridge/commands/serve.h"

#include <pthread.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <memory>
#include <vector>

#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene/sea.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

/// SIGINT and SIGTERM held back from every thread that is started from now on, to be waited for.
class EndSignals {
 public:
  EndSignals() {
    sigemptyset(&signals_);
    sigaddset(&signals_, SIGINT);
    sigaddset(&signals_, SIGTERM);
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

// A new kind of endpoint is one line here.
std::vector<std::unique_ptr<Endpoint>> endpointsFor(const ServeOptions& options, ServedSea& sea,
                                                    const ServeClock& clock, FrameMaker& frames) {
  std::vector<std::unique_ptr<Endpoint>> endpoints;
  if (auto cigi = makeCigiEndpoint(options.cigi, sea, clock)) endpoints.push_back(std::move(cigi));
  if (auto shm = makeShmEndpoint(options.shm, sea, clock, frames))
    endpoints.push_back(std::move(shm));
  if (endpoints.empty()) throw InputError("nothing to serve; give one of: --cigi, --shm");
  return endpoints;
}

}  // namespace

int runServe(const ServeOptions& options) {
  const EndSignals signals;
  const ServeClock clock = ServeClock::parse("--clock", options.clock);
  const Scene scene = loadScene(options.scene);
  ServedSea sea(scene, buildSea(scene));
  FrameMaker frames(sea);
  const auto endpoints = endpointsFor(options, sea, clock, frames);
  for (const auto& endpoint : endpoints) {
    endpoint->start();
    spdlog::info("{} serves {}", endpoint->description(), options.scene);
  }
  const int signal = signals.wait();
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
  addCigiOptions(*command, options->cigi);
  addShmOptions(*command, options->shm);
  command->footer("Example:\n  seaway serve configs/scenes/canaveral.yaml --cigi 8004");
  command->callback([=, &chosen] { chosen = [=] { return runServe(*options); }; });
}

}  // namespace seaway::bridge
