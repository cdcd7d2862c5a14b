#pragma once

#include <grpcpp/support/status.h>

#include <exception>
#include <stdexcept>
#include <string>

#include "sim_bridge/service/meter.h"

namespace seaway::bridge::rpc {

/// Why a call is refused: what its host is told, and how it is counted.
class RpcFault : public std::runtime_error {
 public:
  RpcFault(grpc::StatusCode status, Refusal why, const std::string& message)
      : std::runtime_error(message), code(status), counted(why) {}

  grpc::StatusCode code;
  Refusal counted;
};

/// INVALID_ARGUMENT: `field: value is not allowed; must be …`.
RpcFault badValue(const std::string& field, const std::string& value, const std::string& allowed);
RpcFault badValue(const std::string& field, double value, const std::string& allowed);

/// What an exception is to a host: InputError is INVALID_ARGUMENT, lack of memory
/// RESOURCE_EXHAUSTED, what is not foreseen INTERNAL, with its text logged as well.
RpcFault faultOf(std::exception_ptr thrown);

/// At most so much of a message as a frame of headers carries.
grpc::Status statusOf(const RpcFault& fault);

}  // namespace seaway::bridge::rpc
