#include "sim_bridge/service/socket_address.h"

#include <charconv>

#include "surface/input_error.h"

namespace seaway::bridge {

std::string SocketAddress::text() const {
  const bool bracketed = host.find(':') != std::string::npos;
  return (bracketed ? "[" + host + "]" : host) + ":" + std::to_string(port);
}

SocketAddress parseSocketAddress(const std::string& option, const std::string& text) {
  const auto refuse = [&](const std::string& why) {
    throw InputError(option + ": '" + text + "' is not allowed; " + why);
  };
  const std::size_t colon = text.rfind(':');
  std::string host = "127.0.0.1";
  if (colon != std::string::npos) {
    host = text.substr(0, colon);
    if (host.size() > 2 && host.front() == '[' && host.back() == ']') {
      host = host.substr(1, host.size() - 2);
    } else if (host.empty() || host.find_first_of(":[]") != std::string::npos) {
      refuse("must be PORT, HOST:PORT or [IPV6]:PORT");
    }
  }
  const std::size_t from = colon == std::string::npos ? 0 : colon + 1;
  const char* begin = text.data() + from;
  const char* end = text.data() + text.size();
  std::uint16_t port = 0;
  const auto read = std::from_chars(begin, end, port);
  if (read.ec != std::errc{} || read.ptr != end) {
    refuse("the port must be a whole number in [0, 65535]");
  }
  return {host, port};
}

}  // namespace seaway::bridge
