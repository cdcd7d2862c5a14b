#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <vector>

#include "surface/disturbance/wake_system.h"
#include "surface/fit/octave_fit.h"
#include "surface/spectra/families.h"
#include "surface/water_surface.h"

/// What a wake costs: steps of the standard windows and points of their surface.
///
/// Times are of one core. A step's border comes every eighth step of the fine window and every
/// second of the coarse one; `step` has it in its share.
namespace seaway {
namespace {

HullFootprint launch() { return HullFootprint::wigley(12.0, 3.5, 0.8); }

struct Level {
  explicit Level(const WakeLevel& level)
      : step(level.step),
        window(std::make_shared<const WakeTables>(level.window, level.step),
               std::make_shared<const FootprintTable>(
                   launch(), level.window.depth, WakeWindow::largestWaveNumber(level.window))) {
    window.settle(at(0.0));
  }
  HullPlace at(double t) const { return {{6.0 * t, 0.0}, turn * t, 1.0}; }
  void advance() {
    const double t = steps * step;
    window.step(step, at(t), at(t + step));
    ++steps;
    if (steps % 8 == 0) window.absorb(at(t).position, 8 * step);
  }
  double step;
  double turn = 0.0;
  int steps = 0;
  WakeWindow window;
};

/// `state.range(0)`: 0 the fine level, 1 the coarse one.
void step(benchmark::State& state, bool turning, bool potential) {
  const auto cascade = standardCascade(12.0, std::numeric_limits<double>::infinity());
  Level level(cascade[static_cast<std::size_t>(state.range(0))]);
  level.turn = turning ? 0.1 : 0.0;
  WakeGrid grid(level.window.settings().cells, potential);
  for (auto _ : state) {
    level.advance();
    level.window.draw(grid);
    benchmark::DoNotOptimize(grid.surface.data());
  }
}
BENCHMARK_CAPTURE(step, straight, false, false)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(step, turning, true, false)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(step, with_velocity, false, true)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

void stepUndrawn(benchmark::State& state) {
  const auto cascade = standardCascade(12.0, std::numeric_limits<double>::infinity());
  Level level(cascade[static_cast<std::size_t>(state.range(0))]);
  for (auto _ : state) level.advance();
}
BENCHMARK(stepUndrawn)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

struct Scene {
  Scene() : water(WaveField(fitGroupOctaves(jonswap({1.12, 5.6, 3.3})).octaves)) {
    const std::uint32_t vessel = system.addVessel(launch());
    for (int i = 0; i <= 300; ++i) system.record(vessel, {0.1 * i, {0.6 * i, 0.0}, 0.0, 1.0});
    system.advance(30.0, std::vector<WakeListener>{{{180.0, 20.0}, 0.0, 0}});
    for (int i = 0; i < 4096; ++i) {
      points.emplace_back(175.0 - 0.4 * (i % 64), 0.4 * (i / 64) - 12.8);  // a patch astern
    }
  }
  WaterSurface water;
  WakeSystem system;
  std::vector<glm::dvec2> points;
};

void sample(benchmark::State& state, bool waves, bool wake, SampleOptions options) {
  static Scene scene;
  WaterSurface water = waves ? scene.water : WaterSurface(WaveField({}));
  if (wake) water.setDisturbances(scene.system.feed());
  const SurfaceAtTime now = water.at(30.03);
  std::vector<SurfaceSample> out(scene.points.size());
  for (auto _ : state) {
    now.sample(scene.points, out, options);
    benchmark::DoNotOptimize(out.data());
  }
  state.counters["ns/point"] = benchmark::Counter(
      static_cast<double>(out.size()) * 1e-9,
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK_CAPTURE(sample, waves, true, false, SampleOptions{});
BENCHMARK_CAPTURE(sample, waves_and_wake, true, true, SampleOptions{});
BENCHMARK_CAPTURE(sample, nothing, false, false, SampleOptions{});
BENCHMARK_CAPTURE(sample, wake, false, true, SampleOptions{});
BENCHMARK_CAPTURE(sample, wake_height, false, true, SampleOptions{.derivatives = false});
BENCHMARK_CAPTURE(sample, wake_velocity, false, true, SampleOptions{.orbitalVelocity = true});

}  // namespace
}  // namespace seaway

BENCHMARK_MAIN();
