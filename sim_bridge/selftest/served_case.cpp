#include "sim_bridge/selftest/served_case.h"

#include <arpa/inet.h>
#include <httplib.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <nlohmann/json.hpp>
#include <optional>

namespace seaway::bridge {
namespace {

/// The port that follows "WORD127.0.0.1:".
std::optional<int> portAfter(const std::string& err, const std::string& word) {
  const std::string before = word + "127.0.0.1:";
  const std::size_t at = err.find(before);
  if (at == err.npos) return std::nullopt;
  return std::atoi(err.c_str() + at + before.size());
}

int countOf(const std::string& text, const std::string& word) {
  int count = 0;
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) ++count;
  return count;
}

void sendNonsense(int port) {
  const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (socket < 0) return;
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(static_cast<std::uint16_t>(port));
  to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const std::array<unsigned char, 24> nonsense{1, 24, 3, 255, 128, 0, 17};
  // Lost or not, the service goes on.
  static_cast<void>(sendto(socket, nonsense.data(), nonsense.size(), 0,
                           reinterpret_cast<const sockaddr*>(&to), sizeof(to)));
  close(socket);
}

void askOverHttp(int port, std::string& fault) {
  httplib::Client client("127.0.0.1", port);
  client.set_read_timeout(20, 0);
  const auto status = client.Get("/status.json");
  if (!status || status->status != 200) {
    fault = "/status.json is not answered";
  } else if (!nlohmann::json::accept(status->body)) {
    fault = "/status.json is no JSON";
  }
  const auto figures = client.Get("/metrics");
  if (!figures || figures->status != 200) fault = "/metrics is not answered";
}

}  // namespace

bool askService(const std::string& err, int endpoints, std::string& fault) {
  if (countOf(err, " serves ") < endpoints) return false;
  if (const auto port = portAfter(err, "udp ")) sendNonsense(*port);
  if (const auto port = portAfter(err, "http://")) {
    askOverHttp(*port, fault);
  } else {
    fault = "it does not say where it serves";
  }
  return true;
}

}  // namespace seaway::bridge
