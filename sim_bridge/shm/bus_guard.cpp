#include "sim_bridge/shm/bus_guard.h"

#include <signal.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <mutex>
#include <stdexcept>

namespace seaway::bridge::shm {

/// The handler reads these without a lock: `size` 0 is an unused one.
struct BusGuard::Range {
  std::atomic<bool> taken{false};
  std::atomic<std::uintptr_t> begin{0};
  std::atomic<std::size_t> size{0};
  std::atomic<bool> broken{false};
};

namespace {

std::array<BusGuard::Range, 16> ranges;
struct sigaction previous;

bool replaced(std::uintptr_t address) {
  for (BusGuard::Range& range : ranges) {
    const std::uintptr_t begin = range.begin.load();
    const std::size_t size = range.size.load();
    if (size == 0 || address < begin || address >= begin + size) continue;
    range.broken = true;
    // The call itself: nothing of the library's own is safe in a handler.
    const long mapped = syscall(SYS_mmap, begin, size, PROT_READ | PROT_WRITE,
                                MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1, 0L);
    return mapped != -1;
  }
  return false;
}

void onBusError(int signal, siginfo_t* info, void* context) {
  if (replaced(reinterpret_cast<std::uintptr_t>(info->si_addr))) return;
  if ((previous.sa_flags & SA_SIGINFO) != 0 && previous.sa_sigaction) {
    return previous.sa_sigaction(signal, info, context);
  }
  // The access is tried again on return, and ends the process as it would have.
  sigaction(SIGBUS, &previous, nullptr);
}

void installOnce() {
  static std::once_flag once;
  std::call_once(once, [] {
    struct sigaction action {};
    action.sa_sigaction = onBusError;
    action.sa_flags = SA_SIGINFO;
    sigemptyset(&action.sa_mask);
    sigaction(SIGBUS, &action, &previous);
  });
}

}  // namespace

BusGuard::BusGuard(void* memory, std::size_t size) : range_(nullptr) {
  installOnce();
  for (Range& range : ranges) {
    if (range.taken.exchange(true)) continue;
    range.broken = false;
    range.begin = reinterpret_cast<std::uintptr_t>(memory);
    range.size = size;
    range_ = &range;
    return;
  }
  throw std::runtime_error("too many shared memories at once");
}

BusGuard::~BusGuard() {
  range_->size = 0;
  range_->taken = false;
}

bool BusGuard::broken() const noexcept { return range_->broken; }

}  // namespace seaway::bridge::shm
