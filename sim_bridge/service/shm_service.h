#pragma once

#include <cstdint>
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

/// What `seaway serve` is told about shared memory.
struct ShmServiceOptions {
  std::string name;            ///< of the segment; empty: none
  std::int64_t hosts = 16;     ///< at a time, [1, 256]
  std::int64_t points = 8192;  ///< of a request, [1, 1048576]
};

void addShmOptions(CLI::App& command, ShmServiceOptions& options);

/// Null where no shared memory is asked for. `sea` and `frames` must outlive the endpoint. Throws
/// InputError.
std::unique_ptr<Endpoint> makeShmEndpoint(const ShmServiceOptions& options, ServedSea& sea,
                                          const ServeClock& clock, FrameMaker& frames);

}  // namespace seaway::bridge
