#include "surface/disturbance/wake_system.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

#include "surface/input_error.h"
#include "surface/state_archive.h"

namespace seaway {
namespace {

/// A wake that nobody asks for is kept for this long, s: rebuilding takes longer than keeping.
constexpr double patience = 5.0;

/// Where more are asked for than may run, one that runs counts as nearer by this part of its reach:
/// who hovers between two would see them come and go, and pay for each anew.
constexpr double constancy = 0.1;

/// ∫∫ η² below which a hull's waves are gone, m⁴: a millimetre over 1000 m², and what the border
/// keeps in motion by nibbling at the hollow under the hull, some 1e-4 of its ∫∫ H².
double goneEnergy(const HullFootprint& hull) {
  const glm::dvec2 extent = hull.upper() - hull.lower();
  const double hollow = hull.volume() * hull.volume() / std::max(extent.x * extent.y, 1e-6);
  return 1e-3 + 2e-4 * hollow;
}

}  // namespace

struct WakeSystem::Vessel {
  Vessel(std::uint32_t number, const HullFootprint& shape, std::vector<WakeLevel> windows)
      : handle(number),
        hull(shape),
        levels(std::move(windows)),
        log(levels.front().step, memory() + 2.0 * patience) {}

  double memory() const {
    double longest = 0.0;
    for (const WakeLevel& level : levels) longest = std::max(longest, memoryOf(level));
    return longest;
  }
  double reach() const { return reachOf(levels); }

  std::uint32_t handle;
  HullFootprint hull;
  std::vector<WakeLevel> levels;
  PoseLog log;
  std::vector<LevelWake> wakes;                                  // empty: not running
  double lastCalled = 0.0;                                       // s
  double quietSince = -std::numeric_limits<double>::infinity();  // its waves had gone by then, s
  double nextCheck = 0.0;                                        // for waves that have gone, s
  bool removed = false;
};

WakeSystem::WakeSystem(const WakeSystemSettings& settings) : settings_(settings) {
  for (const WakeLevel& level : settings_.cascade) {
    check(level.window);
    const double ratio = level.step / settings_.cascade.front().step;
    if (!(level.step > 0.0) || std::abs(ratio - std::round(ratio)) > 1e-9) {
      throw InputError("the steps of a wake's windows must be multiples of the first");
    }
  }
}

WakeSystem::WakeSystem(const WakeSystem& other)
    : settings_(other.settings_),
      tables_(other.tables_),
      nextHandle_(other.nextHandle_),
      dropped_(other.dropped_) {
  for (const auto& vessel : other.vessels_) vessels_.push_back(std::make_unique<Vessel>(*vessel));
  published_->publish(other.latest());
}

WakeSystem::~WakeSystem() = default;

std::uint32_t WakeSystem::addVessel(const HullFootprint& hull) {
  const std::uint32_t handle = nextHandle_;
  addVessel(handle, hull);
  return handle;
}

void WakeSystem::addVessel(std::uint32_t handle, const HullFootprint& hull) {
  const bool taken = std::any_of(vessels_.begin(), vessels_.end(), [&](const auto& known) {
    return known->handle == handle && !known->removed;
  });
  if (handle == 0 || taken) {
    throw InputError("a vessel cannot have the handle " + std::to_string(handle));
  }
  const glm::dvec2 extent = hull.upper() - hull.lower();
  auto levels = settings_.cascade.empty() ? cascadeOf(std::max(extent.x, extent.y), settings_.depth,
                                                      settings_.cell, settings_.window)
                                          : settings_.cascade;
  for (WakeLevel& level : levels) level.window.depth = settings_.depth;
  vessels_.push_back(std::make_unique<Vessel>(handle, hull, std::move(levels)));
  nextHandle_ = std::max(nextHandle_, handle + 1);
}

void WakeSystem::removeVessel(std::uint32_t vessel) {
  for (const auto& known : vessels_) {
    if (known->handle == vessel) known->removed = true;
  }
}

void WakeSystem::dropVessel(std::uint32_t vessel) {
  std::erase_if(vessels_, [&](const auto& known) {
    if (known->handle != vessel) return false;
    dropped_ = dropped_ || !known->wakes.empty();
    return true;
  });
}

PoseAnswer WakeSystem::record(std::uint32_t vessel, const WakePose& pose) {
  // The solver's frame drifts with the water.
  return vesselOf(vessel).log.record(
      {pose.time, {pose.position - settings_.current * pose.time, pose.heading, pose.immersion}});
}

WakeSystem::Vessel& WakeSystem::vesselOf(std::uint32_t handle) const {
  const auto found = std::find_if(vessels_.begin(), vessels_.end(), [&](const auto& known) {
    return known->handle == handle && !known->removed;
  });
  if (found == vessels_.end()) {
    throw InputError("no vessel has the handle " + std::to_string(handle));
  }
  return **found;
}

double WakeSystem::memory(std::uint32_t vessel) const { return vesselOf(vessel).memory(); }

std::vector<WakeSystem::Call> WakeSystem::calls(double t, std::span<const WakeListener> listeners) {
  std::vector<Call> called;
  for (const auto& vessel : vessels_) {
    if (vessel->log.empty() || vessel->log.earliest() > t) continue;
    const double known = std::min(t, vessel->log.latest());
    const double since = std::max(known - vessel->memory(), vessel->quietSince);
    if (vessel->wakes.empty() && !vessel->log.movedBetween(since, known)) continue;
    const glm::dvec2 place =
        vessel->log.placeOrFirst(known, known).position + settings_.current * t;
    double nearest = std::numeric_limits<double>::infinity();
    for (const WakeListener& listener : listeners) {
      if (listener.vessel == vessel->handle) continue;
      const glm::dvec2 apart = glm::abs(listener.position - place) - listener.radius;
      nearest = std::min(nearest, std::max(apart.x, apart.y));
    }
    if (nearest < vessel->reach()) {
      vessel->lastCalled = t;
      const bool runs = !vessel->wakes.empty();
      called.push_back({vessel.get(), nearest - (runs ? constancy * vessel->reach() : 0.0)});
    } else if (!vessel->wakes.empty() && std::abs(t - vessel->lastCalled) < patience) {
      called.push_back({vessel.get(), vessel->reach()});
    }
  }
  std::stable_sort(called.begin(), called.end(),
                   [](const Call& a, const Call& b) { return a.distance < b.distance; });
  return called;
}

std::shared_ptr<const WakeTables> WakeSystem::tablesFor(const WakeLevel& level) {
  std::erase_if(tables_, [](const auto& tables) { return tables.use_count() == 1; });
  for (const auto& tables : tables_) {
    if (tables->settings == level.window && tables->dt == level.step) return tables;
  }
  tables_.push_back(std::make_shared<const WakeTables>(level.window, level.step));
  return tables_.back();
}

void WakeSystem::open(Vessel& vessel) {
  double largest = 0.0;
  for (const WakeLevel& level : vessel.levels) {
    largest = std::max(largest, WakeWindow::largestWaveNumber(level.window));
  }
  const auto hull = std::make_shared<const FootprintTable>(vessel.hull, settings_.depth, largest);
  for (const WakeLevel& level : vessel.levels) {
    vessel.wakes.emplace_back(level, tablesFor(level), hull, settings_.orbitalVelocity);
  }
}

bool WakeSystem::advance(Vessel& vessel, double t) {
  if (vessel.removed && vessel.log.latest() < t) {
    // Lifted out: what waves there are run free.
    VesselPose last{t, vessel.log.placeOrFirst(t, vessel.log.latest())};
    last.place.immersion = 0.0;
    vessel.log.record(last);
  }
  if (vessel.wakes.empty()) open(vessel);
  bool changed = false;
  for (LevelWake& wake : vessel.wakes) changed = wake.advance(vessel.log, t) || changed;
  const double known = std::min(t, vessel.log.latest());
  if (t < vessel.nextCheck && t > vessel.nextCheck - 2.0) return changed;
  vessel.nextCheck = t + 1.0;
  if (vessel.log.movedBetween(known - 1.0, known)) return changed;
  double energy = 0.0;
  for (LevelWake& wake : vessel.wakes) energy += wake.waveEnergy(vessel.log);
  if (energy > goneEnergy(vessel.hull)) return changed;
  vessel.wakes.clear();
  vessel.quietSince = known;
  return true;
}

void WakeSystem::publish() {
  std::vector<VesselWaves> all;
  for (const auto& vessel : vessels_) {
    if (vessel->wakes.empty()) continue;
    VesselWaves waves{vessel->handle, {}, 0.0};
    for (const LevelWake& wake : vessel->wakes) {
      waves.sheets.push_back(wake.sheet());
      // The shortest waves that carry energy: motion below them is rather under- than overstated.
      waves.meanWaveNumber = std::max(waves.meanWaveNumber, wake.meanWaveNumber());
    }
    all.push_back(std::move(waves));
  }
  if (all.empty()) {
    if (published_->latest()) published_->publish(nullptr);
    return;
  }
  published_->publish(std::make_shared<const DisturbanceState>(
      std::move(all), DisturbanceState::Water{settings_.current, settings_.depth}));
}

void WakeSystem::advance(double t, std::span<const WakeListener> listeners, EffectLedger* ledger) {
  if (!std::isfinite(t)) return;
  std::vector<Call> called = calls(t, listeners);
  std::string reason = std::to_string(called.size()) + " wakes within reach of " +
                       std::to_string(listeners.size()) + " listeners";
  if (called.empty()) reason = "no vessel under way is near anyone else, camera or query";
  if (called.size() > settings_.mostWakes) {
    reason += ", the nearest " + std::to_string(settings_.mostWakes) + " run";
    called.resize(settings_.mostWakes);
  }
  const bool runs = !ledger || ledger->decide(Effect::wake, !called.empty(), reason);
  if (!runs) called.clear();
  EffectTimer timer(runs ? ledger : nullptr, Effect::wake);
  bool changed = std::exchange(dropped_, false);
  for (const auto& vessel : vessels_) {
    const bool kept = std::any_of(called.begin(), called.end(),
                                  [&](const Call& call) { return call.vessel == vessel.get(); });
    if (kept || vessel->wakes.empty()) continue;
    vessel->wakes.clear();
    changed = true;
  }
  for (const Call& call : called) changed = advance(*call.vessel, t) || changed;
  std::erase_if(vessels_,
                [&](const auto& vessel) { return vessel->removed && vessel->wakes.empty(); });
  if (changed) publish();
  if (runs && ledger) ledger->holdMemory(Effect::wake, memoryBytes());
}

std::size_t WakeSystem::running() const {
  return static_cast<std::size_t>(std::count_if(
      vessels_.begin(), vessels_.end(), [](const auto& vessel) { return !vessel->wakes.empty(); }));
}

std::size_t WakeSystem::memoryBytes() const {
  std::size_t bytes = 0;
  for (const auto& tables : tables_) bytes += tables->memoryBytes();
  for (const auto& vessel : vessels_) {
    bytes += vessel->log.memoryBytes();
    for (const LevelWake& wake : vessel->wakes) bytes += wake.memoryBytes();
  }
  return bytes;
}

template <class Archive>
void WakeSystem::archive(Archive& archive) {
  std::uint64_t count = vessels_.size();
  archivePlain(archive, count);
  if (count != vessels_.size()) {
    throw InputError("a checkpoint is of a scene with other vessels");
  }
  for (const auto& vessel : vessels_) {
    archivePlain(archive, vessel->handle);
    vessel->log.archive(archive);
    archivePlain(archive, vessel->lastCalled);
    archivePlain(archive, vessel->quietSince);
    archivePlain(archive, vessel->nextCheck);
    archivePlain(archive, vessel->removed);
    bool runs = !vessel->wakes.empty();
    archivePlain(archive, runs);
    if (runs && vessel->wakes.empty()) open(*vessel);
    for (LevelWake& wake : vessel->wakes) wake.archive(archive);
  }
  archivePlain(archive, nextHandle_);
  if constexpr (isReader<Archive>) publish();
}

template void WakeSystem::archive(StateWriter&);
template void WakeSystem::archive(StateReader&);

}  // namespace seaway
