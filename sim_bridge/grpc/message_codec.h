#pragma once

#include <google/protobuf/message.h>
#include <grpcpp/impl/codegen/proto_utils.h>
#include <grpcpp/support/byte_buffer.h>

namespace seaway::bridge::rpc {

/// Reads a message into `target`, whose memory is used again; false where it is malformed.
/// Empties `bytes`.
template <class Message>
bool readMessage(grpc::ByteBuffer& bytes, Message& target) {
  const bool read = grpc::SerializationTraits<Message>::Deserialize(&bytes, &target).ok();
  bytes.Clear();
  return read;
}

template <class Message>
void writeMessage(const Message& message, grpc::ByteBuffer& bytes) {
  bool owned = false;
  bytes.Clear();
  grpc::SerializationTraits<Message>::Serialize(message, &bytes, &owned);
}

}  // namespace seaway::bridge::rpc
