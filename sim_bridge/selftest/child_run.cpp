#include "sim_bridge/selftest/child_run.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <system_error>
#include <thread>

namespace seaway::bridge {
namespace {

constexpr std::size_t mostText = std::size_t{16} << 20;

/// A nameless file that a child writes to.
class Capture {
 public:
  Capture() : file_(memfd_create("seaway_child", MFD_CLOEXEC)) {
    if (file_ < 0) throw std::system_error(errno, std::generic_category(), "memfd_create");
  }
  ~Capture() { close(file_); }
  Capture(const Capture&) = delete;
  Capture& operator=(const Capture&) = delete;

  int file() const { return file_; }
  std::string text() const {
    const off_t end = lseek(file_, 0, SEEK_END);
    std::string all(std::min(mostText, static_cast<std::size_t>(std::max<off_t>(end, 0))), '\0');
    const ssize_t got = pread(file_, all.data(), all.size(), 0);
    all.resize(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    return all;
  }

 private:
  int file_;
};

pid_t spawn(const std::filesystem::path& program, const std::vector<std::string>& arguments,
            const Capture& out, const Capture& err) {
  std::vector<std::string> words{program.filename().string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&files, out.file(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, err.file(), STDERR_FILENO);
  pid_t child = 0;
  const int fault = posix_spawn(&child, program.c_str(), &files, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (fault != 0) throw std::system_error(fault, std::generic_category(), "posix_spawn");
  return child;
}

}  // namespace

ChildOutcome runProgram(const std::filesystem::path& program,
                        const std::vector<std::string>& arguments, const ChildLimits& limits) {
  using Clock = std::chrono::steady_clock;
  const Capture out, err;
  const auto start = Clock::now();
  const pid_t child = spawn(program, arguments, out, err);
  const rlimit memory{limits.memoryBytes, limits.memoryBytes};
  if (limits.memoryBytes > 0) prlimit(child, RLIMIT_AS, &memory, nullptr);
  ChildOutcome outcome;
  int status = 0;
  bool isAskedToEnd = !limits.isEnough;
  for (auto pause = std::chrono::microseconds(500); waitpid(child, &status, WNOHANG) == 0;) {
    if (!isAskedToEnd && limits.isEnough(err.text())) {
      isAskedToEnd = true;
      kill(child, SIGTERM);
    }
    if (!outcome.timedOut && Clock::now() - start > limits.time) {
      outcome.timedOut = true;
      kill(child, SIGKILL);
    }
    std::this_thread::sleep_for(pause);
    pause = std::min(pause * 2, std::chrono::microseconds(20'000));
  }
  outcome.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  if (WIFEXITED(status)) outcome.status = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) outcome.signal = WTERMSIG(status);
  outcome.out = out.text();
  outcome.err = err.text();
  return outcome;
}

}  // namespace seaway::bridge
