#pragma once

#include <sys/eventfd.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <functional>

namespace seaway::bench {

/// The floor under any service: a process that works when it is woken and wakes who asked, by the
/// barest means that the system has. Whatever is late here, the machine is.
class EvaluationEcho {
 public:
  /// `make` makes the work, in the other process. To be made before this one has threads.
  explicit EvaluationEcho(const std::function<std::function<void()>()>& make) {
    if (asked_ < 0 || answered_ < 0) std::abort();
    child_ = fork();
    if (child_ != 0) return;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const std::function<void()> work = make();
    for (;;) {
      take(asked_);
      work();
      give(answered_);
    }
  }
  ~EvaluationEcho() {
    kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
    close(asked_);
    close(answered_);
  }
  EvaluationEcho(const EvaluationEcho&) = delete;
  EvaluationEcho& operator=(const EvaluationEcho&) = delete;

  void ask() {
    give(asked_);
    take(answered_);
  }
  pid_t id() const { return child_; }

 private:
  static void give(int event) {
    const std::uint64_t one = 1;
    if (write(event, &one, sizeof one) != sizeof one) std::abort();
  }
  static void take(int event) {
    std::uint64_t count = 0;
    if (read(event, &count, sizeof count) != sizeof count) std::abort();
  }

  int asked_ = eventfd(0, EFD_CLOEXEC), answered_ = eventfd(0, EFD_CLOEXEC);
  pid_t child_ = 0;
};

}  // namespace seaway::bench
