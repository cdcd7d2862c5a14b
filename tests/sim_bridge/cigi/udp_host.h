#pragma once

#include <poll.h>

#include <asio.hpp>
#include <atomic>
#include <deque>
#include <random>
#include <thread>
#include <vector>

#include "sim_bridge/cigi/codec.h"
#include "sim_bridge/service/socket_address.h"

namespace seaway::bridge::cigi::test {

using asio::ip::udp;
using Datagram = std::vector<std::byte>;

inline udp::endpoint endpointOf(const SocketAddress& address) {
  return {asio::ip::make_address(address.host), address.port};
}

/// A socket on the loopback.
class UdpSocket {
 public:
  UdpSocket() : socket_(context_, udp::endpoint(asio::ip::address_v4::loopback(), 0)) {}

  SocketAddress address() const { return {"127.0.0.1", socket_.local_endpoint().port()}; }
  void send(const Datagram& datagram, const SocketAddress& to) {
    socket_.send_to(asio::buffer(datagram), endpointOf(to));
  }
  /// The next datagram; empty where none comes for `ms`.
  Datagram receive(int ms) {
    pollfd waiting{socket_.native_handle(), POLLIN, 0};
    if (poll(&waiting, 1, ms) <= 0) return {};
    Datagram datagram(65536);
    udp::endpoint from;
    asio::error_code fault;
    datagram.resize(socket_.receive_from(asio::buffer(datagram), from, 0, fault));
    from_ = {from.address().to_string(), from.port()};
    return datagram;
  }
  const SocketAddress& from() const { return from_; }

 private:
  asio::io_context context_;
  udp::socket socket_;
  SocketAddress from_;
};

/// Stands between a host and an endpoint and does what networks do: of each ten datagrams it loses
/// one, doubles one and holds one back behind later ones, either way. Which, a seed says.
class BadNetwork {
 public:
  BadNetwork(SocketAddress endpoint, unsigned seed)
      : endpoint_(std::move(endpoint)), random_(seed), thread_([this] { run(); }) {}
  ~BadNetwork() {
    ending_ = true;
    thread_.join();
  }
  SocketAddress address() const { return toHost_.address(); }

 private:
  void run() {
    while (!ending_) {
      if (Datagram up = toHost_.receive(1); !up.empty()) {
        host_ = toHost_.from();
        pass(std::move(up), heldUp_, toEndpoint_, endpoint_);
      }
      while (true) {
        Datagram down = toEndpoint_.receive(0);
        if (down.empty()) break;
        pass(std::move(down), heldDown_, toHost_, host_);
      }
    }
  }
  void pass(Datagram datagram, std::deque<Datagram>& held, UdpSocket& by, const SocketAddress& to) {
    const unsigned fate = random_() % 10;
    if (fate == 0) return;
    if (fate == 1) {
      held.push_back(std::move(datagram));
      return;
    }
    by.send(datagram, to);
    if (fate == 2) by.send(datagram, to);
    if (fate == 3 && !held.empty()) {
      by.send(held.front(), to);
      held.pop_front();
    }
  }

  SocketAddress endpoint_, host_;
  std::mt19937 random_;
  std::deque<Datagram> heldUp_, heldDown_;
  UdpSocket toHost_, toEndpoint_;
  std::atomic<bool> ending_ = false;
  std::thread thread_;
};

}  // namespace seaway::bridge::cigi::test
