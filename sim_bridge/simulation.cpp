#include "sim_bridge/simulation.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim_bridge/grounding.h"
#include "sim_bridge/scene/vessel_course.h"
#include "sim_bridge/scene/vessel_launch.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

// A time counts as reached when it is this part of a step away: frames at 1/3 s and steps of
// 1/30 s meet.
constexpr double reached = 1e-6;

// How much past a replay goes through, s, provided that motions die down to e⁻²⁰ in it.
constexpr double rememberedPast = 600.0;

/// Free vessels move on in the wakes of one time no farther than this, s: wakes' own step.
constexpr double longestFreeStep = 0.1;

bool isOff(const Scene& scene, Effect effect) {
  return scene.effects[static_cast<std::size_t>(effect)] == EffectSetting::off;
}

}  // namespace

Simulation::Simulation(const Scene& scene, const Sea& sea, EffectLedger* ledger)
    : Simulation(scene, sea, 0, ledger) {}

Simulation Simulation::replayed(
    const Scene& scene, const Sea& sea, double t,
    const std::function<void(std::size_t done, std::size_t all)>& observe) {
  const bool forgets =
      !anySailsFreely(scene) &&
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
  for (const SceneVessel& vessel : scene.vessels) vessels_.push_back(launch(scene, vessel, sea));
  countWater();
  wakes_.advance(time_, vessels_, ledger);
  sampleAt(time_, ledger);
  forEachPrescribed(
      [&](PrescribedVessel& vessel, std::size_t, std::span<const SurfaceSample> water) {
        if (isOff(scene, Effect::vesselMotion)) {
          vessel.advanceUpright(time_, water);
        } else {
          vessel.settle(time_, water);
        }
      });
  for (std::size_t i = 0; i < vessels_.size(); ++i) {
    if (FreeVessel* vessel = vessels_[i].free()) vessel->settle(surface(), wakes_.ownHandle(i));
  }
}

void Simulation::countWater() {
  std::size_t count = 0;
  freeCount_ = 0;
  for (const Vessel& vessel : vessels_) {
    if (const PrescribedVessel* prescribed = vessel.prescribed())
      count += prescribed->sampleCount();
    if (vessel.free()) ++freeCount_;
  }
  points_.resize(count);
  samples_.resize(count);
}

bool Simulation::place(std::size_t index, double t, const VesselPose& pose) {
  Vessel& vessel = vessels_[index];
  if (HostedVessel* known = vessel.hosted()) return known->place(t, pose);
  const SceneVessel& description = scene_->vessels[index];
  VesselTrack past(courseOf(description, sea_->geodesy));
  const double step = VesselTrack::interval;
  const double first = std::floor(std::max(0.0, time_ - VesselTrack::horizon) / step);
  for (double n = first; n * step < time_ - reached * step; n += 1.0) {
    past.record(n * step, vessel.placeAt(n * step));
  }
  past.record(time_, vessel.placeAt(time_));
  HostedVessel hosted(description.model.hull, time_, vessel.pose(), std::move(past));
  if (!hosted.place(t, pose)) return false;
  hosted.readWater(surface(), wakes_.ownHandle(index));
  vessel = Vessel(std::move(hosted));
  countWater();
  return true;
}

void Simulation::setSea(const Sea& sea) {
  sea_ = &sea;
  wakes_.setSea(sea);
  detail_.setSea(sea);
  showDetail();
}

template <class Action>
void Simulation::forEachPrescribed(Action action) {
  std::size_t from = 0;
  for (std::size_t i = 0; i < vessels_.size(); ++i) {
    PrescribedVessel* vessel = vessels_[i].prescribed();
    if (!vessel) continue;
    action(*vessel, i, std::span(samples_).subspan(from, vessel->sampleCount()));
    from += vessel->sampleCount();
  }
}

// What lies on the water and ripples it goes over the sea.
void Simulation::disturb(double t, EffectLedger* ledger) {
  detail_.advance(t, vessels_, ledger);
  showDetail();
}

void Simulation::showDetail() {
  disturbed_ = nullptr;
  if (!detail_.detail()) return;
  auto disturbed = std::make_shared<WaterSurface>(wakes_.surface());
  disturbed->setDetail(detail_.detail());
  disturbed_ = std::move(disturbed);
}

void Simulation::sampleAt(double t, EffectLedger* ledger) {
  disturb(t, ledger);
  if (vessels_.empty()) return;
  forEachPrescribed([&](const PrescribedVessel& vessel, std::size_t, std::span<SurfaceSample> own) {
    const auto from = static_cast<std::size_t>(own.data() - samples_.data());
    vessel.samplePoints(t, std::span(points_).subspan(from, own.size()));
  });
  const WaveField& waves = sea_->surface.waves();
  const bool anyWaves = waves.significantWaveHeight() > 0.0;
  const bool charged = ledger && ledger->decide(Effect::waves, anyWaves,
                                                anyWaves ? "vessels ask for the water under them"
                                                         : "flat water: the field has no octaves");
  if (charged) ledger->holdMemory(Effect::waves, waves.memoryBytes());
  if (points_.empty()) return;  // free vessels take samples of their own
  EffectTimer timer(charged ? ledger : nullptr, Effect::waves);
  sampleSurface(t);
  requireAfloat(t);
}

void Simulation::sampleSurface(double t) {
  SampleOptions options{.tolerance = scene_->accuracy.motionTolerance};
  const auto disturbances = wakes_.surface().disturbances();
  if (!disturbances) return surface().sample(points_, t, samples_, options);
  surface().sampleWithoutWakes(points_, t, samples_, options);
  forEachPrescribed([&](const PrescribedVessel&, std::size_t i, std::span<SurfaceSample> water) {
    const auto first = static_cast<std::size_t>(water.data() - samples_.data());
    options.excludeVessel = wakes_.ownHandle(i);
    disturbances->addTo(std::span(points_).subspan(first, water.size()), t, water, options);
  });
  if (const WaterOutline* outline = sea_->surface.outline()) outline->markDry(points_, samples_);
  if (const TerrainMap* terrain = sea_->surface.terrain()) terrain->markDry(points_, samples_);
}

void Simulation::attend(Audience audience, EffectLedger* ledger) {
  wakes_.setAudience(std::move(audience));
  wakes_.advance(time_, vessels_, ledger);
  disturb(time_, ledger);
}

void Simulation::requireAfloat(double t) {
  const TerrainMap* terrain = sea_->surface.terrain();
  if (!sea_->surface.outline() && !terrain) return;
  forEachPrescribed(
      [&](const PrescribedVessel& vessel, std::size_t i, std::span<const SurfaceSample> water) {
        const bool dry = std::any_of(water.begin(), water.end(), [](const SurfaceSample& sample) {
          return has(sample.status, SampleStatus::dry);
        });
        const auto from = static_cast<std::size_t>(water.data() - samples_.data());
        const auto places = std::span(points_).subspan(from, water.size());
        if (terrain) {
          requireClearOfGround(*scene_, scene_->vessels[i].name, t, vessel.hull().draft(), *terrain,
                               places, water);
        }
        if (dry) throw aground(*scene_, scene_->vessels[i].name, t);
      });
}

double Simulation::nextTime() const { return static_cast<double>(steps_ + 1) * scene_->run.step; }

void Simulation::requireSound(const Vessel& vessel, const SceneVessel& description,
                              double t) const {
  const VesselPose pose = vessel.pose();
  if (!std::isfinite(pose.height + pose.roll + pose.pitch)) {
    throw std::runtime_error("the motion of vessel '" + description.name + "' is not finite at " +
                             std::to_string(t) + " s");
  }
  if (!sea_->geodesy.describe(pose.position).inRange) {
    throw InputError("vessel '" + description.name + "' leaves the scene's range at " +
                     std::to_string(t) + " s");
  }
}

void Simulation::moveFree(double t, EffectLedger* ledger) {
  const bool runs = ledger ? ledger->decide(Effect::hullLoads, freeCount_ > 0,
                                            freeCount_ > 0 ? "a vessel's motion is free"
                                                           : "no vessel's motion is free")
                           : freeCount_ > 0;
  if (!runs || freeCount_ == 0) return;
  std::size_t bytes = 0;
  EffectTimer timer(ledger, Effect::hullLoads);
  for (std::size_t i = 0; i < vessels_.size(); ++i) {
    FreeVessel* vessel = vessels_[i].free();
    if (!vessel) continue;
    vessel->advance(t, surface(), wakes_.ownHandle(i));
    requireFreeToMove(*scene_, scene_->vessels[i].name, *vessel);
    requireSound(vessels_[i], scene_->vessels[i], t);
    bytes += vessel->memoryBytes();
  }
  if (ledger) ledger->holdMemory(Effect::hullLoads, bytes);
}

void Simulation::movePrescribed(double t, EffectLedger* ledger) {
  const bool any = !points_.empty();
  bool moves = !isOff(*scene_, Effect::vesselMotion);
  if (ledger) {
    moves = ledger->decide(Effect::vesselMotion, any,
                           any ? "the scene has vessels on prescribed courses"
                               : "the scene has no vessel on a prescribed course");
    if (moves)
      ledger->holdMemory(Effect::vesselMotion, points_.size() * sizeof(glm::dvec2) +
                                                   samples_.size() * sizeof(SurfaceSample) +
                                                   (vessels_.size() - freeCount_) * sizeof(Vessel));
  }
  EffectTimer timer(moves && any ? ledger : nullptr, Effect::vesselMotion);
  forEachPrescribed(
      [&](PrescribedVessel& vessel, std::size_t i, std::span<const SurfaceSample> water) {
        moves ? vessel.advance(t, water) : vessel.advanceUpright(t, water);
        requireSound(vessels_[i], scene_->vessels[i], t);
      });
}

void Simulation::moveTo(double t, EffectLedger* ledger) {
  moveFree(t, ledger);
  for (Vessel& vessel : vessels_) {
    if (HostedVessel* hosted = vessel.hosted()) hosted->moveTo(t);
  }
  wakes_.advance(t, vessels_, ledger);
  sampleAt(t, ledger);
  movePrescribed(t, ledger);
  if (freeCount_ > 0) {
    for (std::size_t i = 0; i < vessels_.size(); ++i) {
      if (FreeVessel* vessel = vessels_[i].free())
        vessel->readWater(surface(), wakes_.ownHandle(i));
    }
  }
  for (std::size_t i = 0; i < vessels_.size(); ++i) {
    if (HostedVessel* hosted = vessels_[i].hosted()) {
      hosted->readWater(surface(), wakes_.ownHandle(i));
    }
  }
  time_ = t;
}

void Simulation::advanceTo(double t, EffectLedger* ledger) {
  if (freeCount_ > 0) {
    const double from = time_, span = t - from;
    const int parts = static_cast<int>(std::ceil(span / longestFreeStep - reached));
    for (int i = 1; i < parts; ++i) moveTo(from + span * i / parts, ledger);
  }
  moveTo(t, ledger);
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
