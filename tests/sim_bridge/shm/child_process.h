#pragma once

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

namespace seaway::bridge::shm::test {

/// A forked process that does something, says that it is ready, and waits to be killed.
class ChildProcess {
 public:
  /// `work` runs in the child; what it holds lives until the child is killed.
  template <class Work>
  explicit ChildProcess(Work work) {
    int ends[2];
    if (pipe(ends) != 0) std::abort();
    child_ = fork();
    if (child_ == 0) {
      close(ends[0]);
      const auto held = work();
      const char ready = 1;
      if (write(ends[1], &ready, 1) != 1) _exit(98);
      for (;;) pause();
    }
    close(ends[1]);
    char ready = 0;
    ready_ = read(ends[0], &ready, 1) == 1;
    close(ends[0]);
  }
  ~ChildProcess() { kill(); }
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// False where `work` ended the child.
  bool ready() const { return ready_; }
  /// By SIGKILL.
  void kill() {
    if (child_ <= 0) return;
    ::kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
    child_ = 0;
  }
  pid_t id() const { return child_; }

 private:
  pid_t child_ = 0;
  bool ready_ = false;
};

}  // namespace seaway::bridge::shm::test
