#pragma once

#include <cstdint>
#include <string>

namespace seaway::bridge {

struct SocketAddress {
  std::string host;
  std::uint16_t port = 0;

  /// "127.0.0.1:8004", "[::1]:8004".
  std::string text() const;
};

/// Reads `[HOST:]PORT`, with HOST a name, an IPv4 address or an IPv6 address in brackets; without
/// one the loopback, 127.0.0.1. Port 0: any that is free. Throws InputError, which begins with
/// `option`.
SocketAddress parseSocketAddress(const std::string& option, const std::string& text);

}  // namespace seaway::bridge
