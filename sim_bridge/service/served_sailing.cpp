#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "sim_bridge/service/free_sailing.h"
#include "sim_bridge/service/served_sea.h"

// The part of ServedSea that sails the free vessels.
namespace seaway::bridge {
namespace {

using namespace std::chrono_literals;

/// Nothing that is seen changes more often.
constexpr auto shortestRound = 5ms;
/// On a long way, how often others are told how far it has got.
constexpr auto tellRound = 50ms;

/// What is farther ahead is another clock's time, s: 20 minutes' work or so.
constexpr double farthest = 86400.0;

/// How fast a free vessel may be that is not known of lately, m/s, beside twice its scene's speed.
constexpr double drifting = 3.0;

}  // namespace

bool ServedSea::Asked::follow(double t, std::chrono::steady_clock::time_point now) {
  if (t < time && now - heard <= WakeAttention::patience) return false;
  time = t;
  heard = now;
  return true;
}

bool ServedSea::Asked::call() {
  ++calls;
  return !std::exchange(wanted, true);
}

// Under noting_.
bool ServedSea::knowsFree(double t) const { return t < 0.0 || (voyage_ && voyage_->covers(t)); }

// Under noting_. Where it is not known the reach grows by how far it may have got.
glm::dvec2 ServedSea::freePlace(std::size_t vessel, double t, double& reach) const {
  const double known = voyage_ ? std::min(t, voyage_->time) : 0.0;
  const glm::dvec2 current = noted_->sea.surface.waves().settings().current;
  reach += (t - known) *
           (2.0 * std::abs(noted_->scene.vessels[vessel].speed) + drifting + glm::length(current));
  return voyage_ ? voyage_->vessels[vessel].placeAt(known).position
                 : noted_->vessels[vessel].course.at(0.0).position;
}

// Under noting_.
void ServedSea::attendSailing(double t, std::chrono::steady_clock::time_point now) {
  if (!noted_->anyFree || t < 0.0 || !WaveField::serves({}, t)) return;
  if (!sailingAsked_.follow(t, now) || knowsFree(t)) return;
  if (voyage_ && t > voyage_->time && !voyage_->fault.empty()) return;
  const bool tooFar = t - (voyage_ ? voyage_->time : 0.0) > farthest;
  if (tooFar && !tooFarToSail_) {
    spdlog::warn("free vessels do not sail to {} s, which is more than {} s ahead", t, farthest);
  }
  tooFarToSail_ = tooFar;
  if (!tooFar && sailingAsked_.call()) called_.notify_all();
}

// Under noting_: the first hull of each vessel that was there then.
std::vector<PlacedVessel> ServedSea::hostedAt(double t) const {
  std::vector<PlacedVessel> all;
  for (const auto& [number, hull] : fleet_.hulls()) {
    const bool there = hull.isPlaced() && hull.poses.front().time <= t;
    const bool known = std::any_of(all.begin(), all.end(), [&](const PlacedVessel& other) {
      return other.vessel == hull.vessel;
    });
    if (there && !known) all.push_back({hull.vessel, *fleet_.at(number, t)});
  }
  return all;
}

std::shared_ptr<const WaveField> ServedSea::hostWaves() {
  const std::lock_guard lock(composing_);
  return hostWaves_;
}

// Works with the lock let go.
void ServedSea::bringSailing(std::unique_ptr<FreeSailing>& sailing,
                             std::unique_lock<std::mutex>& lock, const std::stop_token& stop) {
  auto told = std::chrono::steady_clock::now();
  const auto tell = [&] {
    lock.unlock();
    auto voyage = sailing->voyage();
    lock.lock();
    if (&sailing->scene() == noted_.get()) voyage_ = std::move(voyage);
    told = std::chrono::steady_clock::now();
  };
  while (!stop.stop_requested()) {
    const auto scene = noted_;
    const double t = sailingAsked_.time;
    if (!scene->anyFree) return void(sailing = nullptr);
    const bool anew = !sailing || &sailing->scene() != scene.get() ||
                      t < sailing->time() - FreeVoyage::remembered ||
                      sailing->hasLost(hostedVessels());
    if (anew) {
      lock.unlock();
      sailing = nullptr;
      sailing = std::make_unique<FreeSailing>(scene);
      lock.lock();
      tell();
      continue;
    }
    if (sailing->hasEnded() || sailing->time() >= t) break;
    const auto hosted = hostedAt(sailing->nextTime());
    lock.unlock();
    if (auto waves = hostWaves(); waves != sailing->waves()) sailing->setWaves(std::move(waves));
    for (const PlacedVessel& each : hosted) sailing->place(each.vessel, each.pose);
    sailing->step();
    lock.lock();
    if (std::chrono::steady_clock::now() - told > tellRound) tell();
  }
  if (sailing) tell();
}

void ServedSea::keepSailing(const std::stop_token& stop) {
  std::unique_ptr<FreeSailing> sailing;
  std::unique_lock lock(noting_);
  while (true) {
    called_.wait(lock, stop, [&] { return sailingAsked_.wanted; });
    if (stop.stop_requested()) return;
    sailingAsked_.wanted = false;
    const std::uint64_t upTo = sailingAsked_.calls;
    try {
      bringSailing(sailing, lock, stop);
    } catch (const std::exception& fault) {
      if (!lock.owns_lock()) lock.lock();
      spdlog::error("free vessels begin anew: {}", fault.what());
      sailing = nullptr;
    }
    sailingAsked_.answers = upTo;
    // Wakes and trails that were called for meanwhile did not know so much.
    ++calls_;
    wanted_ = true;
    detailAsked_.call();
    called_.notify_all();
    brought_.notify_all();
    called_.wait_for(lock, stop, shortestRound, [] { return false; });
    if (stop.stop_requested()) return;
  }
}

}  // namespace seaway::bridge
