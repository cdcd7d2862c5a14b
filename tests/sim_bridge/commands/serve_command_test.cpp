#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>

#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene/sea.h"
#include "tests/sim_bridge/cigi/random_packets.h"
#include "tests/sim_bridge/cigi/udp_host.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

using namespace cigi;
using cigi::test::UdpSocket;
using seaway::bridge::test::TempFolder;
using seaway::bridge::test::writeScene;

constexpr int hangs = 20000;  // ms

/// `seaway serve` as a child, from its first line on.
class Service {
 public:
  Service(const std::string& scene, std::vector<std::string> options) {
    int ends[2];
    EXPECT_EQ(pipe(ends), 0);
    options.insert(options.begin(), {SEAWAY_COMMAND, "serve", scene});
    std::vector<char*> arguments;
    for (std::string& option : options) arguments.push_back(option.data());
    arguments.push_back(nullptr);
    child_ = fork();
    if (child_ == 0) {
      dup2(ends[1], STDERR_FILENO);
      close(ends[0]);
      close(ends[1]);
      execv(SEAWAY_COMMAND, arguments.data());
      _exit(99);
    }
    close(ends[1]);
    errors_ = ends[0];
    readUntil("serves");
  }
  ~Service() {
    if (child_ > 0) end(SIGKILL);
    close(errors_);
  }

  /// The port that its first line tells.
  SocketAddress address() const {
    const std::size_t at = text_.find("127.0.0.1:");
    EXPECT_NE(at, std::string::npos) << text_;
    if (at == std::string::npos) return {};
    return {"127.0.0.1", static_cast<std::uint16_t>(std::stoi(text_.substr(at + 10)))};
  }
  int end(int signal) {
    kill(child_, signal);
    readUntil("");
    int status = 0;
    waitpid(child_, &status, 0);
    child_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }
  const std::string& text() const { return text_; }

 private:
  /// Reads until a word has come, or to the end.
  void readUntil(const std::string& word) {
    char part[512];
    while (word.empty() || text_.find(word) == std::string::npos) {
      const ssize_t size = read(errors_, part, sizeof part);
      if (size <= 0) return;
      text_.append(part, static_cast<std::size_t>(size));
    }
  }
  pid_t child_ = 0;
  int errors_ = -1;
  std::string text_;
};

std::vector<std::byte> ask(std::uint32_t frame, double t) {
  return cigi::test::datagramOf(
      {}, {IgControl{.mode = 1,
                     .timestampValid = true,
                     .hostFrame = frame,
                     .timestamp = static_cast<std::uint32_t>(std::llround(t * 1e5))},
           HatHotRequest{.request = 3, .type = 1, .latitude = 28.88, .longitude = -78.46}});
}

HatHotResponse answerIn(const std::vector<std::byte>& datagram) {
  const auto answers = cigi::test::packetsOf<HatHotResponse>(datagram);
  EXPECT_EQ(answers.size(), 1u);
  return answers.empty() ? HatHotResponse{} : answers[0];
}

TEST(ServeCommand, AnswersAHostFromTheScenesSeaAtTheHostsTimeAndEndsWithZero) {
  const TempFolder folder;
  const std::string file = writeScene(folder).string();
  Service service(file, {"--cigi", "0"});
  const Scene scene = loadScene(file);
  const Sea sea = buildSea(scene);
  const glm::dvec2 place = sea.geodesy.seaPlaneFromGeodetic(28.88, -78.46).position;
  UdpSocket host;
  for (std::uint32_t frame = 1; frame <= 5; ++frame) {
    host.send(ask(frame, 2.5 * frame), service.address());
    const HatHotResponse answer = answerIn(host.receive(hangs));
    EXPECT_TRUE(answer.valid);
    // Half a millimetre of place (PlanePlacer), on slopes below 1.
    EXPECT_NEAR(answer.height, sea.surface.sample(place, 2.5 * frame).height, 5e-4);
  }
  EXPECT_EQ(service.end(SIGTERM), 0);
  EXPECT_NE(service.text().find("heights=5"), std::string::npos) << service.text();
}

TEST(ServeCommand, EndsWithZeroWhenInterruptedUnderLoad) {
  const TempFolder folder;
  Service service(writeScene(folder).string(), {"--cigi", "127.0.0.1:0", "--clock", "x4"});
  UdpSocket host;
  const SocketAddress address = service.address();
  std::atomic<bool> ending = false;
  std::thread load([&] {
    for (std::uint32_t frame = 1; !ending; ++frame) {
      try {
        host.send(ask(frame, 0.0), address);
      } catch (const std::exception&) {
        // The port is closed by now.
      }
    }
  });
  EXPECT_FALSE(host.receive(hangs).empty());
  EXPECT_EQ(service.end(SIGINT), 0);
  ending = true;
  load.join();
}

TEST(ServeCommandHard, BadOptionsAndAPortInUseEndWithTwoAndAMessage) {
  const TempFolder folder;
  const std::string scene = writeScene(folder).string();
  const UdpSocket other;
  const std::string taken = other.address().text();
  const auto refused = [&](std::vector<std::string> options, const std::string& message) {
    options.insert(options.begin(), {"serve", scene});
    const auto outcome = seaway::bridge::test::seaway(options);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find(message), std::string::npos) << outcome.err;
  };
  refused({}, "nothing to serve");
  refused({"--cigi", taken}, taken);
  refused({"--cigi", "70000"}, "--cigi: '70000' is not allowed");
  refused({"--cigi", "0", "--clock", "x0"}, "--clock: 'x0' is not allowed");
  refused({"--cigi", "0", "--cigi-pacing", "fast"}, "--cigi-pacing: 'fast' is not allowed");
  refused({"--cigi", "0", "--cigi-version", "3.2"}, "--cigi-version: '3.2' is not allowed");
  refused({"--cigi", "0", "--cigi-rate", "0"}, "--cigi-rate");
  refused({"--cigi", "0", "--cigi-host", "nowhere"}, "--cigi-host: 'nowhere' is not allowed");
}

}  // namespace
}  // namespace seaway::bridge
