#include "sim_bridge/grpc/rpc_fault.h"

#include <spdlog/spdlog.h>

#include <new>

#include "sim_bridge/output/number_text.h"
#include "surface/input_error.h"

namespace seaway::bridge::rpc {

RpcFault badValue(const std::string& field, const std::string& value, const std::string& allowed) {
  return {grpc::StatusCode::INVALID_ARGUMENT, Refusal::badValue,
          field + ": " + value + " is not allowed; " + allowed};
}

RpcFault badValue(const std::string& field, double value, const std::string& allowed) {
  return badValue(field, numberText(value), allowed);
}

RpcFault faultOf(std::exception_ptr thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const RpcFault& fault) {
    return fault;
  } catch (const InputError& fault) {
    return {grpc::StatusCode::INVALID_ARGUMENT, Refusal::badValue, fault.what()};
  } catch (const std::bad_alloc&) {
    return {grpc::StatusCode::RESOURCE_EXHAUSTED, Refusal::tooLarge,
            "the service lacks the memory for this request"};
  } catch (const std::exception& fault) {
    spdlog::error("gRPC: a request failed: {}", fault.what());
    return {grpc::StatusCode::INTERNAL, Refusal::failed, fault.what()};
  }
}

grpc::Status statusOf(const RpcFault& fault) {
  constexpr std::size_t longest = 1000;  // of 8 KiB that hosts take as headers by default
  return {fault.code, std::string(fault.what()).substr(0, longest)};
}

}  // namespace seaway::bridge::rpc
