#pragma once

#include <grpcpp/impl/service_type.h>
#include <grpcpp/security/server_credentials.h>
#include <grpcpp/server.h>

#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "sim_bridge/grpc/rpc_method.h"

namespace seaway::bridge::rpc {

struct RpcServerOptions {
  std::string option;   ///< what messages about the address begin with, such as `--grpc`
  std::string address;  ///< HOST:PORT, [IPV6]:PORT or unix:PATH; port 0: any that is free
  std::shared_ptr<grpc::ServerCredentials> credentials;
  std::string token;  ///< that calls must carry; empty: none
  /// Of one message from a host. Longer ones are refused with RESOURCE_EXHAUSTED when they are
  /// there: gRPC's own limit has all of a message in memory too before it looks, and what that
  /// refuses no service hears of and counts.
  int mostMessageBytes = 64 << 20;
  /// How long a thread looks for more after an event before it sleeps, s: waking takes longer than
  /// a small batch. Not on a machine with one core.
  double spin = 50e-6;
  /// A host that does not answer for so long, s, is gone, and twice that where it is silent.
  double patience = 10.0;
  /// Of each method, by each thread. A call beyond them goes to another thread, which from then on
  /// wakes for whatever comes on that connection: more than hosts of a thread that call at once.
  int callsListenedFor = 32;
};

/// What holds for all servers of a process: to be called once, before it has other threads and
/// before anything of gRPC is made. Leaves GRPC_POLL_STRATEGY alone where it is set.
void prepareRpcProcess();

/// A gRPC server: services with asynchronous methods, answered by a thread a core, each with a
/// queue and connections of its own, which hand what takes long to Lanes; health checking and
/// reflection beside them, which need no token.
///
/// Make it, add services and their methods, `bind`, `start`, `stop`.
class RpcServer {
 public:
  RpcServer(RpcServerOptions options, Meter& meter);
  ~RpcServer();

  CallHost& host() { return host_; }
  void add(std::unique_ptr<grpc::Service> service, std::string name);
  void add(std::unique_ptr<Method> method) { methods_.push_back(std::move(method)); }
  const std::vector<std::string>& serviceNames() const { return names_; }

  /// Takes the address. Throws InputError where it cannot be had.
  void bind();
  /// HOST:PORT with the port it has, or unix:PATH.
  const std::string& address() const { return address_; }

  void start();
  /// Answers what has arrived; streams end after the answer they are at, what then still runs after
  /// half a second is cancelled. Again: nothing.
  void stop();

 private:
  void serve(grpc::ServerCompletionQueue& queue);

  RpcServerOptions options_;
  CallHost host_;
  std::vector<std::unique_ptr<grpc::Service>> services_;
  std::vector<std::string> names_;
  std::vector<std::unique_ptr<Method>> methods_;
  std::vector<std::unique_ptr<grpc::ServerCompletionQueue>> queues_;  // one a thread
  std::unique_ptr<grpc::Server> server_;
  std::string address_;
  std::vector<std::thread> threads_;
};

}  // namespace seaway::bridge::rpc
