#pragma once

#include <string>

namespace seaway::bridge::rpc {

/// An address of gRPC from what the command line says: `[HOST:]PORT` (parseSocketAddress) or
/// `unix:PATH`. Throws InputError, which begins with `option`.
std::string rpcAddress(const std::string& option, const std::string& text);

/// Whether only processes of this machine can reach it: 127.0.0.0/8, ::1, localhost, unix sockets.
bool isLocal(const std::string& address);

/// Throws InputError where somebody listens there already. (gRPC takes over the socket of another
/// process, and says little of a port in use.)
void requireFreeAddress(const std::string& option, const std::string& address);

/// `address` with the port that it was given.
std::string boundAddress(const std::string& address, int port);

}  // namespace seaway::bridge::rpc
