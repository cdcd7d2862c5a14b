#include "sim_bridge/capi/coupled_sea.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

std::uint64_t nextNumber() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

std::unique_ptr<Simulation> simulationAt(double t, const Scene& scene, const Sea& sea) {
  return std::make_unique<Simulation>(t > 0.0 ? Simulation::replayed(scene, sea, t)
                                              : Simulation(scene, sea));
}

/// The surface as it is, whatever its wakes come to later.
WaterSurface frozen(WaterSurface surface) {
  std::shared_ptr<Published<DisturbanceState>> feed;
  if (auto state = surface.disturbances()) {
    feed = std::make_shared<Published<DisturbanceState>>();
    feed->publish(std::move(state));
  }
  surface.setDisturbances(std::move(feed));
  return surface;
}

std::string nameOf(const render::TechniqueChoice& choice) {
  return choice.backend + " " + std::to_string(choice.grid.x) + "x" + std::to_string(choice.grid.y);
}

}  // namespace

CoupledSea::CoupledSea(Scene scene, double startTime)
    : number_(nextNumber()),
      scene_(std::move(scene)),
      sea_(buildSea(scene_)),
      simulation_(simulationAt(startTime, scene_, sea_)),
      view_(scene_) {
  publish();
}

void CoupledSea::publish() {
  auto moment =
      std::make_shared<Moment>(Moment{simulation_->time(), frozen(simulation_->surface()), {}, {}});
  for (std::size_t i = 0; i < scene_.vessels.size(); ++i) {
    moment->poses.push_back(simulation_->vessels()[i].pose());
    moment->ownWakes.push_back(simulation_->ownWake(i));
  }
  moment_.publish(std::move(moment));
}

void CoupledSea::requireAlive() const {
  if (!fault_.empty()) throw InputError(fault_ + " (the sea stands still until it is restarted)");
}

template <class Change>
void CoupledSea::change(const Change& change) {
  const std::lock_guard lock(changing_);
  requireAlive();
  try {
    // A thread that waits for others here must not take up a task of the host's that waits for the
    // lock it holds.
    tbb::this_task_arena::isolate(change);
  } catch (const std::exception& fault) {
    fault_ = fault.what();
    throw;
  }
  publish();
}

void CoupledSea::stepTo(double t) {
  change([&] {
    EffectLedger ledger(scene_.effects);
    const double before = simulation_->time();
    simulation_->stepTo(t, &ledger);
    const double steps = std::round((simulation_->time() - before) / scene_.run.step);
    if (steps < 1.0) return;
    stepEffects_ = ledger.report();
    for (EffectReport& effect : stepEffects_) effect.costMicroseconds /= steps;
  });
}

void CoupledSea::step() {
  change([&] {
    EffectLedger ledger(scene_.effects);
    simulation_->step(&ledger);
    stepEffects_ = ledger.report();
  });
}

void CoupledSea::restart(double t) {
  const std::lock_guard lock(changing_);
  auto anew = tbb::this_task_arena::isolate([&] { return simulationAt(t, scene_, sea_); });
  if (!audience_.cameras.empty() || !audience_.places.empty()) anew->attend(audience_);
  simulation_ = std::move(anew);
  fault_.clear();
  publish();
}

void CoupledSea::listen(std::vector<WakeListener> places) {
  change([&] {
    audience_.places = std::move(places);
    simulation_->attend(audience_);
  });
}

bool CoupledSea::place(std::size_t vessel, double t, const VesselPose& pose) {
  bool placed = false;
  change([&] { placed = simulation_->place(vessel, t, pose); });
  return placed;
}

void CoupledSea::drawFrame(const SceneCamera& camera, glm::ivec2 size,
                           const render::TechniqueChoice& choice) {
  requireAlive();
  // A camera that has drawn once hears of wakes from then on, at its last place.
  auto known = std::find_if(audience_.cameras.begin(), audience_.cameras.end(),
                            [&](const SceneCamera& other) { return other.name == camera.name; });
  if (known == audience_.cameras.end()) {
    audience_.cameras.push_back(camera);
    simulation_->attend(audience_);
    publish();
  } else if (camera.name.empty()) {
    *known = camera;
    simulation_->attend(audience_);
    publish();
  }
  if (!technique_ || drawnBy_ != nameOf(choice)) {
    technique_ = nullptr;
    technique_ = render::makeTechnique(choice);
    drawnBy_ = nameOf(choice);
  }
  EffectLedger ledger(scene_.effects);
  const render::View view = view_.view(*simulation_, camera, size, ledger);
  tbb::this_task_arena::isolate([&] { technique_->drawInto(view, frame_); });
  frameEffects_ = ledger.report();
}

}  // namespace seaway::bridge
