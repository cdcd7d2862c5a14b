#pragma once

#include <grpcpp/generic/async_generic_service.h>

#include "sim_bridge/grpc/rpc_method.h"

namespace seaway::bridge::rpc {

/// Refuses and counts the calls of methods that no service of a server has. Without it gRPC refuses
/// them by itself, and nobody hears of it.
class UnknownMethod : public Method {
 public:
  explicit UnknownMethod(CallHost& host) : host_(host) {}
  /// To be registered with the server.
  grpc::AsyncGenericService& service() { return service_; }
  void listen(grpc::ServerCompletionQueue* queue) override;

 private:
  class Call;
  CallHost& host_;
  grpc::AsyncGenericService service_;
};

}  // namespace seaway::bridge::rpc
