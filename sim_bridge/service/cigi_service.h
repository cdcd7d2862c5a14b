#pragma once

#include <memory>
#include <string>

#include "sim_bridge/service/endpoint.h"
#include "sim_bridge/service/frame_maker.h"
#include "sim_bridge/service/serve_clock.h"
#include "sim_bridge/service/served_sea.h"

namespace CLI {
class App;
}

namespace seaway::bridge {

/// What `seaway serve` is told about CIGI.
struct CigiServiceOptions {
  std::string address;                 ///< [HOST:]PORT; empty: no CIGI
  std::string pacing = "synchronous";  ///< or asynchronous
  double rate = 60.0;                  ///< Starts of Frame a second
  std::string greet;                   ///< HOST:PORT that hears from us first; empty: nobody
  std::string version = "3.3";         ///< spoken to it: 3.3 or 4.0
};

void addCigiOptions(CLI::App& command, CigiServiceOptions& options);

/// Null where no CIGI is asked for. Counts under `cigi`. `sea` and `frames` must outlive the
/// endpoint. Throws InputError.
std::unique_ptr<Endpoint> makeCigiEndpoint(const CigiServiceOptions& options, ServedSea& sea,
                                           const ServeClock& clock, FrameMaker& frames);

}  // namespace seaway::bridge
