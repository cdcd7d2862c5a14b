#include "sim_bridge/cigi/udp_endpoint.h"

#include <spdlog/spdlog.h>

#include <array>
#include <asio.hpp>
#include <chrono>
#include <exception>
#include <map>
#include <thread>
#include <utility>

#include "surface/input_error.h"

namespace seaway::bridge::cigi {
namespace {

using asio::ip::udp;
using Clock = std::chrono::steady_clock;

/// The longest payload of a UDP datagram fits.
constexpr std::size_t longestDatagram = 65536;

/// How many datagrams that have arrived already are answered after the end was asked for.
constexpr int mostAfterStop = 1024;

udp::endpoint resolved(asio::io_context& context, const SocketAddress& address) {
  udp::resolver resolver(context);
  asio::error_code fault;
  const auto found = resolver.resolve(address.host, std::to_string(address.port), fault);
  if (fault || found.empty()) {
    throw InputError("CIGI: cannot find the address " + address.text() + ": " + fault.message());
  }
  return found.begin()->endpoint();
}

SocketAddress addressOf(const udp::endpoint& endpoint) {
  return {endpoint.address().to_string(), endpoint.port()};
}

udp::socket bound(asio::io_context& context, const SocketAddress& address) {
  const udp::endpoint endpoint = resolved(context, address);
  udp::socket socket(context);
  asio::error_code fault;
  socket.open(endpoint.protocol(), fault);
  if (!fault) socket.bind(endpoint, fault);
  if (!fault) socket.non_blocking(true, fault);
  if (fault) throw InputError("CIGI: cannot bind to " + address.text() + ": " + fault.message());
  return socket;
}

}  // namespace

class UdpEndpoint::Server {
 public:
  Server(UdpOptions options, Water& water)
      : options_(std::move(options)),
        water_(water),
        socket_(bound(context_, options_.address)),
        timer_(context_),
        address_(addressOf(socket_.local_endpoint())) {
    options_.session.warn = [where = address_.text()](const std::string& what) {
      spdlog::warn("CIGI on {}: {}; more of these are counted only", where, what);
    };
    if (options_.greet) {
      Host& greeted = *host(resolved(context_, *options_.greet));
      greeted.session.greet(options_.greeting);
      greeted.greeted = true;
    }
  }
  ~Server() { stop(); }

  void start() {
    receive();
    nextTick_ = Clock::now();
    waitForTick();
    thread_ = std::thread([this] { context_.run(); });
  }

  void stop() {
    if (!thread_.joinable()) return;
    asio::post(context_, [this] {
      stopping_ = true;
      asio::error_code ignored;
      socket_.cancel(ignored);
    });
    thread_.join();
  }

  const SocketAddress& address() const { return address_; }
  const Counts& counts() const { return counts_; }

 private:
  struct Host {
    CigiSession session;
    std::uint32_t number;
    Clock::time_point heard;
    Clock::time_point sent;
    bool greeted = false;
  };

  void receive() {
    socket_.async_receive_from(asio::buffer(buffer_), sender_,
                               [this](const asio::error_code& fault, std::size_t size) {
                                 // What was read before the cancellation is answered too.
                                 if (!fault) serve(size);
                                 stopping_ ? finish() : receive();
                               });
  }

  void finish() {
    answerWhatHasArrived();
    asio::error_code ignored;
    timer_.cancel();
    socket_.close(ignored);
  }

  void answerWhatHasArrived() {
    for (int i = 0; i < mostAfterStop; ++i) {
      asio::error_code fault;
      const std::size_t size = socket_.receive_from(asio::buffer(buffer_), sender_, 0, fault);
      if (fault) return;
      serve(size);
    }
  }

  void serve(std::size_t size) {
    const Clock::time_point begun = Clock::now();
    const DatagramTally before = tally();
    if (Host* from = host(sender_)) {
      from->heard = begun;
      guarded([&] {
        send(*from, sender_, from->session.receive(Bytes(buffer_.data(), size), options_.now()));
      });
    }
    const DatagramTally after = tally();
    options_.served({after.points - before.points, after.dropped - before.dropped,
                     after.refused - before.refused},
                    std::chrono::duration<double>(Clock::now() - begun).count());
  }

  DatagramTally tally() const {
    const auto sum = [&](std::initializer_list<Count> all) {
      std::uint64_t total = 0;
      for (const Count each : all) total += counts_[each];
      return total;
    };
    return {sum({Count::heights, Count::velocities}), sum({Count::malformed, Count::unexpected}),
            sum({Count::wrongSize, Count::unsupported, Count::otherScopes, Count::refusedRequests,
                 Count::refusedHosts})};
  }

  /// The session of an address, made where there is room; null where there is none.
  Host* host(const udp::endpoint& address) {
    const auto found = hosts_.find(address);
    if (found != hosts_.end()) return &found->second;
    if (hosts_.size() >= options_.mostHosts) {
      counts_.add(Count::datagrams);
      if (counts_.add(Count::refusedHosts)) {
        options_.session.warn("a further host is refused: " + std::to_string(hosts_.size()) +
                              " are served");
      }
      return nullptr;
    }
    SessionOptions session = options_.session;
    session.host = ++lastHost_;
    const Clock::time_point now = Clock::now();
    Host made{CigiSession(std::move(session), water_, counts_), lastHost_, now, now};
    return &hosts_.emplace(address, std::move(made)).first->second;
  }

  void forgetSilentHosts() {
    const Clock::time_point now = Clock::now();
    std::erase_if(hosts_, [&](const auto& entry) {
      const Host& host = entry.second;
      const double silence = std::chrono::duration<double>(now - host.heard).count();
      const bool gone = silence > options_.silentAfter && !host.greeted;
      if (gone) water_.hostGone(host.number);
      return gone;
    });
  }

  void send(Host& to, const udp::endpoint& address, CigiSession::Output out) {
    for (std::size_t i = 0; i < out.size(); ++i) {
      asio::error_code fault;
      socket_.send_to(asio::buffer(out[i].data(), out[i].size()), address, 0, fault);
      counts_.add(fault ? Count::unsent : Count::answers);
      to.sent = Clock::now();
    }
  }

  void waitForTick() {
    const auto period = std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(options_.session.framePeriod));
    // After a pause of the machine frames are not made up for.
    nextTick_ = std::max(nextTick_ + period, Clock::now());
    timer_.expires_at(nextTick_);
    timer_.async_wait([this, period](const asio::error_code& fault) {
      if (fault || !socket_.is_open()) return;
      forgetSilentHosts();
      for (auto& [address, to] : hosts_) tick(address, to, period);
      waitForTick();
    });
  }

  void tick(const udp::endpoint& address, Host& to, Clock::duration period) {
    const bool speaking =
        options_.session.pacing == Pacing::synchronous && Clock::now() - to.sent < period;
    if (!speaking) guarded([&] { send(to, address, to.session.tick(options_.now())); });
  }

  template <class Action>
  void guarded(Action action) {
    try {
      action();
    } catch (const std::exception& fault) {
      spdlog::error("CIGI on {}: {}", address_.text(), fault.what());
    }
  }

  UdpOptions options_;
  Water& water_;
  Counts counts_;
  asio::io_context context_;
  udp::socket socket_;
  asio::steady_timer timer_;
  SocketAddress address_;
  std::map<udp::endpoint, Host> hosts_;
  std::uint32_t lastHost_ = 0;
  std::array<std::byte, longestDatagram> buffer_;
  bool stopping_ = false;
  udp::endpoint sender_;
  Clock::time_point nextTick_;
  std::thread thread_;
};

UdpEndpoint::UdpEndpoint(UdpOptions options, Water& water)
    : server_(std::make_unique<Server>(std::move(options), water)) {}
UdpEndpoint::~UdpEndpoint() = default;

std::string UdpEndpoint::description() const {
  return "CIGI 3.3 and 4.0 on udp " + address().text();
}
void UdpEndpoint::start() { server_->start(); }
void UdpEndpoint::stop() { server_->stop(); }
SocketAddress UdpEndpoint::address() const { return server_->address(); }
const Counts& UdpEndpoint::counts() const { return server_->counts(); }

}  // namespace seaway::bridge::cigi
