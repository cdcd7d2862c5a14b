#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sim_bridge/service/endpoint.h"
#include "sim_bridge/service/frame_maker.h"
#include "sim_bridge/service/serve_clock.h"
#include "sim_bridge/service/served_sea.h"

namespace CLI {
class App;
}

namespace seaway::bridge {

/// What `seaway serve` is told about its metrics and its page.
struct MetricsServiceOptions {
  std::string address;  ///< [HOST:]PORT; empty: none
};

void addMetricsOptions(CLI::App& command, MetricsServiceOptions& options);

/// HTTP for those who watch a service; GET only:
///
///   /                 a page for people (statusPage); ?camera=NAME
///   /status.json      the same as data
///   /metrics          for Prometheus
///   /camera/NAME.png  a picture; ?t=SECONDS (else now), &size=WIDTHxHEIGHT (else the scene's)
///   /healthz          "ok"
///
/// Bad requests are answered 400 or 404 with a line that says why, and counted under `http`. Null
/// where no address is given. All that is given must outlive the endpoint. Throws InputError where
/// the address cannot be taken.
std::unique_ptr<Endpoint> makeMetricsEndpoint(
    const MetricsServiceOptions& options, ServedSea& sea, const ServeClock& clock,
    FrameMaker& frames, std::function<std::vector<std::string>()> descriptions);

}  // namespace seaway::bridge
