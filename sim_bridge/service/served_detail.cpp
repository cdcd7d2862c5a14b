#include <spdlog/spdlog.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "sim_bridge/service/hosted_trails.h"
#include "sim_bridge/service/served_sea.h"

// The part of ServedSea that brings what lies on the water and ripples it.
namespace seaway::bridge {
namespace {

using namespace std::chrono_literals;

/// Nothing that is seen changes more often.
constexpr auto shortestRound = 5ms;
/// How often hulls' poses are taken up where nobody calls.
constexpr auto lookRound = 250ms;

/// Of another time than this many seconds away is told.
constexpr double near = 0.5;

}  // namespace

// Under noting_.
SampleStatus ServedSea::attendDetail(double t, std::span<const WakeListener> listeners,
                                     std::chrono::steady_clock::time_point now) {
  const bool canShow = noted_->detail.canShow() || detailAsked_.anyGuests;
  if (!canShow || !WaveField::serves({}, t)) return SampleStatus::ok;
  DetailAsked& asked = detailAsked_;
  const bool later = asked.follow(t, now);
  if (later && !(asked.brought && asked.brought->covers(t)) && asked.call()) called_.notify_all();
  const bool there =
      asked.brought && t > asked.brought->from - near && t < asked.brought->to + near;
  const auto isNear = [&](const WakeListener& listener) {
    return noted_->detail.mayRipple(listener.position, listener.radius);
  };
  const bool told = !there && std::any_of(listeners.begin(), listeners.end(), isNear);
  return told ? SampleStatus::wakeOutOfTime : SampleStatus::ok;
}

void ServedSea::setDetail(std::shared_ptr<const SurfaceDetail> detail, const ServedScene& of) {
  const std::lock_guard lock(composing_);
  if (composed_.get() != &of || detail_ == detail) return;
  detail_ = std::move(detail);
  publish();
}

/// What the thread has.
struct ServedSea::DetailKeeping {
  std::shared_ptr<const ServedScene> scene;  // outlives what refers to it
  std::optional<SceneDetail> detail;
  std::optional<HostedTrails> trails;
  double time = 0.0;
  std::uint64_t voyage = 0;
};

// Under noting_: strokes of free vessels are left when these have been there.
std::optional<double> ServedSea::detailTime(const FreeVoyage* voyage) const {
  const double t = detailAsked_.time;
  if (t == -std::numeric_limits<double>::infinity()) return std::nullopt;
  if (!noted_->anyFree || t < 0.0 || tooFarToSail_) return t;
  if (!voyage) return std::nullopt;
  return voyage->fault.empty() ? std::min(t, voyage->time) : t;
}

// Works with the lock let go.
void ServedSea::bringDetail(DetailKeeping& keeping, std::unique_lock<std::mutex>& lock) {
  const auto voyage = voyage_;
  const std::optional<double> wanted = detailTime(voyage.get());
  if (!wanted) return;
  const double t = *wanted;
  const auto scene = keeping.scene;
  std::vector<bool> away = hostedVessels();
  for (std::size_t i = 0; voyage && i < away.size(); ++i) {
    away[i] = away[i] || (scene->vessels[i].free && voyage->time < t);
  }
  lock.unlock();
  EffectLedger ledger(scene->scene.effects);
  const std::uint64_t number = voyage ? voyage->number : 0;
  if (!keeping.detail || t < keeping.time || number != keeping.voyage) {
    keeping.detail.emplace(scene->detail);
    keeping.trails->begin(t);
  }
  keeping.time = t;
  keeping.voyage = number;
  SceneDetail& detail = *keeping.detail;
  detail.setAway(std::move(away));
  keeping.trails->leave(t - detail.memory(), t, detail);
  detail.advance(t, voyage ? std::span<const Vessel>(voyage->vessels) : std::span<const Vessel>(),
                 &ledger);
  setDetail(detail.detail(), *scene);
  lock.lock();
  if (noted_ != scene) return;
  detailAsked_.brought = detail.span();
  detailAsked_.effects = ledger.report();
}

void ServedSea::keepDetail(const std::stop_token& stop) {
  DetailKeeping keeping;
  std::unique_lock lock(noting_);
  while (true) {
    const auto isWanted = [&] { return detailAsked_.wanted; };
    if (fleet_.size() == 0) {
      called_.wait(lock, stop, [&] { return detailAsked_.wanted || fleet_.size() > 0; });
    } else {
      called_.wait_for(lock, stop, lookRound, isWanted);
    }
    if (stop.stop_requested()) return;
    if (keeping.scene != noted_) {
      keeping = DetailKeeping();
      keeping.scene = noted_;
      keeping.trails.emplace(noted_);
    }
    keeping.trails->hear(fleet_.takeTrailNews());
    detailAsked_.anyGuests = noted_->trailsAllowed && !keeping.trails->empty();
    if (!std::exchange(detailAsked_.wanted, false)) continue;
    const std::uint64_t upTo = detailAsked_.calls;
    try {
      bringDetail(keeping, lock);
    } catch (const std::exception& fault) {
      if (!lock.owns_lock()) lock.lock();
      spdlog::error("what lies on the water begins anew: {}", fault.what());
      keeping.detail.reset();
    }
    detailAsked_.answers = upTo;
    brought_.notify_all();
    called_.wait_for(lock, stop, shortestRound, [] { return false; });
    if (stop.stop_requested()) return;
  }
}

std::vector<EffectReport> ServedSea::detailEffects() const {
  const std::lock_guard lock(noting_);
  return detailAsked_.effects;
}

}  // namespace seaway::bridge
