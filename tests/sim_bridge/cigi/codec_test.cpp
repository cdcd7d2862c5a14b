#include "sim_bridge/cigi/codec.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "tests/sim_bridge/cigi/random_packets.h"

namespace seaway::bridge::cigi {
namespace {

using test::allDialects;
using test::datagramOf;
using test::forEachKind;
using test::headOf;
using test::randomPacket;
using test::sameValues;

TEST(CigiCodec, EveryPacketOfBothVersionsComesBackFromBothByteOrders) {
  std::mt19937 random(3304);
  for (const Dialect dialect : allDialects) {
    forEachKind([&]<class P>(P) {
      const bool exists = headOf<P>(dialect.version).size > 0;
      for (int i = 0; i < 20; ++i) {
        const P sent = randomPacket<P>(dialect.version, random);
        const auto packets =
            test::packetsOf(datagramOf(dialect, {IgControl{}, sent, StartOfFrame{}}));
        ASSERT_EQ(packets.size(), exists ? 3u : 2u) << Layout<P>::name;
        if (!exists) continue;
        ASSERT_TRUE(std::holds_alternative<P>(packets[1])) << Layout<P>::name;
        EXPECT_TRUE(sameValues(std::get<P>(packets[1]), sent)) << Layout<P>::name;
      }
    });
  }
}

TEST(CigiCodec, ByteOrdersDifferInWordsAloneAndAreTold) {
  std::mt19937 random(12);
  for (const Version version : {Version::v33, Version::v40}) {
    const Packet packet = randomPacket<HatHotRequest>(version, random);
    for (const ByteOrder order : {ByteOrder::littleEndian, ByteOrder::bigEndian}) {
      const auto datagram = datagramOf({version, order}, {IgControl{}, packet});
      std::optional<Message> message;
      ASSERT_EQ(readMessage(datagram, message), Fault::none);
      EXPECT_EQ(message->dialect(), (Dialect{version, order}));
    }
  }
}

// The tables are checked at compile time for values beyond their packet; here for two values on the
// same bits.
template <class P>
void expectNoOverlap(Version version) {
  std::set<int> taken;
  for (const Field<P>& field : Layout<P>::fields) {
    const Spot spot = version == Version::v33 ? field.v33 : field.v40;
    if (spot.offset < 0) continue;
    const std::size_t size = std::visit(
        []<class M>(const M& member) -> std::size_t {
          if constexpr (std::is_member_object_pointer_v<M>) {
            return sizeof(P{}.*member);
          } else {
            return sizeof(member.v33);
          }
        },
        field.member);
    const int first = 8 * spot.offset + spot.shift;
    const int count = spot.bits > 0 ? spot.bits : static_cast<int>(8 * size);
    for (int bit = first; bit < first + count; ++bit) {
      EXPECT_TRUE(taken.insert(bit).second) << Layout<P>::name << " " << field.name;
    }
    const int header = version == Version::v33 ? 2 : 4;
    EXPECT_GE(spot.offset, header) << Layout<P>::name << " " << field.name;
  }
}

TEST(CigiCodec, NoTwoValuesOfAPacketShareABitNorTouchItsHeader) {
  forEachKind([]<class P>(P) {
    expectNoOverlap<P>(Version::v33);
    expectNoOverlap<P>(Version::v40);
  });
}

TEST(CigiCodec, NoTwoPacketsShareAnIdentifier) {
  for (const Version version : {Version::v33, Version::v40}) {
    std::set<int> ids;
    forEachKind([&]<class P>(P) {
      const Head head = headOf<P>(version);
      if (head.size > 0) {
        EXPECT_TRUE(ids.insert(head.id).second) << Layout<P>::name;
      }
    });
  }
}

TEST(CigiCodec, EveryLengthAngleAndVelocityHasAUnit) {
  forEachKind([]<class P>(P) {
    for (const Field<P>& field : Layout<P>::fields) {
      const bool real = std::holds_alternative<float P::*>(field.member) ||
                        std::holds_alternative<double P::*>(field.member);
      if (real) {
        EXPECT_STRNE(field.unit, "") << Layout<P>::name << " " << field.name;
      }
    }
  });
}

TEST(CigiCodec, UnknownPacketsArePassedOverByTheirSize) {
  for (const Dialect dialect : allDialects) {
    auto datagram = datagramOf(dialect, {IgControl{}, HatHotRequest{.request = 7}});
    const auto last = datagramOf(dialect, {HatHotRequest{.request = 8}});
    std::vector<std::byte> unknown(16, std::byte{0xAB});
    const bool swap = dialect.order == ByteOrder::bigEndian;
    if (dialect.version == Version::v33) {
      unknown[0] = std::byte{250};
      unknown[1] = std::byte{16};
    } else {
      unknown[swap ? 1 : 0] = std::byte{16};
      unknown[swap ? 0 : 1] = std::byte{0};
      unknown[2] = unknown[3] = std::byte{0x22};
    }
    datagram.insert(datagram.end(), unknown.begin(), unknown.end());
    datagram.insert(datagram.end(), last.begin(), last.end());
    const auto requests = test::packetsOf<HatHotRequest>(datagram);
    ASSERT_EQ(requests.size(), 2u);
    EXPECT_EQ(requests[1].request, 8);
  }
}

TEST(CigiCodec, APacketOfAnotherSizeThanItsVersionsIsNotRead) {
  const Dialect dialect;
  auto datagram = datagramOf(dialect, {IgControl{}, HatHotRequest{}});
  datagram[24 + 1] = std::byte{40};
  datagram.resize(24 + 40);
  std::optional<Message> message;
  ASSERT_EQ(readMessage(datagram, message), Fault::none);
  auto packet = message->begin();
  ++packet;
  Packet read;
  EXPECT_EQ(decode(dialect, *packet, read), Decoded::wrongSize);
}

TEST(CigiCodec, NothingIsWrittenWhereThereIsNoRoomOrNoSuchPacket) {
  std::vector<std::byte> room(31, std::byte{0x55});
  EXPECT_EQ(encode({}, HatHotRequest{}, room), 0u);
  EXPECT_EQ(encode({}, EntityPosition{}, room), 0u);
  for (const std::byte byte : room) EXPECT_EQ(byte, std::byte{0x55});
}

Fault faultOf(std::vector<std::byte> datagram) {
  std::optional<Message> message;
  const Fault fault = readMessage(datagram, message);
  EXPECT_EQ(message.has_value(), fault == Fault::none);
  return fault;
}

TEST(CigiCodec, EachFaultOfADatagramIsToldApart) {
  const auto sound = datagramOf({}, {IgControl{}, HatHotRequest{}});
  EXPECT_EQ(faultOf(sound), Fault::none);
  EXPECT_EQ(faultOf({sound.begin(), sound.begin() + 23}), Fault::tooShort);
  EXPECT_EQ(faultOf({}), Fault::tooShort);

  const auto with = [&](std::size_t at, int value) {
    auto changed = sound;
    changed[at] = static_cast<std::byte>(value);
    return faultOf(changed);
  };
  EXPECT_EQ(with(2, 2), Fault::unknownVersion);
  EXPECT_EQ(with(7, 0), Fault::unknownVersion);  // neither 0x8000 nor 0x0080
  EXPECT_EQ(with(0, 24), Fault::noFirstPacket);
  EXPECT_EQ(with(1, 16), Fault::noFirstPacket);  // of 3.0 and 3.1
  EXPECT_EQ(with(24 + 1, 0), Fault::zeroSize);
  EXPECT_EQ(with(24 + 1, 20), Fault::oddSize);
  EXPECT_EQ(with(24 + 1, 40), Fault::overrun);
  auto longer = sound;
  longer.push_back(std::byte{24});
  EXPECT_EQ(faultOf(longer), Fault::overrun);
}

}  // namespace
}  // namespace seaway::bridge::cigi
