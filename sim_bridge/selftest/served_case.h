#pragma once

#include <string>

namespace seaway::bridge {

/// Asks a service that `seaway serve` runs, once `err`, what it wrote to standard error so far,
/// says that all of its `endpoints` are open: its state and figures over HTTP, and a datagram that
/// is none of CIGI's. False until then. What is wrong with the answers goes to `fault`, which stays
/// as it is where nothing is.
bool askService(const std::string& err, int endpoints, std::string& fault);

}  // namespace seaway::bridge
