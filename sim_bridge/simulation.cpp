#include "sim_bridge/simulation.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim_bridge/scene/vessel_course.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

// A time counts as reached when it is this part of a step away: frames at 1/3 s and steps of
// 1/30 s meet.
constexpr double reached = 1e-6;

// How much past a replay goes through, s, provided that motions die down to e⁻²⁰ in it.
constexpr double rememberedPast = 600.0;

Vessel makeVessel(const SceneVessel& vessel, const Sea& sea) {
  Vessel made(vessel.model.hull, courseOf(vessel, sea.geodesy));
  made.setCurrent(sea.surface.waves().settings().current);
  return made;
}

}  // namespace

Simulation::Simulation(const Scene& scene, const Sea& sea, EffectLedger* ledger)
    : Simulation(scene, sea, 0, ledger) {}

Simulation Simulation::replayed(
    const Scene& scene, const Sea& sea, double t,
    const std::function<void(std::size_t done, std::size_t all)>& observe) {
  const bool forgets =
      std::all_of(scene.vessels.begin(), scene.vessels.end(), [](const SceneVessel& vessel) {
        const BoxHull& hull = vessel.model.hull;
        return std::min({hull.heaveDamping * hull.heaveFrequency(),
                         hull.rollDamping * hull.rollFrequency(),
                         hull.pitchDamping * hull.pitchFrequency()}) *
                   rememberedPast >
               20.0;
      });
  const double past = rememberedPast + SceneWakes(scene, sea).memory();
  const double from = forgets ? std::max(0.0, t - past) : 0.0;
  const auto firstStep = static_cast<long long>(from / scene.run.step);
  Simulation simulation(scene, sea, firstStep, nullptr);
  const auto all = static_cast<std::size_t>(std::max(0.0, t / scene.run.step - simulation.steps_));
  for (std::size_t done = 1; simulation.nextTime() <= t; ++done) {
    simulation.step();
    if (observe) observe(done, all);
  }
  return simulation.movedTo(t);
}

Simulation::Simulation(const Scene& scene, const Sea& sea, long long firstStep,
                       EffectLedger* ledger)
    : scene_(&scene),
      sea_(&sea),
      wakes_(scene, sea),
      detail_(scene, sea),
      steps_(firstStep),
      time_(static_cast<double>(firstStep) * scene.run.step) {
  std::size_t count = 0;
  for (const SceneVessel& vessel : scene.vessels) {
    vessels_.push_back(makeVessel(vessel, sea));
    count += vessels_.back().sampleCount();
  }
  points_.resize(count);
  samples_.resize(count);
  wakes_.advance(time_, vessels_, ledger);
  sampleAt(time_, ledger);
  forEachVessel([&](Vessel& vessel, const SceneVessel&, std::span<const SurfaceSample> water) {
    if (scene.effects[static_cast<std::size_t>(Effect::vesselMotion)] == EffectSetting::off) {
      vessel.advanceUpright(time_, water);
    } else {
      vessel.settle(time_, water);
    }
  });
}

template <class Action>
void Simulation::forEachVessel(Action action) {
  std::size_t from = 0;
  for (std::size_t i = 0; i < vessels_.size(); ++i) {
    const std::size_t count = vessels_[i].sampleCount();
    action(vessels_[i], scene_->vessels[i],
           std::span(samples_).subspan(from, count));
    from += count;
  }
}

// What lies on the water and ripples it goes over the sea.
void Simulation::disturb(double t, EffectLedger* ledger) {
  detail_.advance(t, ledger);
  disturbed_ = nullptr;
  if (!detail_.detail()) return;
  auto disturbed = std::make_shared<WaterSurface>(wakes_.surface());
  disturbed->setDetail(detail_.detail());
  disturbed_ = std::move(disturbed);
}

void Simulation::sampleAt(double t, EffectLedger* ledger) {
  disturb(t, ledger);
  if (vessels_.empty()) return;
  std::size_t from = 0;
  for (const Vessel& vessel : vessels_) {
    vessel.samplePoints(t, std::span(points_).subspan(from, vessel.sampleCount()));
    from += vessel.sampleCount();
  }
  const WaveField& waves = sea_->surface.waves();
  const bool anyWaves = waves.significantWaveHeight() > 0.0;
  const bool charged = ledger && ledger->decide(Effect::waves, anyWaves,
                                                anyWaves ? "vessels ask for the water under them"
                                                         : "flat water: the field has no octaves");
  if (charged) ledger->holdMemory(Effect::waves, waves.memoryBytes());
  EffectTimer timer(charged ? ledger : nullptr, Effect::waves);
  sampleSurface(t);
  requireAfloat(t);
}

void Simulation::sampleSurface(double t) {
  SampleOptions options{.tolerance = scene_->accuracy.motionTolerance};
  const auto disturbances = wakes_.surface().disturbances();
  if (!disturbances) return surface().sample(points_, t, samples_, options);
  surface().sampleWithoutWakes(points_, t, samples_, options);
  forEachVessel([&](const Vessel& vessel, const SceneVessel&, std::span<SurfaceSample> water) {
    const auto first = static_cast<std::size_t>(water.data() - samples_.data());
    options.excludeVessel = wakes_.ownHandle(static_cast<std::size_t>(&vessel - vessels_.data()));
    disturbances->addTo(std::span(points_).subspan(first, water.size()), t, water, options);
  });
  if (const WaterOutline* outline = sea_->surface.outline()) outline->markDry(points_, samples_);
}

void Simulation::attend(Audience audience, EffectLedger* ledger) {
  wakes_.setAudience(std::move(audience));
  wakes_.advance(time_, vessels_, ledger);
  disturb(time_, ledger);
}

void Simulation::requireAfloat(double t) const {
  if (!sea_->surface.outline()) return;
  std::size_t sample = 0;
  for (std::size_t i = 0; i < vessels_.size(); ++i) {
    for (std::size_t k = 0; k < vessels_[i].sampleCount(); ++k, ++sample) {
      if (!has(samples_[sample].status, SampleStatus::dry)) continue;
      throw InputError(scene_->file.string(), 0,
                       "vessel '" + scene_->vessels[i].name + "' is aground at " +
                           std::to_string(t) + " s: a part of it is outside the sea's outline");
    }
  }
}

double Simulation::nextTime() const { return static_cast<double>(steps_ + 1) * scene_->run.step; }

void Simulation::advanceTo(double t, EffectLedger* ledger) {
  wakes_.advance(t, vessels_, ledger);
  sampleAt(t, ledger);
  bool moves =
      scene_->effects[static_cast<std::size_t>(Effect::vesselMotion)] != EffectSetting::off;
  if (ledger) {
    moves = ledger->decide(Effect::vesselMotion, !vessels_.empty(),
                           vessels_.empty() ? "the scene has no vessel" : "the scene has vessels");
    if (moves)
      ledger->holdMemory(Effect::vesselMotion, points_.size() * sizeof(glm::dvec2) +
                                                   samples_.size() * sizeof(SurfaceSample) +
                                                   vessels_.size() * sizeof(Vessel));
  }
  EffectTimer timer(moves ? ledger : nullptr, Effect::vesselMotion);
  forEachVessel(
      [&](Vessel& vessel, const SceneVessel& description, std::span<const SurfaceSample> water) {
        moves ? vessel.advance(t, water) : vessel.advanceUpright(t, water);
        const VesselPose pose = vessel.pose();
        if (!sea_->geodesy.describe(pose.position).inRange) {
          throw InputError("vessel '" + description.name + "' leaves the scene's range at " +
                           std::to_string(t) + " s");
        }
        if (!std::isfinite(pose.height + pose.roll + pose.pitch)) {
          throw std::runtime_error("the motion of vessel '" + description.name +
                                   "' is not finite at " + std::to_string(t) + " s");
        }
      });
  time_ = t;
}

void Simulation::step(EffectLedger* ledger) {
  advanceTo(nextTime(), ledger);
  ++steps_;
}

void Simulation::stepTo(double t, EffectLedger* ledger) {
  while (nextTime() <= t + reached * scene_->run.step) step(ledger);
}

Simulation Simulation::movedTo(double t, EffectLedger* ledger) const {
  Simulation moved = *this;
  moved.stepTo(t, ledger);
  if (t > moved.time_ + reached * scene_->run.step) moved.advanceTo(t, ledger);
  return moved;
}

}  // namespace seaway::bridge
