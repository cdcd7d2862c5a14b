#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "sim_bridge/cigi/counts.h"
#include "sim_bridge/cigi/session.h"
#include "sim_bridge/cigi/water.h"
#include "sim_bridge/service/endpoint.h"
#include "sim_bridge/service/socket_address.h"

namespace seaway::bridge::cigi {

/// What became of one datagram.
struct DatagramTally {
  std::uint64_t points = 0;   ///< asked for, and answered
  std::uint64_t dropped = 0;  ///< datagrams that are no message of a host
  std::uint64_t refused = 0;  ///< packets and hosts that are not served
};

struct UdpOptions {
  SocketAddress address{"127.0.0.1", 0};  ///< to bind to
  /// A host that is sent a Start of Frame each period before it has spoken, and how.
  std::optional<SocketAddress> greet;
  Dialect greeting;
  SessionOptions session;
  std::size_t mostHosts = 16;   ///< at a time
  double silentAfter = 10.0;    ///< s without a datagram: then a host is forgotten
  std::function<double()> now;  ///< s since the scene's epoch; of each datagram and tick
  /// Hears of every datagram, and how long it took, s.
  std::function<void(const DatagramTally&, double)> served = [](const DatagramTally&, double) {};
};

/// CIGI over UDP: a session for every address that sends to it, all on one thread that is the only
/// one to call the water. A network that takes no more loses answers, as UDP may, and never blocks
/// the thread.
class UdpEndpoint : public Endpoint {
 public:
  /// Binds. `water` must outlive the endpoint. Throws InputError, with the address and why, where
  /// that cannot be: not resolved, not of this machine, in use, not permitted.
  UdpEndpoint(UdpOptions options, Water& water);
  ~UdpEndpoint() override;

  std::string description() const override;
  void start() override;
  void stop() override;

  /// What it is bound to, with the port that was free where 0 was asked.
  SocketAddress address() const;
  const Counts& counts() const;

 private:
  class Server;
  std::unique_ptr<Server> server_;
};

}  // namespace seaway::bridge::cigi
