#include "sim_bridge/selftest/soak.h"

#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "render/technique_choice.h"
#include "sim_bridge/output/checkpoint.h"
#include "sim_bridge/output/process_memory.h"
#include "sim_bridge/output/progress.h"
#include "sim_bridge/output/stopwatch.h"
#include "sim_bridge/output/telemetry.h"
#include "sim_bridge/scene_view.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

/// What was freed goes back first; files that are mapped, which the kernel drops and reads again as
/// it likes, do not count, and what it has swapped out does.
std::size_t residentBytes() {
  malloc_trim(0);
  return processMemory({"RssAnon", "VmSwap"});
}

std::size_t heapBytes() {
  const struct mallinfo2 heap = mallinfo2();
  return heap.uordblks + heap.hblkhd;
}

/// Pictures of all cameras, which nobody keeps.
class Onlooker {
 public:
  Onlooker(const Scene& scene, const std::string& backend) : scene_(scene), view_(scene) {
    if (!scene.cameras.empty() && scene.run.framesPerSecond > 0.0) {
      technique_ = render::makeTechnique({.grid = scene.accuracy.grid, .backend = backend});
    }
  }

  Audience audience() const {
    return technique_ ? Audience{.cameras = scene_.cameras, .places = {}} : Audience{};
  }

  /// Draws the frames that are due by the simulation's time.
  void watch(const Simulation& simulation) {
    while (technique_ && due() <= simulation.time()) {
      for (const SceneCamera& camera : scene_.cameras) {
        EffectLedger ledger(scene_.effects);
        technique_->draw(view_.view(simulation, camera, scene_.run.size, ledger));
      }
      ++frames_;
    }
  }

  long long frames() const { return frames_; }

 private:
  double due() const { return static_cast<double>(frames_) / scene_.run.framesPerSecond; }

  const Scene& scene_;
  SceneView view_;
  std::unique_ptr<render::RenderTechnique> technique_;
  long long frames_ = 0;
};

void sailOn(Simulation& simulation, double until) {
  while (simulation.nextTime() <= until * (1.0 + 1e-12)) simulation.step();
}

/// A whole run, with a reading whenever one is due.
class Soaking {
 public:
  Soaking(const Scene& scene, const SoakSettings& settings)
      : scene_(scene),
        settings_(settings),
        sea_(buildSea(scene)),
        onlooker_(scene, settings.backend),
        simulation_(scene, sea_),
        checkpoint_(settings.folder / "soak.checkpoint") {
    simulation_.attend(onlooker_.audience());
  }

  SoakResult run(const std::function<void(const SoakReading&)>& observe) {
    Telemetry telemetry(settings_.folder, scene_);
    telemetry.write(simulation_);
    const auto readings = static_cast<long long>(scene_.run.duration / settings_.every + 1e-9);
    Progress progress("steps", static_cast<std::size_t>(scene_.run.duration / scene_.run.step));
    for (long long i = 1; i <= readings; ++i) {
      StepTimes times;
      sail(static_cast<double>(i) * settings_.every, telemetry, times, progress);
      const SoakReading reading{simulation_.time(), residentBytes(), heapBytes(),
                                times.percentile(0.5), times.percentile(0.99)};
      result_.readings.push_back(reading);
      observe(reading);
      if (i == readings) break;
      writeCheckpoint(checkpoint_, scene_,
                      {reading.time, simulation_.state(), telemetry.keep(checkpoint_)});
    }
    telemetry.commit();
    result_.frames = onlooker_.frames();
    goOnFromCheckpoint();
    return std::move(result_);
  }

 private:
  void sail(double until, Telemetry& telemetry, StepTimes& times, Progress& progress) {
    while (simulation_.nextTime() <= until * (1.0 + 1e-12)) {
      const Stopwatch step;
      simulation_.step();
      const double microseconds = 1e3 * step.milliseconds();
      times.add(microseconds);
      result_.steps.add(microseconds);
      telemetry.write(simulation_);
      onlooker_.watch(simulation_);
      progress.update(static_cast<std::size_t>(++result_.stepCount));
    }
  }

  void goOnFromCheckpoint() {
    const Checkpoint from = readCheckpoint(checkpoint_, scene_);
    Simulation other = Simulation::resumed(scene_, sea_, onlooker_.audience(), from.state);
    sailOn(other, simulation_.time());
    result_.resumedFrom = from.time;
    result_.resumes = other.state() == simulation_.state();
  }

  const Scene& scene_;
  const SoakSettings& settings_;
  Sea sea_;
  Onlooker onlooker_;
  Simulation simulation_;
  std::filesystem::path checkpoint_;
  SoakResult result_;
};

}  // namespace

double memoryChange(const std::vector<SoakReading>& readings, std::size_t SoakReading::*bytes,
                    double settled) {
  std::optional<double> first;
  double most = 0.0;
  for (const SoakReading& reading : readings) {
    if (reading.time < settled) continue;
    const auto held = static_cast<double>(reading.*bytes);
    if (!first) first = held;
    if (*first == 0.0) return 0.0;  // not counted: an allocator of a sanitizer, say
    most = std::max(most, std::abs(held / *first - 1.0));
  }
  return most;
}

SoakResult soak(const Scene& scene, const SoakSettings& settings,
                const std::function<void(const SoakReading&)>& observe) {
  if (scene.run.duration < 2.0 * settings.every * (1.0 - 1e-12)) {
    throw InputError("a soak takes at least two readings: the run of " +
                     std::to_string(scene.run.duration) + " s has not twice " +
                     std::to_string(settings.every) + " s");
  }
  return Soaking(scene, settings).run(observe);
}

}  // namespace seaway::bridge
