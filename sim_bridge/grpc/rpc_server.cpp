#include "sim_bridge/grpc/rpc_server.h"

#include <absl/synchronization/mutex.h>
#include <grpc/support/log.h>
#include <grpcpp/server_builder.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cstdlib>

#include "sim_bridge/grpc/address_fault.h"
#include "sim_bridge/grpc/standard_services.h"
#include "sim_bridge/grpc/unknown_method.h"
#include "surface/input_error.h"

namespace seaway::bridge::rpc {
namespace {

using std::chrono::milliseconds;

/// gRPC's own messages go where ours go, and only where somebody looks for faults.
void logToOurs(gpr_log_func_args* entry) { spdlog::debug("gRPC: {}", entry->message); }

int millisecondsOf(double seconds) { return static_cast<int>(1000.0 * seconds); }

void setTransport(grpc::ServerBuilder& builder, const RpcServerOptions& options) {
  // Two servers on one port would share its hosts between them.
  builder.AddChannelArgument(GRPC_ARG_ALLOW_REUSEPORT, 0);
  // A window that lets a large batch through at once, in place of probes for the best one, which
  // cost 10 % of a small batch.
  builder.AddChannelArgument(GRPC_ARG_HTTP2_BDP_PROBE, 0);
  builder.AddChannelArgument(GRPC_ARG_HTTP2_STREAM_LOOKAHEAD_BYTES, 1 << 20);
  // Half-open connections: a host that does not answer pings is gone.
  builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_TIME_MS, millisecondsOf(options.patience));
  builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_TIMEOUT_MS, millisecondsOf(options.patience));
  builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_PERMIT_WITHOUT_CALLS, 1);
  builder.AddChannelArgument(GRPC_ARG_HTTP2_MAX_PINGS_WITHOUT_DATA, 0);
  builder.AddChannelArgument(GRPC_ARG_HTTP2_MIN_RECV_PING_INTERVAL_WITHOUT_DATA_MS, 1000);
  // What is too long is refused, and counted, by us: gRPC's own limit has the whole message in
  // memory too before it looks (1.51: 600 MB sent against a limit of 128 MiB, 620 MB more in use),
  // and says nothing of it to a service.
  builder.SetMaxReceiveMessageSize(-1);
  // A small message may unpack to any length before anybody can look at it.
  builder.SetCompressionAlgorithmSupportStatus(GRPC_COMPRESS_DEFLATE, false);
  builder.SetCompressionAlgorithmSupportStatus(GRPC_COMPRESS_GZIP, false);
  builder.AddChannelArgument(GRPC_ARG_MAX_CONCURRENT_STREAMS, 256);
  builder.SetMaxSendMessageSize(-1);
}

}  // namespace

void prepareRpcProcess() {
  // Debian builds Abseil with its checks for deadlocks, which look at each of gRPC's locks.
  absl::SetMutexDeadlockDetectionMode(absl::OnDeadlockCycle::kIgnore);
  gpr_set_log_function(logToOurs);
  // The default strategy lets one thread wait for all connections and hand what comes to the
  // others; with this one each thread waits for its own.
  setenv("GRPC_POLL_STRATEGY", "poll", 0);
}

RpcServer::RpcServer(RpcServerOptions options, Meter& meter)
    : options_(std::move(options)),
      host_(meter, options_.token, static_cast<std::size_t>(options_.mostMessageBytes)) {}

RpcServer::~RpcServer() { stop(); }

void RpcServer::add(std::unique_ptr<grpc::Service> service, std::string name) {
  services_.push_back(std::move(service));
  names_.push_back(std::move(name));
}

void RpcServer::bind() {
  addHealthService(*this);
  addReflectionService(*this);
  requireFreeAddress(options_.option, options_.address);
  grpc::ServerBuilder builder;
  setTransport(builder, options_);
  int port = 0;
  builder.AddListeningPort(options_.address, options_.credentials, &port);
  for (const auto& service : services_) builder.RegisterService(service.get());
  auto unknown = std::make_unique<UnknownMethod>(host_);
  builder.RegisterAsyncGenericService(&unknown->service());
  add(std::move(unknown));
  for (int i = 0; i < std::max(2, coreCount()); ++i) {
    queues_.push_back(builder.AddCompletionQueue());
  }
  server_ = builder.BuildAndStart();
  if (!server_ || port == 0) {
    server_.reset();
    for (const auto& queue : queues_) {
      queue->Shutdown();
      void* tag = nullptr;
      bool ok = false;
      while (queue->Next(&tag, &ok)) {
      }
    }
    queues_.clear();
    throw InputError(options_.option + ": cannot serve at '" + options_.address +
                     "': the address cannot be taken, or the certificate and key are no pair");
  }
  address_ = boundAddress(options_.address, port);
}

void RpcServer::start() {
  for (const auto& queue : queues_) {
    for (const auto& method : methods_) {
      for (int i = 0; i < options_.callsListenedFor; ++i) method->listen(queue.get());
    }
  }
  for (const auto& queue : queues_) {
    threads_.emplace_back([this, &queue = *queue] { serve(queue); });
  }
}

void RpcServer::serve(grpc::ServerCompletionQueue& queue) {
  using Clock = std::chrono::steady_clock;
  const std::chrono::duration<double> spin(coreCount() > 1 ? options_.spin : 0.0);
  auto heard = Clock::now();
  void* tag = nullptr;
  bool ok = false;
  while (true) {
    const auto found = queue.AsyncNext(&tag, &ok, gpr_time_0(GPR_CLOCK_MONOTONIC));
    if (found == grpc::CompletionQueue::SHUTDOWN) return;
    if (found == grpc::CompletionQueue::TIMEOUT) {
      if (Clock::now() - heard < spin) continue;
      if (!queue.Next(&tag, &ok)) return;
    }
    static_cast<Arrival*>(tag)->arrived(ok);
    heard = Clock::now();
  }
}

void RpcServer::stop() {
  if (!server_) return;
  host_.ending = true;
  server_->Shutdown(std::chrono::system_clock::now() + milliseconds(500));
  if (!threads_.empty()) host_.waitForSlots();
  for (const auto& queue : queues_) {
    queue->Shutdown();
    if (threads_.empty()) serve(*queue);
  }
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
  server_.reset();
  queues_.clear();
}

}  // namespace seaway::bridge::rpc
