#include "tests/sim_bridge/cigi/session_fixture.h"

/// Frames: who sets the pace, what time they are at, and what a network may do to them.
namespace seaway::bridge::cigi {
namespace {

class CigiFrames : public test::SessionTest {
 protected:
  CigiFrames() { make(synchronous()); }
  static HatHotRequest height(std::uint16_t number, std::uint8_t period = 0) {
    return {.request = number, .type = 1, .period = period, .latitude = 8.0, .longitude = 1.0};
  }
};
using CigiFramesHard = CigiFrames;

TEST_F(CigiFrames, EachMessageIsAnsweredInItsOwnVersionAndByteOrder) {
  for (const Dialect dialect : test::allDialects) {
    make(synchronous());
    give(7, {height(1)}, 0.0, dialect);
    ASSERT_EQ(sent.size(), 1u);
    std::optional<Message> message;
    ASSERT_EQ(readMessage(sent[0], message), Fault::none);
    EXPECT_EQ(message->dialect(), dialect);
    EXPECT_EQ(start().lastHostFrame, 7u);
    EXPECT_EQ(start().mode, 1);
    EXPECT_EQ(answers<HatHotResponse>().size(), 1u);
  }
}

TEST_F(CigiFrames, SynchronousFramesCountTheHostsMessagesAndTicksRepeatTheLast) {
  for (std::uint32_t frame = 1; frame <= 3; ++frame) {
    give(frame, {height(1)});
    EXPECT_EQ(start().igFrame, frame);
    tick();
    EXPECT_EQ(start().igFrame, frame);
    EXPECT_EQ(start().lastHostFrame, frame);
    EXPECT_TRUE(answers<HatHotResponse>().empty());
  }
}

TEST_F(CigiFrames, AsynchronousFramesCountTicksAndCarryWhatCameMeanwhile) {
  make(asynchronous());
  tick();
  EXPECT_TRUE(sent.empty());  // nobody to speak to
  give(100, {height(1)});
  EXPECT_TRUE(sent.empty());
  give(101, {height(2)});
  EXPECT_TRUE(sent.empty());
  tick();
  EXPECT_EQ(start().igFrame, 1u);
  EXPECT_EQ(start().lastHostFrame, 101u);
  const auto heights = answers<HatHotResponse>();
  ASSERT_EQ(heights.size(), 2u);
  EXPECT_EQ(heights[0].request, 1);
  EXPECT_EQ(heights[1].request, 2);
  EXPECT_EQ(heights[0].hostFrame, 101u & 0xF);
  tick();
  EXPECT_EQ(start().igFrame, 2u);
  EXPECT_TRUE(answers<HatHotResponse>().empty());
}

TEST_F(CigiFrames, AGreetedHostHearsStartsOfFrameBeforeItSpeaks) {
  make(synchronous());
  session->greet({Version::v40, ByteOrder::littleEndian});
  tick();
  ASSERT_EQ(sent.size(), 1u);
  std::optional<Message> message;
  ASSERT_EQ(readMessage(sent[0], message), Fault::none);
  EXPECT_EQ(message->dialect().version, Version::v40);
}

double heightNow(const std::vector<HatHotResponse>& answers) {
  EXPECT_EQ(answers.size(), 1u);
  return answers.empty() ? 0.0 : answers[0].height;
}

TEST_F(CigiFrames, TimeIsTheHostsTimeStampUnwrappedAfterTwelveHours) {
  const auto giveAt = [&](std::uint32_t frame, std::uint32_t timestamp) {
    const IgControl control{.timestampValid = true, .hostFrame = frame, .timestamp = timestamp};
    keep(session->receive(test::datagramOf({}, {control, height(1)}), 99.0));
    EXPECT_EQ(start().timestamp, timestamp);
  };
  // Half a second before 2³² ticks, and a quarter after.
  giveAt(1, 4294917296u);
  EXPECT_EQ(heightNow(answers<HatHotResponse>()),
            10.0 + test::KnownWater::elevationAt(42949.17296, 8.0, 0.0));
  giveAt(2, 25000u);
  EXPECT_EQ(heightNow(answers<HatHotResponse>()),
            10.0 + test::KnownWater::elevationAt((4294967296.0 + 25000.0) / 1e5, 8.0, 0.0));
}

TEST_F(CigiFrames, TimeMayGoBackwardsAndTheAnswerIsThatTimes) {
  hostTime = 8.0;
  give(1, {height(1)});
  hostTime = 6.0;
  give(2, {height(1)});
  EXPECT_EQ(heightNow(answers<HatHotResponse>()),
            10.0 + test::KnownWater::elevationAt(6.0, 8.0, 0.0));
}

TEST_F(CigiFrames, WithoutTimeStampsFramesAreAPeriodApart) {
  for (const std::uint32_t frame : {5u, 6u, 9u}) {
    keep(session->receive(test::datagramOf({}, {IgControl{.hostFrame = frame}, height(1)}), 77.0));
    EXPECT_DOUBLE_EQ(heightNow(answers<HatHotResponse>()),
                     10.0 + test::KnownWater::elevationAt((frame - 5u) / 60.0, 8.0, 0.0));
  }
}

TEST_F(CigiFrames, WithAClockOfItsOwnTheServersTimeCounts) {
  SessionOptions options = synchronous();
  options.hostClock = false;
  make(options);
  give(1, {height(1)}, 32.0);
  EXPECT_EQ(heightNow(answers<HatHotResponse>()),
            10.0 + test::KnownWater::elevationAt(32.0, 8.0, 0.0));
  EXPECT_EQ(start().timestamp, 3200000u);
}

TEST_F(CigiFramesHard, ADatagramThatComesAgainIsAnsweredAgainWithTheSameBytes) {
  const auto datagram = test::datagramOf({}, {at(3, 1.0), height(1)});
  keep(session->receive(datagram, 0.0));
  const auto first = sent;
  keep(session->receive(datagram, 5.0));
  EXPECT_EQ(sent, first);
  EXPECT_EQ(counts[Count::repeated], 1u);
  EXPECT_EQ(counts[Count::heights], 1u);

  make(asynchronous());
  keep(session->receive(datagram, 0.0));
  keep(session->receive(datagram, 0.0));
  tick();
  EXPECT_EQ(answers<HatHotResponse>().size(), 1u);
}

TEST_F(CigiFramesHard, ALateDatagramChangesNothingAndLostOnesAreCounted) {
  give(10, {MaritimeSurfaceControl{.enabled = true, .height = 20.0f}});
  give(14, {MaritimeSurfaceControl{.enabled = true, .height = 30.0f}});
  EXPECT_EQ(counts[Count::lost], 3u);
  give(12, {MaritimeSurfaceControl{.enabled = true, .height = 40.0f}, height(1)});
  EXPECT_TRUE(sent.empty());
  EXPECT_EQ(counts[Count::late], 1u);
  EXPECT_EQ(session->waterLevel(), 30.0);
  give(15, {});
  EXPECT_EQ(start().lastHostFrame, 15u);
  EXPECT_EQ(counts[Count::lost], 3u);
}

TEST_F(CigiFramesHard, FrameNumbersGoOnThroughZero) {
  give(0xFFFFFFFFu, {});
  give(0u, {height(1)});
  EXPECT_EQ(answers<HatHotResponse>().size(), 1u);
  EXPECT_EQ(counts[Count::late] + counts[Count::lost] + counts[Count::restarts], 0u);
}

TEST_F(CigiFramesHard, AHostThatBeginsAgainIsServedAfterEightFramesAndFindsNothingOfItsOwn) {
  give(5000, {height(1, 1), EntityControl{.entity = 3, .state = 1, .longitude = 1.0}});
  hostTime = 0.0;
  for (std::uint32_t frame = 0; frame < 7; ++frame) give(frame, {});
  EXPECT_EQ(counts[Count::late], 7u);
  EXPECT_TRUE(sent.empty());
  give(7, {height(2)});
  EXPECT_EQ(counts[Count::restarts], 1u);
  ASSERT_EQ(answers<HatHotResponse>().size(), 1u);
  EXPECT_EQ(answers<HatHotResponse>()[0].request, 2);
  EXPECT_EQ(answers<HatHotResponse>()[0].height,
            10.0 + test::KnownWater::elevationAt(0.0, 8.0, 0.0));
  give(8, {HatHotRequest{.request = 4, .type = 1, .entityAxes = true, .entity = 3}});
  ASSERT_EQ(answers<HatHotResponse>().size(), 1u);
  EXPECT_FALSE(answers<HatHotResponse>()[0].valid);
}

TEST_F(CigiFramesHard, AHostThatComesBackInTheOtherVersionIsServed) {
  give(50, {height(1, 1)});
  give(3, {height(2)}, 0.0, {Version::v40, ByteOrder::bigEndian});
  ASSERT_EQ(answers<HatHotResponse>().size(), 1u);
  EXPECT_EQ(answers<HatHotResponse>()[0].request, 2);
}

TEST_F(CigiFrames, ResetForgetsEntitiesAndPeriodicRequests) {
  give(1, {height(1, 1)});
  give(2, {});
  EXPECT_EQ(answers<HatHotResponse>().size(), 1u);
  keep(session->receive(test::datagramOf({}, {IgControl{.mode = 0, .hostFrame = 3}}), 0.0));
  EXPECT_TRUE(answers<HatHotResponse>().empty());
  EXPECT_EQ(start().mode, 0);
}

TEST_F(CigiFramesHard, FaultyDatagramsAreCountedAndTheFirstOfEachKindIsReported) {
  for (int i = 0; i < 5; ++i) {
    const std::vector<std::byte> noise(40, std::byte{0xEE});
    keep(session->receive(noise, 0.0));
    EXPECT_TRUE(sent.empty());
    keep(session->receive(test::datagramOf({}, {StartOfFrame{}}), 0.0));
    EXPECT_TRUE(sent.empty());
  }
  EXPECT_EQ(counts[Count::malformed], 5u);
  EXPECT_EQ(counts[Count::unexpected], 5u);
  EXPECT_EQ(warnings.size(), 2u);
}

TEST_F(CigiFramesHard, AnswersThatDoNotFitGoOnInDatagramsThatBeginAlike) {
  std::vector<Packet> packets;
  for (std::uint16_t i = 0; i < 500; ++i) packets.push_back(height(i));
  give(1, packets);
  std::size_t next = 0;
  EXPECT_EQ(sent.size(), 6u);  // 90 answers of 16 bytes beside 24 bytes in 1472
  for (const auto& datagram : sent) {
    EXPECT_LE(datagram.size(), 1472u);
    const auto all = test::packetsOf(datagram);
    ASSERT_TRUE(std::holds_alternative<StartOfFrame>(all[0]));
    EXPECT_EQ(std::get<StartOfFrame>(all[0]).igFrame, 1u);
    for (std::size_t i = 1; i < all.size(); ++i) {
      EXPECT_EQ(std::get<HatHotResponse>(all[i]).request, next++);
    }
  }
  EXPECT_EQ(next, 500u);
  EXPECT_EQ(water.batches, 1);
}

TEST_F(CigiFramesHard, RequestsBeyondWhatIsKeptAreRefusedAndCounted) {
  SessionOptions options = asynchronous();
  options.mostRequests = 4;
  make(options);
  std::vector<Packet> packets;
  for (std::uint16_t i = 0; i < 10; ++i) {
    packets.push_back(height(i));
    packets.push_back(height(static_cast<std::uint16_t>(100 + i), 1));
    packets.push_back(EnvironmentRequest{.type = 1, .latitude = 1.0, .longitude = 1.0});
  }
  give(1, packets);
  tick();
  EXPECT_EQ(answers<HatHotResponse>().size(), 8u);
  EXPECT_EQ(answers<MaritimeSurfaceResponse>().size(), 4u);
  EXPECT_EQ(counts[Count::refusedRequests], 18u);
}

}  // namespace
}  // namespace seaway::bridge::cigi
