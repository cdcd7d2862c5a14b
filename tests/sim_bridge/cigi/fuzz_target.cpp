#include "tests/sim_bridge/cigi/fuzz_target.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "sim_bridge/cigi/session.h"
#include "tests/sim_bridge/cigi/known_water.h"

namespace {

using namespace seaway::bridge::cigi;

/// All that leaves a session is messages that begin with a Start of Frame and fit their datagram.
void require(CigiSession::Output out) {
  for (std::size_t i = 0; i < out.size(); ++i) {
    std::optional<Message> message;
    if (readMessage(out[i], message) != Fault::none || out[i].size() > 1472) std::abort();
    for (const Message::View view : *message) {
      Packet packet;
      if (decode(message->dialect(), view, packet) != Decoded::known) std::abort();
    }
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  test::KnownWater water;
  Counts counts;
  SessionOptions options;
  options.pacing = data[0] % 2 == 0 ? Pacing::synchronous : Pacing::asynchronous;
  options.mostRequests = 64;
  CigiSession session(options, water, counts);
  std::size_t at = 1;
  while (at + 2 <= size) {
    const std::size_t length = std::min<std::size_t>(
        data[at] | static_cast<std::size_t>(data[at + 1]) << 8, size - at - 2);
    at += 2;
    // On the heap and of its own size, so that a read beyond it is seen.
    std::vector<std::byte> datagram(length);
    std::transform(data + at, data + at + length, datagram.begin(),
                   [](std::uint8_t byte) { return std::byte{byte}; });
    datagram.shrink_to_fit();
    at += length;
    require(session.receive(datagram, 1.0));
    require(session.tick(2.0));
  }
  return 0;
}
