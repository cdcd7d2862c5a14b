#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "sim_bridge/scene/scene.h"
#include "sim_bridge/scene/sea.h"
#include "sim_bridge/scene_detail.h"
#include "sim_bridge/scene_wakes.h"
#include "sim_bridge/vessel/vessel.h"
#include "surface/effects.h"

namespace seaway::bridge {

/// The vessels of a scene in motion, from the scene's epoch on in equal steps.
///
/// Vessels rock in each other's wakes, and not in their own (SceneWakes). Free ones move first, in
/// the water and the wakes as of the step's begin, so that their wakes of its end are known.
///
/// A copy is a snapshot: it can be moved on without touching the original. Times are multiples of
/// the step, never sums, so that a replay gives the same bits.
class Simulation {
 public:
  /// At the scene's start, the vessels set down on the water. `scene` and `sea` must outlive the
  /// simulation and its copies.
  Simulation(const Scene& scene, const Sea& sea, EffectLedger* ledger = nullptr);

  /// At time `t` ≥ 0, replayed from the start; from 600 s before `t`, and as long again as wakes
  /// last, where that is later, none is free and all are damped, for by then they have forgotten
  /// their start. On the way wakes run where vessels feel them; for an audience they are rebuilt at
  /// `t`
  /// (`attend`), within 1 % of their height of those that have run all along.
  /// `observe` hears of every step: how many are done, and of how many.
  static Simulation replayed(
      const Scene& scene, const Sea& sea, double t,
      const std::function<void(std::size_t done, std::size_t all)>& observe = {});

  /// The state as a text of bytes, for the same build on the same machine.
  std::string state() const;
  /// A simulation in that state, which goes on bit for bit as the one that it was taken from, with
  /// the same audience. Throws InputError for bytes that are cut off or of another scene.
  static Simulation resumed(const Scene& scene, const Sea& sea, Audience audience,
                            const std::string& state);

  /// From now on wakes are there for these too; by default vessels alone call for them.
  void attend(Audience audience, EffectLedger* ledger = nullptr);

  /// Vessel `index` is where a host says from now on, at `t` at `pose` (HostedVessel). False, and
  /// nothing changes, where `t` is before time() or not later than the host's last pose.
  bool place(std::size_t index, double t, const VesselPose& pose);

  /// Other waves from now on, of a sea that is else the same and outlives the simulation.
  void setSea(const Sea& sea);

  double time() const { return time_; }
  double nextTime() const;  ///< after one more step, s

  /// One step. The water is sampled in one batch for all vessels. Throws InputError where a course
  /// leaves the geodesy's range or the sea's outline, or a free hull touches the bed;
  /// std::runtime_error where a motion stops being finite.
  void step(EffectLedger* ledger = nullptr);

  /// Steps as long as the next whole step does not pass `t`.
  void stepTo(double t, EffectLedger* ledger = nullptr);

  /// A copy at exactly `t` ≥ time(): whole steps, then a part of one.
  Simulation movedTo(double t, EffectLedger* ledger = nullptr) const;

  const Scene& scene() const { return *scene_; }
  const Sea& sea() const { return *sea_; }
  std::span<const Vessel> vessels() const { return vessels_; }
  /// The sea with all that disturbs it, at times about `time()`. Valid until the next step.
  const WaterSurface& surface() const { return disturbed_ ? *disturbed_ : wakes_.surface(); }
  /// Handle of the waves that vessel `index` does not feel, for SampleOptions::excludeVessel.
  std::uint32_t ownWake(std::size_t index) const { return wakes_.ownHandle(index); }

 private:
  Simulation(const Scene& scene, const Sea& sea, long long firstStep, EffectLedger* ledger);
  template <class Archive>
  void archive(Archive& archive);
  void countWater();
  void moveFree(double t, EffectLedger* ledger);
  void movePrescribed(double t, EffectLedger* ledger);
  void moveTo(double t, EffectLedger* ledger);
  void requireSound(const Vessel& vessel, const SceneVessel& description, double t) const;
  void sampleAt(double t, EffectLedger* ledger);
  void disturb(double t, EffectLedger* ledger);
  void showDetail();
  void sampleSurface(double t);
  void requireAfloat(double t);
  void advanceTo(double t, EffectLedger* ledger);
  /// action(vessel, index, its samples)
  template <class Action>
  void forEachPrescribed(Action action);

  const Scene* scene_;
  const Sea* sea_;
  std::vector<Vessel> vessels_;
  SceneWakes wakes_;
  SceneDetail detail_;
  std::shared_ptr<const WaterSurface> disturbed_;  // null: nothing but waves, wakes and events
  std::size_t freeCount_ = 0;
  std::vector<glm::dvec2> points_;  // of prescribed vessels, as are samples_
  std::vector<SurfaceSample> samples_;
  long long steps_ = 0;
  double time_ = 0.0;
};

}  // namespace seaway::bridge
