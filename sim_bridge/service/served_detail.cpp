#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "sim_bridge/service/served_sea.h"

// The part of ServedSea that brings what lies on the water and ripples it.
namespace seaway::bridge {
namespace {

using namespace std::chrono_literals;

/// Nothing that is seen changes more often.
constexpr auto shortestRound = 5ms;

/// Of another time than this many seconds away is told.
constexpr double near = 0.5;

}  // namespace

// Under noting_.
SampleStatus ServedSea::attendDetail(double t, std::span<const WakeListener> listeners,
                                     std::chrono::steady_clock::time_point now) {
  if (!noted_->detail.canShow() || !WaveField::serves({}, t)) return SampleStatus::ok;
  DetailAsked& asked = detailAsked_;
  if (t >= asked.time || now - asked.heard > WakeAttention::patience) {
    asked.time = t;
    asked.heard = now;
    if (!asked.brought || !asked.brought->covers(t)) {
      ++asked.calls;
      if (!std::exchange(asked.wanted, true)) called_.notify_all();
    }
  }
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

void ServedSea::keepDetail(const std::stop_token& stop) {
  std::shared_ptr<const ServedScene> scene;  // outlives what refers to it
  std::optional<SceneDetail> detail;
  double time = 0.0;
  std::unique_lock lock(noting_);
  while (true) {
    called_.wait(lock, stop, [&] { return detailAsked_.wanted; });
    if (stop.stop_requested()) return;
    detailAsked_.wanted = false;
    const std::uint64_t upTo = detailAsked_.calls;
    const double t = detailAsked_.time;
    std::vector<bool> away = hostedVessels();
    const bool isNew = scene != noted_ || !detail || t < time;
    if (isNew) detail.reset();
    scene = noted_;
    lock.unlock();
    EffectLedger ledger(scene->scene.effects);
    bool done = false;
    try {
      if (isNew) detail.emplace(scene->detail);
      detail->setAway(std::move(away));
      detail->advance(t, &ledger);
      setDetail(detail->detail(), *scene);
      done = true;
    } catch (const std::exception& fault) {
      spdlog::error("what lies on the water begins anew: {}", fault.what());
      detail.reset();
    }
    time = t;
    lock.lock();
    if (done && noted_ == scene) {
      detailAsked_.brought = detail->span();
      detailAsked_.effects = ledger.report();
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
