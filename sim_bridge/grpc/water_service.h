#pragma once

#include "sim_bridge/grpc/rpc_server.h"
#include "sim_bridge/grpc/water_host.h"

namespace seaway::bridge::rpc {

/// Adds seaway.v1.Water to a server that is not bound yet. `host` must outlive it.
void addWaterService(RpcServer& server, WaterHost& host);

}  // namespace seaway::bridge::rpc
