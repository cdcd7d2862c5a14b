#include "sim_bridge/output/unfinished_files.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstring>

namespace seaway::bridge {
namespace {

// A handler may neither lock nor allocate: names lie in static slots, each with a lock-free state.
enum SlotState : int { vacant, claimed, listed };
struct Slot {
  std::atomic<int> state{vacant};
  char path[4096];
};
static_assert(std::atomic<int>::is_always_lock_free);
std::array<Slot, 64> slots;
constexpr int none = -1;

extern "C" void removeAndExit(int signal) {
  for (Slot& slot : slots) {
    if (slot.state.load() == listed) unlink(slot.path);
  }
  _exit(128 + signal);
}

}  // namespace

UnfinishedFile::UnfinishedFile(const std::filesystem::path& path) : slot_(none) {
  // The program may change folders.
  std::error_code fault;
  const std::string name = std::filesystem::absolute(path, fault).string();
  if (fault || name.size() >= sizeof(Slot::path)) return;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    int expected = vacant;
    if (!slots[i].state.compare_exchange_strong(expected, claimed)) continue;
    std::memcpy(slots[i].path, name.c_str(), name.size() + 1);
    slots[i].state = listed;
    slot_ = static_cast<int>(i);
    return;
  }
}

UnfinishedFile::~UnfinishedFile() {
  if (slot_ != none) slots[static_cast<std::size_t>(slot_)].state = vacant;
}

void removeUnfinishedFilesOnSignals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler == SIG_IGN) continue;
    struct sigaction action {};
    action.sa_handler = removeAndExit;
    sigfillset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
  }
}

}  // namespace seaway::bridge
