#include <spdlog/spdlog.h>

#include <chrono>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <utility>

#include "sim_bridge/service/served_sea.h"
#include "sim_bridge/service/wake_keeper.h"

// The part of ServedSea that brings wakes to those who ask.
namespace seaway::bridge {
namespace {

using namespace std::chrono_literals;

/// How often hulls' poses are taken up, and silent listeners forgotten, where nobody calls.
constexpr auto lookRound = 250ms;

/// Where no wake was called for, none will be for this long, s.
constexpr double quiet = 0.5;

double apart(glm::dvec2 a, glm::dvec2 b, double radius) {
  const glm::dvec2 distance = glm::abs(a - b) - radius;
  return std::max(distance.x, distance.y);
}

}  // namespace

// Under noting_: whose wakes a listener calls for.
void ServedSea::findNear(double t, const WakeListener& listener,
                         std::vector<std::uint32_t>& out) const {
  const auto add = [&](glm::dvec2 place, double reach, std::uint32_t handle) {
    if (apart(listener.position, place, listener.radius) < reach) out.push_back(handle);
  };
  bool anyHosted = false;
  for (const auto& [number, hull] : fleet_.hulls()) {
    if (!hull.isPlaced()) continue;
    anyHosted = true;
    const ServedVessel& vessel = noted_->vessels[hull.vessel];
    if (!hull.moved || !vessel.canMakeWaves || listener.vessel == number) continue;
    add(hull.poses.back().pose.position, vessel.reach, number);
  }
  const std::vector<bool> hosted = anyHosted ? hostedVessels() : std::vector<bool>();
  for (std::size_t i = 0; i < noted_->vessels.size(); ++i) {
    const ServedVessel& vessel = noted_->vessels[i];
    if (!vessel.makesWaves || (anyHosted && hosted[i])) continue;
    double reach = vessel.reach;
    const bool free = vessel.free && t >= 0.0;
    const glm::dvec2 place = free ? freePlace(i, t, reach) : vessel.course.at(t).position;
    add(place, reach, ServedScene::handleOf(i));
  }
}

// Under noting_.
bool ServedSea::isBrought(double t, std::uint32_t wake) const {
  constexpr std::uint32_t first = ServedScene::handleOf(0);
  if (wake >= first && noted_->vessels[wake - first].free && !knowsFree(t)) return false;
  return t >= coveredFrom_ && t <= coveredTo_ && broughtWakes_.contains(wake);
}

SampleStatus ServedSea::attend(double t, std::span<const WakeListener> listeners) {
  if (!std::isfinite(t)) return SampleStatus::ok;
  lastTime_.store(t, std::memory_order_relaxed);
  const auto now = WakeAttention::Clock::now();
  const std::lock_guard lock(noting_);
  attendSailing(t, now);
  const SampleStatus detail = attendDetail(t, listeners, now);
  if (!noted_->wakesAllowed) return detail;
  bool brought = true;
  for (const WakeListener& listener : listeners) {
    if (!WaveField::serves(listener.position, t)) continue;
    near_.clear();
    findNear(t, listener, near_);
    if (near_.empty()) continue;
    attention_.note(t, listener, now);
    for (const std::uint32_t wake : near_) brought = brought && isBrought(t, wake);
  }
  if (brought) return detail;
  ++calls_;
  if (!std::exchange(wanted_, true)) called_.notify_all();
  return SampleStatus::wakeOutOfTime;
}

bool ServedSea::awaitWakes(double seconds) const {
  std::unique_lock lock(noting_);
  const auto end = std::chrono::steady_clock::now() +
                   std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                       std::chrono::duration<double>(seconds));
  const std::uint64_t voyages = sailingAsked_.calls;
  if (!brought_.wait_until(lock, end, [&] { return sailingAsked_.answers >= voyages; })) {
    return false;
  }
  // Those that the voyage has called for among them.
  const std::uint64_t wakes = calls_, details = detailAsked_.calls;
  return brought_.wait_until(lock, end,
                             [&] { return answers_ >= wakes && detailAsked_.answers >= details; });
}

std::optional<std::pair<double, double>> ServedSea::wakeSpan() const {
  const auto state = surface()->disturbances();
  if (!state) return std::nullopt;
  return std::pair(state->start(), state->end());
}

ServedSea::WakeFigures ServedSea::wakeFigures() const {
  const std::lock_guard lock(noting_);
  return figures_;
}

void ServedSea::keepWakes(const std::stop_token& stop) {
  std::unique_ptr<WakeKeeper> keeper;
  std::unique_lock lock(noting_);
  while (!stop.stop_requested()) {
    const auto isWanted = [&] { return wanted_; };
    if (fleet_.size() == 0 && figures_.running == 0) {
      called_.wait(lock, stop, [&] { return wanted_ || fleet_.size() > 0; });
    } else {
      called_.wait_for(lock, stop, lookRound, isWanted);
    }
    if (stop.stop_requested()) return;
    wanted_ = false;
    const std::uint64_t upTo = calls_;
    try {
      bringWakes(keeper, lock);
    } catch (const std::exception& fault) {
      if (!lock.owns_lock()) lock.lock();
      spdlog::error("wakes begin anew: {}", fault.what());
      keeper = nullptr;
      fleet_.retell();
    }
    answers_ = upTo;
    brought_.notify_all();
  }
}

// Works with the lock let go.
void ServedSea::bringWakes(std::unique_ptr<WakeKeeper>& keeper,
                           std::unique_lock<std::mutex>& lock) {
  const WakeAttention::Call call = attention_.call(WakeAttention::Clock::now());
  const auto scene = noted_;
  if (!keeper && call.listeners.empty()) return void(fleet_.takeNews());
  const bool isNew = !keeper || &keeper->scene() != scene.get();
  if (isNew) fleet_.retell();
  const auto news = fleet_.takeNews();
  const auto voyage = voyage_;
  const std::vector<bool> hosted = hostedVessels();
  near_.clear();
  for (const WakeListener& listener : call.listeners) findNear(call.time, listener, near_);
  const std::set<std::uint32_t> called(near_.begin(), near_.end());
  lock.unlock();
  if (isNew) {
    keeper = std::make_unique<WakeKeeper>(scene);
    setFeed(keeper->feed(), *scene);
  }
  keeper->hear(news);
  call.listeners.empty() ? keeper->rest()
                         : keeper->advance(call.time, call.listeners, hosted, voyage.get());
  const auto state = keeper->latest();
  const WakeFigures figures{keeper->running(), keeper->running() ? keeper->memoryBytes() : 0};
  lock.lock();
  figures_ = figures;
  broughtWakes_ = called;
  coveredFrom_ = state ? state->start() : call.time - quiet;
  coveredTo_ = state ? state->end() : call.time + quiet;
  if (call.listeners.empty()) coveredFrom_ = 1.0, coveredTo_ = 0.0;
}

}  // namespace seaway::bridge
