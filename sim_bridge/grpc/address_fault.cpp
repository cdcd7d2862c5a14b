#include "sim_bridge/grpc/address_fault.h"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/ip/v6_only.hpp>
#include <asio/local/stream_protocol.hpp>

#include "sim_bridge/service/socket_address.h"
#include "surface/input_error.h"

namespace seaway::bridge::rpc {
namespace {

constexpr const char* unixPrefix = "unix:";

bool isUnix(const std::string& address) { return address.starts_with(unixPrefix); }
std::string pathOf(const std::string& address) { return address.substr(5); }

void requireFreePath(const std::string& option, const std::string& path) {
  struct stat what {};
  if (stat(path.c_str(), &what) != 0) return;
  if (!S_ISSOCK(what.st_mode)) {
    throw InputError(option + ": '" + path + "' is there already and is no socket");
  }
  asio::io_context io;
  asio::local::stream_protocol::socket probe(io);
  asio::error_code fault;
  probe.connect(asio::local::stream_protocol::endpoint(path), fault);
  if (!fault) {
    throw InputError(option + ": cannot serve at '" + path + "': another process serves there");
  }
}

}  // namespace

std::string rpcAddress(const std::string& option, const std::string& text) {
  if (!isUnix(text)) return parseSocketAddress(option, text).text();
  const std::size_t longest = sizeof(sockaddr_un::sun_path) - 1;
  const std::string path = pathOf(text);
  if (path.empty() || path.size() > longest) {
    throw InputError(option + ": '" + text + "' is not allowed; the path must have 1 to " +
                     std::to_string(longest) + " characters");
  }
  return text;
}

bool isLocal(const std::string& address) {
  if (isUnix(address)) return true;
  const std::string host = parseSocketAddress("address", address).host;
  asio::error_code fault;
  const auto ip = asio::ip::make_address(host, fault);
  return fault ? host == "localhost" : ip.is_loopback();
}

void requireFreeAddress(const std::string& option, const std::string& address) {
  if (isUnix(address)) return requireFreePath(option, pathOf(address));
  const SocketAddress parsed = parseSocketAddress(option, address);
  try {
    asio::io_context io;
    asio::ip::tcp::resolver resolver(io);
    for (const auto& entry : resolver.resolve(parsed.host, std::to_string(parsed.port))) {
      asio::ip::tcp::acceptor acceptor(io, entry.endpoint().protocol());
      acceptor.set_option(asio::ip::tcp::acceptor::reuse_address(true));
      if (entry.endpoint().protocol() == asio::ip::tcp::v6()) {
        acceptor.set_option(asio::ip::v6_only(true));
      }
      acceptor.bind(entry.endpoint());
      acceptor.listen();
    }
  } catch (const std::system_error& fault) {
    throw InputError(option + ": cannot serve at '" + address + "': " + fault.code().message());
  }
}

std::string boundAddress(const std::string& address, int port) {
  if (isUnix(address)) return address;
  SocketAddress bound = parseSocketAddress("address", address);
  bound.port = static_cast<std::uint16_t>(port);
  return bound.text();
}

}  // namespace seaway::bridge::rpc
