#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <memory>
#include <string>
#include <thread>

#include "sim_bridge/shm/seaway_shm.hpp"
#include "tests/sim_bridge/shm/known_sea.h"
#include "tests/sim_bridge/test_support.h"

// `seaway serve SCENE --shm NAME`, as a process of its own.
namespace seaway::bridge::shm {
namespace {

using seaway::bridge::test::TempFolder;
using seaway::bridge::test::writeWakelessScene;
using seaway::shm::Client;

class Service {
 public:
  Service(const std::string& scene, const std::string& name) {
    child_ = fork();
    if (child_ != 0) return;
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDERR_FILENO);
    execl(SEAWAY_COMMAND, SEAWAY_COMMAND, "serve", scene.c_str(), "--shm", name.c_str(), nullptr);
    _exit(99);
  }
  ~Service() {
    if (child_ > 0) end(SIGKILL);
  }
  int end(int signal) {
    kill(child_, signal);
    int status = 0;
    waitpid(child_, &status, 0);
    child_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

 private:
  pid_t child_;
};

seaway_shm_options patient() {
  seaway_shm_options options = seaway_shm_default_options();
  options.connect_timeout = 30.0;  // s: a build with sanitizers starts slowly
  options.call_timeout = 30.0;
  return options;
}

const std::vector<double> here{0.0};

TEST(ServeShm, AnswersUntilItIsTerminatedWhichHostsAreTold) {
  const TempFolder folder;
  const std::string scene = writeWakelessScene(folder).string(), name = test::uniqueName();
  Service service(scene, name);
  Client host(name, patient());
  EXPECT_TRUE(std::isfinite(host.sample(here, here, {.time = 3.0}).height[0]));
  EXPECT_EQ(service.end(SIGTERM), 0);
  try {
    host.sample(here, here, {});
    ADD_FAILURE() << "answered by nobody";
  } catch (const seaway::shm::Error& error) {
    EXPECT_EQ(error.status(), SEAWAY_SHM_SERVER_GONE);
  }
  EXPECT_EQ(shm_open(("/" + name).c_str(), O_RDWR, 0), -1) << "the name is taken away";
}

TEST(ServeShmHard, OneThatWasKilledIsReplacedAndItsHostsReconnect) {
  const TempFolder folder;
  const std::string scene = writeWakelessScene(folder).string(), name = test::uniqueName();
  auto service = std::make_unique<Service>(scene, name);
  Client host(name, patient());
  const double height = host.sample(here, here, {.time = 3.0}).height[0];
  for (int round = 0; round < 2; ++round) {
    service->end(SIGKILL);
    EXPECT_THROW(host.sample(here, here, {.time = 3.0}), seaway::shm::Error);
    service = std::make_unique<Service>(scene, name);
    host.reconnect();
    EXPECT_EQ(host.sample(here, here, {.time = 3.0}).height[0], height);
  }
  EXPECT_EQ(service->end(SIGTERM), 0);
}

TEST(ServeShmHard, IsEndedUnderLoadWithZero) {
  const TempFolder folder;
  const std::string scene = writeWakelessScene(folder).string(), name = test::uniqueName();
  Service service(scene, name);
  Client first(name, patient());
  std::atomic<int> hostsServed{0}, served{0}, told{0};
  std::vector<std::thread> hosts;
  for (int i = 0; i < 3; ++i) {
    hosts.emplace_back([&] {
      try {
        Client host(name, patient());
        host.sample(here, here, {});
        ++hostsServed;
        for (;; ++served) host.sample(here, here, {});
      } catch (const seaway::shm::Error& error) {
        if (error.status() == SEAWAY_SHM_SERVER_GONE) ++told;
      }
    });
  }
  EXPECT_TRUE(test::comesTrue([&] { return hostsServed == 3 && served > 300; }));
  EXPECT_EQ(service.end(SIGTERM), 0);
  for (std::thread& host : hosts) host.join();
  EXPECT_EQ(told, 3);
}

TEST(ServeShmHard, ANameInUseAndBadOptionsEndWithTwoAndAMessage) {
  const TempFolder folder;
  const std::string scene = writeWakelessScene(folder).string(), name = test::uniqueName();
  Service service(scene, name);
  const Client host(name, patient());
  const auto refused = [&](std::vector<std::string> options, const std::string& message) {
    options.insert(options.begin(), {"serve", scene});
    const auto outcome = seaway::bridge::test::seaway(options);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
  };
  refused({"--shm", name}, "--shm: '" + name + "': in use by another server");
  refused({"--shm", "a/b"}, "--shm: 'a/b' is not allowed");
  refused({"--shm", "other", "--shm-hosts", "0"}, "--shm-hosts: 0 is not allowed");
  refused({"--shm", "other", "--shm-points", "2000000"}, "--shm-points: 2000000 is not allowed");
}

}  // namespace
}  // namespace seaway::bridge::shm
