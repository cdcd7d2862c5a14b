#pragma once

#include <grpcpp/grpcpp.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "seaway/v1/water.grpc.pb.h"

// The hosts of grpc_bench, in a process of their own that obeys orders.
namespace seaway::bench {

using Clock = std::chrono::steady_clock;

constexpr std::size_t points = 1000;
[[noreturn]] inline void fail(const char* what) {
  std::fprintf(stderr, "%s\n", what);
  std::_Exit(1);
}

inline double secondsSince(Clock::time_point begun) {
  return std::chrono::duration<double>(Clock::now() - begun).count();
}

inline v1::SampleRequest request(bool all, std::size_t count = points) {
  v1::SampleRequest made;
  for (std::size_t i = 0; i < count; ++i) {
    made.mutable_plane()->add_x_m(6000.0 + 0.5 * static_cast<double>(i));
    made.mutable_plane()->add_y_m(2400.0);
  }
  made.set_time_s(0.0);
  made.add_quantities(v1::QUANTITY_HEIGHT);
  if (!all) return made;
  made.add_quantities(v1::QUANTITY_SLOPE);
  made.add_quantities(v1::QUANTITY_VERTICAL_VELOCITY);
  return made;
}

inline std::unique_ptr<v1::Water::Stub> stubOf(const std::string& address) {
  grpc::ChannelArguments arguments;
  arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
  return v1::Water::NewStub(
      grpc::CreateCustomChannel(address, grpc::InsecureChannelCredentials(), arguments));
}

/// One host that asks by itself or on a stream.
class Host {
 public:
  Host(const std::string& address, bool streaming) : stub_(stubOf(address)) {
    if (streaming) stream_ = stub_->SampleStream(&context_);
  }
  ~Host() {
    if (!stream_) return;
    context_.TryCancel();
    stream_->Finish();
  }
  /// On a stream: so many requests are under way before the first answer is waited for.
  void askAhead(const v1::SampleRequest& asked, int count) {
    for (int i = 0; stream_ && i < count; ++i) {
      if (!stream_->Write(asked)) fail("a stream ended");
    }
  }
  void ask(const v1::SampleRequest& asked) {
    if (stream_) {
      if (!stream_->Write(asked) || !stream_->Read(&response_)) {
        fail(stream_->Finish().error_message().c_str());
      }
      return;
    }
    // One queue for all calls: the blocking call makes one each time.
    grpc::ClientContext context;
    const auto call = stub_->AsyncSample(&context, asked, &queue_);
    grpc::Status status;
    call->Finish(&response_, &status, this);
    void* tag = nullptr;
    bool ok = false;
    if (!queue_.Next(&tag, &ok) || !status.ok()) fail(status.error_message().c_str());
  }

 private:
  std::unique_ptr<v1::Water::Stub> stub_;
  grpc::CompletionQueue queue_;
  grpc::ClientContext context_;
  std::unique_ptr<grpc::ClientReaderWriter<v1::SampleRequest, v1::SampleResponse>> stream_;
  v1::SampleResponse response_;
};

/// Runs `work` on so many threads for a while; times that it was done, a second.
inline double rateOf(int threads, double seconds,
                     const std::function<void(std::atomic<bool>&, std::atomic<long>&)>& work) {
  std::atomic<bool> ending{false};
  std::atomic<long> done{0};
  std::vector<std::thread> all;
  for (int i = 0; i < threads; ++i) all.emplace_back([&] { work(ending, done); });
  std::this_thread::sleep_for(std::chrono::duration<double>(0.2 * seconds));
  const long before = done;
  const auto begun = Clock::now();
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  const double rate = static_cast<double>(done - before) / secondsSince(begun);
  ending = true;
  for (std::thread& thread : all) thread.join();
  return rate;
}

/// What the hosts' process is asked to do.
struct Order {
  char address[128] = {};
  int clients = 1;
  int calls = 0;  // of one host, each timed; 0: as many as go in `seconds`
  double seconds = 0.0;
  int ahead = 0;  // of each host on a stream
  bool streaming = false, all = false;
  std::size_t count = points;
};

template <class Values>
void sendAll(int to, const Values* values, std::size_t count) {
  const char* bytes = reinterpret_cast<const char*>(values);
  for (std::size_t left = sizeof(Values) * count; left > 0;) {
    const ssize_t sent = write(to, bytes, left);
    if (sent <= 0) std::_Exit(1);
    bytes += sent;
    left -= static_cast<std::size_t>(sent);
  }
}

template <class Values>
bool receiveAll(int from, Values* values, std::size_t count) {
  char* bytes = reinterpret_cast<char*>(values);
  for (std::size_t left = sizeof(Values) * count; left > 0;) {
    const ssize_t got = read(from, bytes, left);
    if (got <= 0) return false;
    bytes += got;
    left -= static_cast<std::size_t>(got);
  }
  return true;
}

/// The hosts' process: obeys until the pipe is closed; answers with times in us, or a rate.
inline void serveAsHosts(int in, int out) {
  std::map<std::string, std::unique_ptr<Host>> hosts;  // those whose calls are timed
  for (Order order; receiveAll(in, &order, 1);) {
    v1::SampleRequest asked = request(order.all, order.count);
    if (order.calls > 0) {
      std::unique_ptr<Host>& host = hosts[order.address + std::to_string(order.streaming)];
      if (!host) host = std::make_unique<Host>(order.address, order.streaming);
      std::vector<double> us;
      for (int i = 0; i < order.calls; ++i) {
        asked.set_time_s(0.01 * i);
        const auto begun = Clock::now();
        host->ask(asked);
        us.push_back(1e6 * secondsSince(begun));
      }
      sendAll(out, us.data(), us.size());
      continue;
    }
    hosts.clear();
    const double rate = rateOf(order.clients, order.seconds, [&](auto& ending, auto& done) {
      Host host(order.address, order.streaming);
      host.askAhead(asked, order.ahead);
      while (!ending) {
        host.ask(asked);
        ++done;
      }
    });
    sendAll(out, &rate, 1);
  }
}

/// The other end of it.
struct Hosts {
  int in, out;

  std::vector<double> timed(const std::string& address, bool streaming, bool all, std::size_t count,
                            int calls) {
    Order order{.calls = calls, .streaming = streaming, .all = all, .count = count};
    std::snprintf(order.address, sizeof order.address, "%s", address.c_str());
    sendAll(out, &order, 1);
    std::vector<double> us(static_cast<std::size_t>(calls));
    if (!receiveAll(in, us.data(), us.size())) fail("no hosts");
    return us;
  }
  double rate(const std::string& address, bool streaming, int clients, int ahead, double seconds) {
    Order order{.clients = clients, .seconds = seconds, .ahead = ahead, .streaming = streaming};
    std::snprintf(order.address, sizeof order.address, "%s", address.c_str());
    sendAll(out, &order, 1);
    double rate = 0.0;
    if (!receiveAll(in, &rate, 1)) fail("no hosts");
    return rate;
  }
};

}  // namespace seaway::bench
