#pragma once

#include "sim_bridge/grpc/rpc_server.h"

namespace seaway::bridge::rpc {

/// Adds grpc.health.v1.Health: a service that the server has is SERVING, and NOT_SERVING from when
/// the server begins to end; Watch tells that within about a tenth of a second.
void addHealthService(RpcServer& server);

/// Adds grpc.reflection.v1alpha.ServerReflection: the server's services, and the files of the
/// program's messages. No message has extensions.
void addReflectionService(RpcServer& server);

}  // namespace seaway::bridge::rpc
