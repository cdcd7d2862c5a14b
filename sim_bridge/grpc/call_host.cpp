#include "sim_bridge/grpc/call_host.h"

#include "sim_bridge/grpc/rpc_fault.h"

namespace seaway::bridge::rpc {
namespace {

constexpr const char* scheme = "Bearer ";

/// Takes as long for any wrong text of the right length: nothing can be learnt from it.
bool isSame(const std::string& wanted, const char* text, std::size_t size) {
  if (size != wanted.size()) return false;
  unsigned different = 0;
  for (std::size_t i = 0; i < size; ++i) {
    different |= static_cast<unsigned char>(text[i] ^ wanted[i]);
  }
  return different == 0;
}

}  // namespace

void CallHost::authorise(const grpc::ServerContext& context) const {
  if (token_.empty()) return;
  const std::string wanted = scheme + token_;
  const auto [begin, end] = context.client_metadata().equal_range("authorization");
  for (auto given = begin; given != end; ++given) {
    if (isSame(wanted, given->second.data(), given->second.size())) return;
  }
  throw RpcFault(grpc::StatusCode::UNAUTHENTICATED, Refusal::notAuthorised,
                 "authorization: a token is needed: metadata `authorization: Bearer TOKEN`");
}

void CallHost::slotOpens() {
  const std::lock_guard lock(mutex_);
  ++slots_;
}

void CallHost::slotCloses() {
  // Told under the lock: who waits may do away with this object right afterwards.
  const std::lock_guard lock(mutex_);
  if (--slots_ == 0) none_.notify_all();
}

void CallHost::waitForSlots() {
  std::unique_lock lock(mutex_);
  none_.wait(lock, [&] { return slots_ == 0; });
}

}  // namespace seaway::bridge::rpc
