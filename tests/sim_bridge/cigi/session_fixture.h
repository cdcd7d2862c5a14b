#pragma once

#include <gtest/gtest.h>

#include "sim_bridge/cigi/session.h"
#include "tests/sim_bridge/cigi/known_water.h"
#include "tests/sim_bridge/cigi/random_packets.h"

namespace seaway::bridge::cigi::test {

/// A session on KnownWater, and what it sent last.
class SessionTest : public ::testing::Test {
 protected:
  static SessionOptions synchronous() {
    SessionOptions options;
    options.waterLevel = 10.0;
    return options;
  }
  static SessionOptions asynchronous() {
    SessionOptions options = synchronous();
    options.pacing = Pacing::asynchronous;
    return options;
  }

  void make(SessionOptions options) {
    options.warn = [this](const std::string& what) { warnings.push_back(what); };
    session = std::make_unique<CigiSession>(options, water, counts);
  }

  void keep(CigiSession::Output out) {
    sent.clear();
    for (std::size_t i = 0; i < out.size(); ++i) sent.emplace_back(out[i].begin(), out[i].end());
  }
  void give(std::uint32_t hostFrame, std::vector<Packet> packets, double now = 0.0,
            Dialect dialect = {}) {
    packets.insert(packets.begin(), at(hostFrame, hostTime));
    keep(session->receive(datagramOf(dialect, packets), now));
  }
  void tick(double now = 0.0) { keep(session->tick(now)); }

  /// IG Control of a frame at a host's time in s.
  static IgControl at(std::uint32_t hostFrame, double time) {
    return {.mode = 1,
            .timestampValid = true,
            .hostFrame = hostFrame,
            .timestamp = static_cast<std::uint32_t>(std::llround(time * 1e5))};
  }

  /// All packets of a kind that were sent last.
  template <class P>
  std::vector<P> answers() const {
    std::vector<P> all;
    for (const auto& datagram : sent) {
      for (const P& packet : packetsOf<P>(datagram)) all.push_back(packet);
    }
    return all;
  }
  StartOfFrame start() const {
    const auto starts = answers<StartOfFrame>();
    EXPECT_FALSE(starts.empty());
    return starts.empty() ? StartOfFrame{} : starts.front();
  }

  KnownWater water;
  Counts counts;
  std::unique_ptr<CigiSession> session;
  std::vector<std::vector<std::byte>> sent;
  std::vector<std::string> warnings;
  double hostTime = 4.0;  ///< s, of what is given
};

}  // namespace seaway::bridge::cigi::test
