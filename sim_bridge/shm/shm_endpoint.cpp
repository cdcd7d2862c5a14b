#include "sim_bridge/shm/shm_endpoint.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "sim_bridge/shm/picture_thread.h"
#include "sim_bridge/shm/seaway_shm_system.h"

namespace seaway::bridge::shm {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double rounds = 0.25;  // s between looks at slots that nobody called for

/// Of hosts that say they found no slot, counted at one look: any host can write that number.
constexpr std::uint32_t mostTurnedAway = 1000;

}  // namespace

/// A segment and all that works on it.
class ShmEndpoint::Serving {
 public:
  explicit Serving(const ShmOptions& options)
      : segment_(options.option, options.name, options.segment), backing_(options.backing) {
    for (std::uint32_t i = 0; i < options.segment.slots; ++i) {
      workers_.push_back(std::make_unique<SlotWorker>(segment_, i, backing_, options.spin));
    }
  }
  ~Serving() {
    countTurnedAway();
    pictures_.reset();
    for (const auto& worker : workers_) worker->stop();
  }

  void open() {
    pictures_.emplace(segment_, workers_, backing_);
    segment_.open();
  }
  /// Sees to hosts that have come; returns after a while.
  void tend() {
    const std::uint32_t seen = seaway_shm_load(&segment_.header().attention);
    for (const auto& worker : workers_) worker->tend();
    countTurnedAway();
    seaway_shm_sleep(&segment_.header().attention, seen, rounds);
  }
  void call() {
    __atomic_add_fetch(&segment_.header().attention, 1, __ATOMIC_SEQ_CST);
    seaway_shm_wake(&segment_.header().attention);
  }
  bool sound() const { return segment_.sound(); }

 private:
  void countTurnedAway() {
    const Clock::time_point now = Clock::now();
    if (now - counted_ < std::chrono::duration<double>(rounds)) return;
    counted_ = now;
    const std::uint32_t said = seaway_shm_load(&segment_.header().turned_away);
    const std::uint32_t grown = said - std::exchange(turnedAway_, said);
    const bool isBack = grown > std::numeric_limits<std::uint32_t>::max() / 2;
    const std::uint32_t more = isBack ? 0 : std::min(grown, mostTurnedAway);
    for (std::uint32_t i = 0; backing_.observer && i < more; ++i) {
      backing_.observer->refused(SEAWAY_SHM_NO_SLOT);
    }
  }

  Segment segment_;
  const Backing& backing_;
  std::vector<std::unique_ptr<SlotWorker>> workers_;
  std::optional<PictureThread> pictures_;
  std::uint32_t turnedAway_ = 0;
  Clock::time_point counted_{};
};

ShmEndpoint::ShmEndpoint(ShmOptions options)
    : options_(std::move(options)), serving_(std::make_unique<Serving>(options_)) {}

ShmEndpoint::~ShmEndpoint() { stop(); }

std::string ShmEndpoint::description() const { return "shared memory " + options_.name; }

void ShmEndpoint::start() {
  serving_->open();
  keeper_ = std::thread([this] { keep(); });
}

void ShmEndpoint::keep() {
  while (!stopping_) {
    if (serving_) serving_->tend();
    if (stopping_ || (serving_ && serving_->sound())) continue;
    try {
      replace();
    } catch (const std::exception& fault) {
      spdlog::error("{}: {}", description(), fault.what());
      std::this_thread::sleep_for(std::chrono::seconds(1));
    }
  }
}

void ShmEndpoint::replace() {
  if (serving_) spdlog::error("{}: a host has spoilt the memory; made anew", description());
  std::unique_ptr<Serving> gone;
  {
    const std::lock_guard lock(replacing_);
    gone = std::move(serving_);
  }
  gone.reset();
  auto made = std::make_unique<Serving>(options_);
  made->open();
  const std::lock_guard lock(replacing_);
  serving_ = std::move(made);
}

void ShmEndpoint::stop() {
  stopping_ = true;
  {
    const std::lock_guard lock(replacing_);
    if (serving_) serving_->call();
  }
  if (keeper_.joinable()) keeper_.join();
  serving_.reset();
}

}  // namespace seaway::bridge::shm
