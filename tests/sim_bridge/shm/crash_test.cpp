#include <gtest/gtest.h>
#include <sys/mman.h>

#include <atomic>
#include <memory>
#include <thread>

#include "sim_bridge/shm/seaway_shm.hpp"
#include "surface/input_error.h"
#include "tests/sim_bridge/shm/child_process.h"
#include "tests/sim_bridge/shm/known_sea.h"

namespace seaway::bridge::shm {
namespace {

using seaway::shm::Client;
using test::ChildProcess;
using test::comesTrue;
using test::knownOptions;
using test::KnownSea;

constexpr double hangs = 20.0;  // s

/// A server with its sea, whose samples take so many seconds.
struct Server {
  explicit Server(const std::string& name, double seconds = 0.0)
      : endpoint(knownOptions(sea, name)) {
    sea.seconds = seconds;
    endpoint.start();
  }
  KnownSea sea;
  ShmEndpoint endpoint;
};

ChildProcess serverProcess(const std::string& name, double seconds = 0.0) {
  return ChildProcess([&] { return std::make_unique<Server>(name, seconds); });
}

/// A sample under way.
seaway_shm_batch asked(seaway_shm_client& client) {
  seaway_shm_batch batch{};
  EXPECT_EQ(seaway_shm_begin(&client, SEAWAY_SHM_SAMPLE, &batch), SEAWAY_SHM_OK);
  batch.request->count = 1;
  batch.x[0] = batch.y[0] = 1.0;
  seaway_shm_submit(&client, &batch);
  return batch;
}

void expectServed(Client& client, double t) {
  const std::vector<double> one{1.0};
  const auto got = client.sample(one, one, {.time = t});
  EXPECT_EQ(got.height[0], 5.0 + t);
}

TEST(ShmCrashHard, AHostKilledMidCallLosesItsHullsAndNobodyElseNotices) {
  const std::string name = test::uniqueName();
  Server server(name, 0.05);
  Client other(name);
  const std::uint32_t kept = other.addHull(0);
  for (int round = 0; round < 3; ++round) {
    ChildProcess host([&] {
      auto client = std::make_unique<Client>(name);
      client->addHull(1);
      asked(client->c());
      return client;
    });
    ASSERT_TRUE(host.ready());
    EXPECT_EQ(server.sea.hullsNow().size(), 2u);
    host.kill();
    expectServed(other, round);
    EXPECT_TRUE(comesTrue([&] { return server.sea.hosts == 1; }));
    EXPECT_EQ(server.sea.hullsNow(), std::set{kept});
  }
  // Its slot is another's now.
  std::vector<std::unique_ptr<Client>> all;
  for (int i = 0; i < 3; ++i) all.push_back(std::make_unique<Client>(name));
  for (const auto& client : all) expectServed(*client, 2.0);
}

TEST(ShmCrashHard, ARequestHalfWrittenByAHostThatDiesIsNeverSeen) {
  const std::string name = test::uniqueName();
  Server server(name);
  ChildProcess host([&] {
    auto client = std::make_unique<Client>(name);
    seaway_shm_batch batch;
    seaway_shm_begin(&client->c(), SEAWAY_SHM_SAMPLE, &batch);
    batch.request->count = 1u << 31;
    batch.request->kind = 77;
    return client;
  });
  ASSERT_TRUE(host.ready());
  host.kill();
  EXPECT_TRUE(comesTrue([&] { return server.sea.hosts == 0; }));
  Client next(name);
  expectServed(next, 1.0);
  EXPECT_EQ(server.sea.refusals, 0u);
}

TEST(ShmCrashHard, AServerKilledWhileAHostWaitsIsToldAndItsSuccessorServes) {
  const std::string name = test::uniqueName();
  ChildProcess first = serverProcess(name, hangs);
  ASSERT_TRUE(first.ready());
  Client client(name);
  const seaway_shm_batch batch = asked(client.c());
  EXPECT_EQ(seaway_shm_wait(&client.c(), &batch, 0.01), SEAWAY_SHM_TIMEOUT);
  std::thread killing([&] {
    usleep(20000);
    first.kill();
  });
  EXPECT_EQ(seaway_shm_wait(&client.c(), &batch, hangs), SEAWAY_SHM_SERVER_GONE);
  killing.join();
  seaway_shm_batch none;
  EXPECT_EQ(seaway_shm_begin(&client.c(), SEAWAY_SHM_SAMPLE, &none), SEAWAY_SHM_SERVER_GONE);
  client.c().options.connect_timeout = 0.02;
  EXPECT_EQ(seaway_shm_reconnect(&client.c()), SEAWAY_SHM_NO_SERVER);
  // The name was left behind; the next server takes it.
  const Server second(name);
  client.c().options.connect_timeout = hangs;
  client.reconnect();
  expectServed(client, 3.0);
}

TEST(ShmCrashHard, AServerKilledWhileItsPictureIsAwaitedIsToldToo) {
  const std::string name = test::uniqueName();
  ChildProcess server([&] {
    auto made = std::make_unique<Server>(name);
    made->sea.drawing = hangs;
    return made;
  });
  ASSERT_TRUE(server.ready());
  Client client(name);
  client.askPicture({});
  std::thread killing([&] {
    usleep(20000);
    server.kill();
  });
  seaway_shm_picture picture;
  EXPECT_EQ(seaway_shm_wait_picture(&client.c(), &picture, hangs), SEAWAY_SHM_SERVER_GONE);
  killing.join();
  shm_unlink(("/" + name).c_str());
}

TEST(ShmCrashHard, AServerThatEndsUnderLoadAnswersOrTellsEveryHost) {
  const std::string name = test::uniqueName();
  auto server = std::make_unique<Server>(name);
  std::atomic<int> hostsServed{0}, served{0}, told{0}, wrong{0};
  std::vector<std::thread> hosts;
  for (int i = 0; i < 3; ++i) {
    hosts.emplace_back([&] {
      Client client(name);
      for (double t = 0.0;; t += 1.0) {
        try {
          const std::vector<double> one{1.0};
          if (client.sample(one, one, {.time = t}).height[0] != 5.0 + t) ++wrong;
          if (t == 0.0) ++hostsServed;
          ++served;
        } catch (const seaway::shm::Error& error) {
          if (error.status() == SEAWAY_SHM_SERVER_GONE) ++told;
          return;
        }
      }
    });
  }
  EXPECT_TRUE(comesTrue([&] { return hostsServed == 3 && served > 1000; }));
  server->endpoint.stop();
  for (std::thread& host : hosts) host.join();
  EXPECT_EQ(told, 3);
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(shm_open(("/" + name).c_str(), O_RDWR, 0), -1) << "the name is taken away";
}

TEST(ShmCrashHard, ANameInUseByALiveServerIsRefusedAndStaysInUse) {
  const std::string name = test::uniqueName();
  const Server server(name);
  KnownSea sea;
  try {
    const ShmEndpoint second(knownOptions(sea, name));
    ADD_FAILURE() << "two servers of one name";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("--shm: '" + name + "': in use by another server"),
              std::string::npos)
        << error.what();
  }
  Client client(name);
  expectServed(client, 0.0);
}

TEST(ShmCrashHard, MemoryOfThatNameThatIsNotOursIsLeftAlone) {
  const std::string name = test::uniqueName(), path = "/" + name;
  const int file = shm_open(path.c_str(), O_RDWR | O_CREAT, 0600);
  ASSERT_EQ(write(file, "another program's", 17), 17);
  KnownSea sea;
  EXPECT_THROW(ShmEndpoint(knownOptions(sea, name)), InputError);
  char text[18] = "";
  EXPECT_EQ(pread(file, text, 17, 0), 17);
  EXPECT_STREQ(text, "another program's");
  seaway_shm_client client;
  EXPECT_EQ(seaway_shm_connect(&client, name.c_str(), nullptr), SEAWAY_SHM_NO_SERVER);
  close(file);
  shm_unlink(path.c_str());
}

}  // namespace
}  // namespace seaway::bridge::shm
