#include <gtest/gtest.h>
#include <sys/mman.h>

#include <cstring>
#include <random>

#include "sim_bridge/shm/seaway_shm.hpp"
#include "tests/sim_bridge/shm/known_sea.h"

// Hosts that write what they like, where they like: the server goes on and serves the others.
namespace seaway::bridge::shm {
namespace {

using seaway::shm::Client;
using test::comesTrue;
using test::knownOptions;
using test::KnownSea;

class ShmHostileHard : public ::testing::Test {
 protected:
  ShmHostileHard() { endpoint_.start(); }

  static void expectServed(Client& client, double t) {
    const std::vector<double> one{1.0};
    EXPECT_EQ(client.sample(one, one, {.time = t}).height[0], 5.0 + t);
  }
  /// Random bytes into a stretch of memory, few or many.
  void scribble(void* memory, std::size_t size) {
    auto* const bytes = static_cast<unsigned char*>(memory);
    const std::size_t count = random_() % 2 == 0 ? 1 + random_() % 8 : size;
    for (std::size_t i = 0; i < count; ++i) {
      bytes[count == size ? i : random_() % size] = static_cast<unsigned char>(random_());
    }
  }

  std::mt19937 random_{20261122};
  KnownSea sea_;
  const std::string name_ = test::uniqueName();
  ShmEndpoint endpoint_{knownOptions(sea_, name_)};
};

TEST_F(ShmHostileHard, RandomBytesInACellAreAnsweredOrRefusedByItsNumber) {
  Client hostile(name_), other(name_);
  seaway_shm_client& client = hostile.c();
  int answered = 0, refused = 0;
  for (int round = 0; round < 4000; ++round) {
    seaway_shm_batch batch;
    ASSERT_EQ(seaway_shm_begin(&client, 1 + random_() % 6, &batch), SEAWAY_SHM_OK);
    batch.request->count = random_() % 2 == 0 ? random_() % 1200 : random_();
    scribble(batch.request, sizeof *batch.request);
    // Most keep their number, so that what comes after it is looked at.
    if (random_() % 8 != 0) batch.request->number = batch.number;
    if (random_() % 8 == 0) scribble(batch.bytes, 4096);
    const seaway_shm_status status = seaway_shm_call(&client, &batch);
    ASSERT_NE(status, SEAWAY_SHM_TIMEOUT);
    ASSERT_EQ(batch.answer->number, batch.number);
    ++(status == SEAWAY_SHM_OK ? answered : refused);
  }
  EXPECT_GT(answered, 50);
  EXPECT_GT(refused, 50);
  EXPECT_EQ(sea_.refusals, static_cast<std::uint64_t>(refused));
  expectServed(other, 4.0);
}

TEST_F(ShmHostileHard, RandomBytesInASlotsWordsEndAtMostThatHost) {
  Client other(name_);
  for (int round = 0; round < 300; ++round) {
    seaway_shm_client client;
    ASSERT_EQ(seaway_shm_connect(&client, name_.c_str(), nullptr), SEAWAY_SHM_OK);
    scribble(client.slot, sizeof *client.slot);
    seaway_shm_wake(&client.slot->asked);
    __atomic_add_fetch(&client.header->pictures_asked, 1, __ATOMIC_SEQ_CST);
    seaway_shm_wake(&client.header->pictures_asked);
    seaway_shm_wake(&client.header->attention);
    expectServed(other, round);
    if (round % 2 == 0) {
      seaway_shm_close(&client);  // as a process that dies
    } else {
      seaway_shm_disconnect(&client);
    }
  }
  expectServed(other, 1.0);
  EXPECT_TRUE(comesTrue([&] { return sea_.hosts == 1; }));
}

TEST_F(ShmHostileHard, ARingThatRunsAheadIsRefusedAndTheSlotServesTheNextHost) {
  Client hostile(name_);
  seaway_shm_store(&hostile.c().slot->asked, 100);
  seaway_shm_wake(&hostile.c().slot->asked);
  EXPECT_TRUE(comesTrue([&] {
    seaway_shm_batch batch;
    return seaway_shm_begin(&hostile.c(), SEAWAY_SHM_SAMPLE, &batch) == SEAWAY_SHM_MALFORMED;
  }));
  EXPECT_EQ(sea_.lastRefusal, SEAWAY_SHM_MALFORMED);
  hostile.reconnect();
  expectServed(hostile, 2.0);
}

TEST_F(ShmHostileHard, ANumberOfHostsTurnedAwayThatCannotBeIsCountedInPartAndServesOn) {
  Client hostile(name_), other(name_);
  seaway_shm_store(&hostile.c().header->turned_away, 0x7000'0000u);
  EXPECT_TRUE(comesTrue([&] { return sea_.refusals > 0; }));
  expectServed(other, 2.0);
  // At one look; a word that goes back is believed nothing.
  seaway_shm_store(&hostile.c().header->turned_away, 5);
  usleep(600'000);  // two looks and more
  EXPECT_EQ(sea_.refusals, 1000u);
  EXPECT_EQ(sea_.lastRefusal, SEAWAY_SHM_NO_SLOT);
}

TEST_F(ShmHostileHard, ASpoiltHeaderIsMadeAnewAndHostsReconnect) {
  Client other(name_), hostile(name_);
  for (int round = 0; round < 5; ++round) {
    std::memset(hostile.c().header, 0x40 + round, 128);
    EXPECT_TRUE(comesTrue([&] { return seaway_shm_reconnect(&hostile.c()) == SEAWAY_SHM_OK; }));
    expectServed(hostile, round);
  }
  EXPECT_TRUE(comesTrue([&] { return seaway_shm_reconnect(&other.c()) == SEAWAY_SHM_OK; }));
  expectServed(other, 3.0);
}

TEST_F(ShmHostileHard, MemoryCutShortUnderneathIsMadeAnewAndHostsReconnect) {
  for (int round = 0; round < 3; ++round) {
    Client hostile(name_);
    hostile.addHull(0);
    ASSERT_EQ(ftruncate(hostile.c().file, 0), 0);
    // What is cut off is gone for the host too: it must not touch it any more, even to leave.
    close(std::exchange(hostile.c().file, -1));
    munmap(std::exchange(hostile.c().slot, nullptr), hostile.layout().slot_size);
    munmap(std::exchange(hostile.c().header, nullptr), SEAWAY_SHM_PAGE);
    EXPECT_TRUE(comesTrue([&] { return seaway_shm_reconnect(&hostile.c()) == SEAWAY_SHM_OK; }));
    expectServed(hostile, 1.0);
    EXPECT_TRUE(comesTrue([&] { return sea_.hullsNow().empty(); }));
  }
}

TEST_F(ShmHostileHard, HostsDoNotBelieveAHeaderThatDoesNotFitItsFile) {
  const seaway_shm_header good = headerFor({.slots = 2, .points = 100, .pixels = 100});
  EXPECT_TRUE(seaway_shm_layout_fits(&good, good.segment_size));
  EXPECT_FALSE(seaway_shm_layout_fits(&good, good.segment_size - 1));
  for (int round = 0; round < 40000; ++round) {
    seaway_shm_header bad = good;
    // Offsets and sizes alone: magic and version are looked at elsewhere.
    scribble(&bad.slot_count,
             offsetof(seaway_shm_header, server_number) - offsetof(seaway_shm_header, slot_count));
    if (!seaway_shm_layout_fits(&bad, good.segment_size)) continue;
    const std::uint64_t cells = bad.cells_offset + bad.cell_count * bad.cell_size;
    ASSERT_LE(cells, bad.pixels_offset);
    ASSERT_LE(bad.pixels_offset + 7ull * bad.pixel_limit, bad.slot_size);
    ASSERT_LE(bad.slots_offset + bad.slot_count * bad.slot_size, good.segment_size);
  }
}

}  // namespace
}  // namespace seaway::bridge::shm
