#include "sim_bridge/output/progress.h"

#include <unistd.h>

#include <cstdio>

namespace seaway::bridge {
namespace {

constexpr int barWidth = 30;
constexpr std::chrono::milliseconds patience{1000};
constexpr std::chrono::milliseconds interval{100};

}  // namespace

Progress::Progress(std::string label, std::size_t total)
    : label_(std::move(label)),
      total_(total),
      terminal_(isatty(STDERR_FILENO) == 1),
      next_(Clock::now() + patience) {}

Progress::~Progress() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void Progress::update(std::size_t done) {
  if (!terminal_ || total_ == 0 || Clock::now() < next_) return;
  next_ = Clock::now() + interval;
  shown_ = true;
  const int filled = static_cast<int>(barWidth * done / total_);
  const std::string bar = std::string(static_cast<std::size_t>(filled), '#') +
                          std::string(static_cast<std::size_t>(barWidth - filled), '.');
  std::fprintf(stderr, "\r%s [%s] %zu/%zu", label_.c_str(), bar.c_str(), done, total_);
  std::fflush(stderr);
}

}  // namespace seaway::bridge
