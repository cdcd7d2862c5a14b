#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "sim_bridge/cigi/session.h"
#include "tests/sim_bridge/cigi/known_water.h"
#include "tests/sim_bridge/cigi/random_packets.h"

/// Whatever comes in, nothing beyond it is read and the session goes on. The sanitizers' preset
/// runs these too.
namespace seaway::bridge::cigi {
namespace {

using test::allDialects;
using test::datagramOf;
using test::everyKind;

/// A copy on the heap of exactly the datagram's size, so that a read beyond its end is noticed.
class Exact {
 public:
  explicit Exact(Bytes bytes) : size_(bytes.size()), bytes_(new std::byte[bytes.size()]) {
    std::copy(bytes.begin(), bytes.end(), bytes_.get());
  }
  operator Bytes() const { return {bytes_.get(), size_}; }

 private:
  std::size_t size_;
  std::unique_ptr<std::byte[]> bytes_;
};

class DamagedDatagramHard : public ::testing::Test {
 protected:
  void give(Bytes datagram) {
    const Exact exact(datagram);
    session.receive(exact, 0.0);
  }
  /// Whether the session still answers: a request gets its height, after as many frames as it takes
  /// to tell a new host from late datagrams.
  void expectAlive() {
    for (std::uint32_t frame = 0; frame < 10; ++frame) {
      const auto datagram = datagramOf(
          {}, {IgControl{.mode = 1, .hostFrame = frame},
               HatHotRequest{.request = 99, .type = 1, .latitude = 8.0, .longitude = 1.0}});
      const auto& out = session.receive(datagram, 0.0);
      for (std::size_t i = 0; i < out.size(); ++i) {
        for (const auto& answer : test::packetsOf<HatHotResponse>(out[i])) {
          if (answer.request == 99 && answer.valid) return;
        }
      }
    }
    ADD_FAILURE() << "no answer";
  }

  test::KnownWater water;
  Counts counts;
  CigiSession session{{.hostClock = false}, water, counts};
};

TEST_F(DamagedDatagramHard, CutShortAtEveryByteIsWholePacketsOrDropped) {
  std::mt19937 random(1);
  for (const Dialect dialect : allDialects) {
    const auto whole = everyKind(dialect, random);
    for (std::size_t size = 0; size < whole.size(); ++size) {
      const Exact cut(Bytes(whole).first(size));
      std::optional<Message> message;
      const Fault fault = readMessage(cut, message);
      // Packets are whole exactly where one of the uncut datagram's ends.
      std::size_t end = 0;
      readMessage(whole, message);
      bool atEnd = false;
      for (const Message::View view : *message) atEnd |= (end += view.bytes.size()) == size;
      EXPECT_EQ(fault == Fault::none, atEnd) << size;
      give(Bytes(whole).first(size));
    }
  }
  expectAlive();
}

TEST_F(DamagedDatagramHard, EveryBitFlippedIsServedOrDropped) {
  std::mt19937 random(2);
  for (const Dialect dialect : allDialects) {
    auto datagram = everyKind(dialect, random);
    for (std::size_t bit = 0; bit < 8 * datagram.size(); ++bit) {
      const auto mask = static_cast<std::byte>(1u << (bit % 8));
      datagram[bit / 8] ^= mask;
      give(datagram);
      datagram[bit / 8] ^= mask;
    }
  }
  EXPECT_GT(counts[Count::malformed], 0u);
  expectAlive();
}

TEST_F(DamagedDatagramHard, NoiseAndSplicedDatagramsAreServedOrDropped) {
  std::mt19937 random(3);
  for (int round = 0; round < 4000; ++round) {
    auto datagram = everyKind(allDialects[random() % 4], random);
    for (unsigned i = random() % 8; i > 0; --i) {
      datagram[random() % datagram.size()] = static_cast<std::byte>(random());
    }
    const std::size_t from = random() % datagram.size();
    const std::size_t count = std::min<std::size_t>(random() % 64, datagram.size() - from);
    const auto part = std::vector(datagram.begin() + static_cast<std::ptrdiff_t>(from),
                                  datagram.begin() + static_cast<std::ptrdiff_t>(from + count));
    const std::size_t to = random() % (datagram.size() + 1);
    datagram.insert(datagram.begin() + static_cast<std::ptrdiff_t>(to), part.begin(), part.end());
    give(datagram);
    if (round % 7 == 0) session.tick(static_cast<double>(round));
  }
  EXPECT_GT(counts[Count::malformed], 0u);
  EXPECT_GT(counts[Count::heights], 0u);
  expectAlive();
}

TEST_F(DamagedDatagramHard, NumbersThatAreNoneAreAnsweredAsNotValid) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  std::vector<Packet> packets{IgControl{.hostFrame = 5}};
  for (const double bad : {nan, inf, -inf, 1e300}) {
    for (std::uint8_t type = 0; type < 3; ++type) {
      packets.push_back(HatHotRequest{.type = type, .latitude = bad, .longitude = 1.0});
    }
  }
  packets.push_back(HatHotRequest{.type = 0, .latitude = 1, .longitude = 1, .altitude = nan});
  const auto& out = session.receive(datagramOf({}, packets), 0.0);
  std::size_t answers = 0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    for (const auto& answer : test::packetsOf<HatHotResponse>(out[i])) {
      EXPECT_FALSE(answer.valid);
      EXPECT_EQ(answer.height, 0.0);
      ++answers;
    }
    for (const auto& answer : test::packetsOf<HatHotExtendedResponse>(out[i])) {
      EXPECT_FALSE(answer.valid);
      EXPECT_EQ(answer.heightOf, 0.0);
      ++answers;
    }
  }
  EXPECT_EQ(answers, 13u);
  EXPECT_EQ(counts[Count::invalidPoints], 13u);
}

}  // namespace
}  // namespace seaway::bridge::cigi
