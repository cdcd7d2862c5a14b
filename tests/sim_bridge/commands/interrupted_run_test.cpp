#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

using test::TempFolder;
using test::writeScene;

bool isSailing(const TempFolder& folder) {
  for (const std::string& name : folder.files()) {
    if (name.find("telemetry.csv.part") != std::string::npos) return true;
  }
  return false;
}

// Starts a run without end, sends it a signal once it writes, and returns its exit status.
int statusAfter(int signal, const TempFolder& folder) {
  const std::string scene = writeScene(folder).string();
  const std::string out = (folder / "out").string();
  const pid_t child = fork();
  if (child == 0) {
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    execl(SEAWAY_COMMAND, SEAWAY_COMMAND, "run", scene.c_str(), "--out", out.c_str(), "--fps", "0",
          "--duration", "9999999", static_cast<char*>(nullptr));
    _exit(99);
  }
  // No time is measured: a minute is when a machine is taken to hang.
  using namespace std::chrono_literals;
  int waited = 0;
  while (!isSailing(folder) && ++waited < 3000) {
    std::this_thread::sleep_for(20ms);
  }
  EXPECT_TRUE(isSailing(folder));
  kill(child, signal);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

TEST(InterruptedRunHard, LeavesNoPartialFilesAndTheStatusOfTheSignal) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const TempFolder folder;
    EXPECT_EQ(statusAfter(signal, folder), 128 + signal);
    EXPECT_EQ(folder.files(), (std::vector<std::string>{
                                  "launch.yaml", "out/summary.json.unfinished", "scene.yaml"}));
  }
}

TEST(InterruptedRunHard, TheNextRunInTheFolderClearsUpAfterIt) {
  const TempFolder folder;
  statusAfter(SIGINT, folder);
  // As if it had drawn three frames and finished a telemetry file.
  folder.write("out/summary.json.unfinished",
               R"({"telemetry": ["telemetry.csv", "telemetry_tender.csv"],
                   "cameras": ["quay", "mast"], "frames": 3})");
  for (const char* name : {"telemetry_tender.csv", "frames/000002.png", "frames/mast/000000.png"}) {
    folder.write(std::string("out/") + name, "");
  }
  const auto outcome = test::seaway(
      {"run", (folder / "scene.yaml").string(), "--out", (folder / "out").string(), "--fps", "1"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(folder.files(),
            (std::vector<std::string>{"launch.yaml", "out/frames/000000.png", "out/summary.json",
                                      "out/telemetry.csv", "scene.yaml"}));
}

}  // namespace
}  // namespace seaway::bridge
