#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <cstring>
#include <functional>
#include <thread>

#include "sim_bridge/shm/seaway_shm.hpp"
#include "surface/input_error.h"
#include "tests/sim_bridge/shm/known_sea.h"

namespace seaway::bridge::shm {
namespace {

using seaway::shm::Client;
using test::comesTrue;
using test::knownOptions;
using test::KnownSea;

/// A server on a sea that is known.
class ShmClient : public ::testing::Test {
 protected:
  ShmClient() { endpoint_.start(); }
  seaway::shm::Status statusOf(const std::function<void()>& call) {
    try {
      call();
      return SEAWAY_SHM_OK;
    } catch (const seaway::shm::Error& error) {
      message_ = error.what();
      return error.status();
    }
  }
  KnownSea sea_;
  const std::string name_ = test::uniqueName();
  ShmEndpoint endpoint_{knownOptions(sea_, name_)};
  std::string message_;
};
using ShmClientHard = ShmClient;

std::vector<double> counted(std::size_t n, double scale) {
  std::vector<double> values(n);
  for (std::size_t i = 0; i < n; ++i) values[i] = scale * static_cast<double>(i);
  return values;
}

TEST_F(ShmClient, GetsTheWaterAtItsPointsAndTime) {
  Client client(name_);
  const auto x = counted(1000, 0.5), y = counted(1000, -0.25);
  for (const double t : {0.0, 17.5, -3.0}) {
    const auto got = client.sample(x, y, {.time = t, .tolerance = 0.25, .orbitalVelocity = true});
    EXPECT_EQ(got.time, t);
    for (std::size_t i = 0; i < x.size(); ++i) {
      ASSERT_EQ(got.height[i], KnownSea::heightAt(x[i], y[i], t));
      ASSERT_EQ(got.slopeEast[i], 2.0);
      ASSERT_EQ(got.slopeNorth[i], 3.0);
      ASSERT_EQ(got.verticalVelocity[i], 1.0);
      ASSERT_EQ(got.orbitalUp[i], 0.5);
      ASSERT_EQ(got.error[i], 0.25);
      ASSERT_EQ(got.bound[i], 0.125);
      ASSERT_EQ(got.status[i], 0u);
    }
  }
  EXPECT_EQ(sea_.requests, 3u);
  EXPECT_EQ(sea_.allPoints, 3000u);
}

TEST_F(ShmClient, HasAsManyRequestsUnderWayAsTheRingHasCells) {
  Client client(name_);
  sea_.seconds = 0.01;
  seaway_shm_batch batches[5];
  for (int i = 0; i < 4; ++i) {
    ASSERT_EQ(seaway_shm_begin(&client.c(), SEAWAY_SHM_SAMPLE, &batches[i]), SEAWAY_SHM_OK);
    batches[i].request->time = i;
    batches[i].request->count = 1;
    batches[i].x[0] = batches[i].y[0] = 0.0;
    seaway_shm_submit(&client.c(), &batches[i]);
  }
  EXPECT_EQ(seaway_shm_begin(&client.c(), SEAWAY_SHM_SAMPLE, &batches[4]), SEAWAY_SHM_RING_FULL);
  for (int i = 3; i >= 0; --i) {
    ASSERT_EQ(seaway_shm_wait(&client.c(), &batches[i], 10.0), SEAWAY_SHM_OK);
    EXPECT_EQ(batches[i].height[0], i);
  }
  EXPECT_EQ(seaway_shm_begin(&client.c(), SEAWAY_SHM_SAMPLE, &batches[4]), SEAWAY_SHM_OK);
}

TEST_F(ShmClient, AddsPlacesAndRemovesHullsWhichGoWithTheConnection) {
  {
    Client client(name_);
    const std::uint32_t first = client.addHull(0), second = client.addHull(1);
    EXPECT_EQ(sea_.hullsNow(), (std::set{first, second}));
    seaway::shm::Pose pose{};
    pose.hull = second;
    pose.latitude_deg = 28.5;
    client.placeHulls(2.0, std::span(&pose, 1));
    EXPECT_EQ(sea_.posesNow().at(0).latitude_deg, 28.5);
    client.removeHull(first);
    EXPECT_EQ(sea_.hullsNow(), std::set{second});
    EXPECT_EQ(statusOf([&] { client.removeHull(first); }), SEAWAY_SHM_NOT_FOUND);
    EXPECT_EQ(statusOf([&] { client.addHull(9); }), SEAWAY_SHM_NOT_FOUND);
    EXPECT_NE(message_.find("no vessel 9"), std::string::npos) << message_;
  }
  EXPECT_TRUE(comesTrue([&] { return sea_.hullsNow().empty() && sea_.hosts == 0; }));
}

TEST_F(ShmClient, ReadsTheDescription) {
  Client client(name_);
  EXPECT_EQ(client.describe(), R"({"sea": "known"})");
}

TEST_F(ShmClient, SamplesWhileAPictureIsDrawn) {
  Client client(name_);
  sea_.drawing = 0.3;
  seaway_shm_picture_request asked{};
  asked.width = 40;
  asked.height = 30;
  asked.time = 4.5;
  client.askPicture(asked);
  const std::vector<double> one{1.0};
  for (int i = 0; i < 10; ++i) EXPECT_EQ(client.sample(one, one, {}).height[0], 5.0);
  EXPECT_EQ(sea_.pictures, 0u);
  EXPECT_EQ(statusOf([&] { client.waitPicture(0.001); }), SEAWAY_SHM_TIMEOUT);
  const auto picture = client.waitPicture(20.0);
  ASSERT_EQ(picture.width, 40u);
  ASSERT_EQ(picture.height, 30u);
  EXPECT_EQ(picture.time, 4.5);
  EXPECT_EQ(picture.rgb[3 * (7 * 40 + 9)], 9);
  EXPECT_EQ(picture.rgb[3 * (7 * 40 + 9) + 1], 7);
  EXPECT_EQ(picture.depth[7 * 40 + 9], 289.0f);
}

TEST_F(ShmClient, IsRefusedPicturesThatCannotBe) {
  Client client(name_);
  const auto draw = [&](seaway_shm_picture_request asked) {
    return statusOf([&] {
      client.askPicture(asked);
      client.waitPicture(20.0);
    });
  };
  seaway_shm_picture_request asked{};
  EXPECT_EQ(draw(asked), SEAWAY_SHM_OK);
  asked.width = asked.height = 4000000000u;
  EXPECT_EQ(draw(asked), SEAWAY_SHM_TOO_LARGE);
  asked.width = asked.height = 8;
  std::strcpy(asked.camera, "nobody");
  EXPECT_EQ(draw(asked), SEAWAY_SHM_NOT_FOUND);
  std::memset(asked.camera, 'x', sizeof asked.camera);
  EXPECT_EQ(draw(asked), SEAWAY_SHM_OK);
  asked.time = NAN;
  EXPECT_EQ(draw(asked), SEAWAY_SHM_BAD_VALUE);
  asked.time = 0.0;
  asked.flags = 1u << 30;
  EXPECT_EQ(draw(asked), SEAWAY_SHM_MALFORMED);
}

TEST_F(ShmClient, AsksAtTheServersTimeWhereItHasAClock) {
  Client client(name_);
  const std::vector<double> none{0.0};
  EXPECT_EQ(statusOf([&] { client.sample(none, none, {.serversTime = true}); }),
            SEAWAY_SHM_BAD_VALUE);
  ShmOptions options = knownOptions(sea_, test::uniqueName());
  options.backing.now = [] { return 12.0; };
  ShmEndpoint other(options);
  other.start();
  Client asking(options.name);
  EXPECT_EQ(asking.sample(none, none, {.time = 3.0, .serversTime = true}).height[0], 12.0);
}

TEST_F(ShmClient, FindsASegmentThatOnlyItsOwnerMayOpen) {
  const int file = shm_open(("/" + name_).c_str(), O_RDWR, 0);
  struct stat about {};
  ASSERT_EQ(fstat(file, &about), 0);
  EXPECT_EQ(about.st_mode & 0777, 0600u);
  close(file);
}

TEST_F(ShmClientHard, NanPointsAndTimesAreAnsweredWithAStatus) {
  Client client(name_);
  const std::vector<double> x{1.0, NAN, INFINITY}, y{1.0, 1.0, 1.0};
  const auto got = client.sample(x, y, {});
  EXPECT_EQ(got.status[0], 0u);
  EXPECT_EQ(got.status[1], unsigned{SEAWAY_SHM_POINT_NOT_FINITE});
  EXPECT_TRUE(std::isnan(got.height[1]));
  EXPECT_EQ(got.height[0], 5.0);
  EXPECT_EQ(client.sample(x, y, {.time = NAN}).status[0], unsigned{SEAWAY_SHM_POINT_NOT_FINITE});
}

TEST_F(ShmClientHard, TooManyPointsAreRefusedByBothSidesWithTheLimit) {
  Client client(name_);
  const auto many = counted(1001, 1.0);
  EXPECT_EQ(statusOf([&] { client.sample(many, many, {}); }), SEAWAY_SHM_TOO_LARGE);
  EXPECT_NE(message_.find("at most 1000"), std::string::npos) << message_;
  seaway_shm_batch batch;
  for (const std::uint32_t count : {1001u, 1000000u, UINT32_MAX}) {
    ASSERT_EQ(seaway_shm_begin(&client.c(), SEAWAY_SHM_SAMPLE, &batch), SEAWAY_SHM_OK);
    batch.request->count = count;
    EXPECT_EQ(seaway_shm_call(&client.c(), &batch), SEAWAY_SHM_TOO_LARGE);
    EXPECT_NE(std::string(client.c().message).find("at most 1000"), std::string::npos);
  }
  EXPECT_EQ(sea_.refusals, 3u);
}

TEST_F(ShmClientHard, BadValuesAreRefusedWithAMessage) {
  Client client(name_);
  const std::vector<double> one{1.0};
  EXPECT_EQ(statusOf([&] { client.sample(one, one, {.tolerance = -1.0}); }), SEAWAY_SHM_BAD_VALUE);
  EXPECT_NE(message_.find("tolerance"), std::string::npos) << message_;
  EXPECT_EQ(statusOf([&] { client.sample(one, one, {.shortestWavelength = NAN}); }),
            SEAWAY_SHM_BAD_VALUE);
  EXPECT_EQ(statusOf([&] { client.sample(one, one, {.ownHull = 77}); }), SEAWAY_SHM_NOT_FOUND);
}

TEST_F(ShmClientHard, ASlowHostDoesNotBlockAnother) {
  Client slow(name_), quick(name_);
  sea_.seconds = 0.5;
  seaway_shm_batch batch;
  ASSERT_EQ(seaway_shm_begin(&slow.c(), SEAWAY_SHM_SAMPLE, &batch), SEAWAY_SHM_OK);
  batch.request->count = 1;
  seaway_shm_submit(&slow.c(), &batch);
  ASSERT_EQ(seaway_shm_wait(&slow.c(), &batch, 0.05), SEAWAY_SHM_TIMEOUT);
  sea_.seconds = 0.0;
  const std::vector<double> one{1.0};
  for (int i = 0; i < 100; ++i) EXPECT_EQ(quick.sample(one, one, {}).height[0], 5.0);
  EXPECT_EQ(seaway_shm_wait(&slow.c(), &batch, 0.0), SEAWAY_SHM_TIMEOUT);
  EXPECT_EQ(seaway_shm_wait(&slow.c(), &batch, 20.0), SEAWAY_SHM_OK);
}

TEST_F(ShmClientHard, MoreHostsThanSlotsAreToldAndServedWhenOneLeaves) {
  std::vector<Client> clients;
  for (int i = 0; i < 4; ++i) clients.emplace_back(name_);
  seaway_shm_options options = seaway_shm_default_options();
  options.connect_timeout = 0.1;
  EXPECT_EQ(statusOf([&] { Client fifth(name_, options); }), SEAWAY_SHM_NO_SLOT);
  // By the server's next look; once, though the client looked for a slot many times.
  EXPECT_TRUE(comesTrue([&] { return sea_.refusals == 1; }));
  EXPECT_EQ(sea_.lastRefusal, SEAWAY_SHM_NO_SLOT);
  std::thread leaving([&] {
    usleep(50000);
    clients.pop_back();
  });
  Client fifth(name_);
  leaving.join();
  const std::vector<double> one{1.0};
  EXPECT_EQ(fifth.sample(one, one, {}).height[0], 5.0);
}

TEST_F(ShmClientHard, AThousandConnectionsLeaveNothingBehind) {
  const std::vector<double> one{1.0};
  for (int i = 0; i < 1000; ++i) {
    Client client(name_);
    client.addHull(0);
    ASSERT_EQ(client.sample(one, one, {.time = 1.0 * i}).height[0], 5.0 + i);
  }
  EXPECT_TRUE(comesTrue([&] { return sea_.hosts == 0 && sea_.hullsNow().empty(); }));
  // The pages of the rings are given back: what is left is the header and a page a slot.
  const int file = shm_open(("/" + name_).c_str(), O_RDWR, 0);
  struct stat about {};
  EXPECT_TRUE(comesTrue([&] {
    return fstat(file, &about) == 0 && about.st_blocks * 512 <= 5 * SEAWAY_SHM_PAGE;
  })) << about.st_blocks * 512;
  close(file);
}

TEST_F(ShmClientHard, TimeMayGoBackwardsAndHostsClocksMayDiffer) {
  Client early(name_), late(name_);
  const std::vector<double> none{0.0};
  for (const double t : {10.0, -5.0, 1e6, 0.0}) {
    EXPECT_EQ(early.sample(none, none, {.time = t}).height[0], t);
    EXPECT_EQ(late.sample(none, none, {.time = t + 1e5}).height[0], t + 1e5);
  }
}

TEST(ShmName, ThatIsNotAllowedIsRefused) {
  KnownSea sea;
  for (const std::string name : {"", ".hidden", "a/b", "blank name", "\xc3\xa4"}) {
    EXPECT_THROW(ShmEndpoint(knownOptions(sea, name)), InputError) << name;
  }
  EXPECT_THROW(ShmEndpoint(knownOptions(sea, std::string(201, 'a'))), InputError);
}

TEST(ShmName, WithoutAServerIsToldWithinTheTimeout) {
  seaway_shm_client client;
  seaway_shm_options options = seaway_shm_default_options();
  options.connect_timeout = 0.05;
  EXPECT_EQ(seaway_shm_connect(&client, "seaway-nobody", &options), SEAWAY_SHM_NO_SERVER);
  EXPECT_EQ(seaway_shm_connect(&client, "a/b", &options), SEAWAY_SHM_BAD_VALUE);
  seaway_shm_batch batch;
  EXPECT_EQ(seaway_shm_begin(&client, SEAWAY_SHM_SAMPLE, &batch), SEAWAY_SHM_NOT_CONNECTED);
  seaway_shm_disconnect(&client);
}

}  // namespace
}  // namespace seaway::bridge::shm
