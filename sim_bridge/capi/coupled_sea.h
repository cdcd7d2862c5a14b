#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "render/technique_choice.h"
#include "sim_bridge/scene_view.h"
#include "sim_bridge/simulation.h"
#include "surface/disturbance/published.h"
#include "surface/effects.h"

namespace seaway::bridge {

/// A scene that a program steps, asks, places vessels in and takes pictures of: what a handle of
/// the C interface stands for.
///
/// Readers take `now()` and never wait. Everything that changes the sea takes turns on a lock, does
/// its work on the simulation and then publishes what readers see from then on.
class CoupledSea {
 public:
  /// `startTime` ≥ 0. Throws InputError.
  CoupledSea(Scene scene, double startTime);

  /// The sea between two changes. Immutable.
  struct Moment {
    double time = 0.0;
    WaterSurface surface;
    std::vector<VesselPose> poses;
    std::vector<std::uint32_t> ownWakes;  ///< by vessel, for SampleOptions::excludeVessel
  };
  std::shared_ptr<const Moment> now() const noexcept { return moment_.latest(); }

  const Scene& scene() const { return scene_; }
  const Geodesy& geodesy() const { return sea_.geodesy; }
  const SeaLevel& level() const { return sea_.level; }
  /// Of all seas of the program, never used again.
  std::uint64_t number() const { return number_; }

  /// Whole steps as long as they do not pass `t`; one step. Where one throws, readers keep the
  /// last moment, and later ones throw the same until `restart`.
  void stepTo(double t);
  void step();
  /// Throws before anything changes.
  void restart(double t);

  void listen(std::vector<WakeListener> places);

  /// See Simulation::place: false, and nothing changes, for a time that is too early.
  bool place(std::size_t vessel, double t, const VesselPose& pose);

  /// A picture at the present time, in memory that the next one uses again: `use` reads it.
  template <class Use>
  void draw(const SceneCamera& camera, glm::ivec2 size, const render::TechniqueChoice& choice,
            const Use& use) {
    const std::lock_guard lock(changing_);
    drawFrame(camera, size, choice);
    use(frame_);
  }

  /// As JSON; see seaway_sea_describe.
  std::string description() const;

 private:
  void publish();
  void requireAlive() const;
  template <class Change>
  void change(const Change& change);
  void drawFrame(const SceneCamera& camera, glm::ivec2 size, const render::TechniqueChoice& choice);

  const std::uint64_t number_;
  const Scene scene_;
  const Sea sea_;
  mutable std::mutex changing_;  // held for all that follows
  std::unique_ptr<Simulation> simulation_;
  Audience audience_;
  std::string fault_;  // why the sea stands still
  std::vector<EffectReport> stepEffects_, frameEffects_;
  SceneView view_;
  std::string drawnBy_;
  std::unique_ptr<render::RenderTechnique> technique_;
  render::Frame frame_;
  mutable double hm0Realised_ = -1.0;  // until it is asked for
  Published<Moment> moment_;
};

}  // namespace seaway::bridge
