// MuJoCo's steps a second with hulls on Seaway's waves, beside MuJoCo alone.
#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "sim_bridge/mujoco/hull_coupling.h"
#include "surface/fit/octave_fit.h"
#include "surface/hull/analytic_hulls.h"
#include "surface/spectra/families.h"
#include "tests/sim_bridge/mujoco/mujoco_world.h"

namespace seaway::bridge {
namespace {

std::string fleet(int count) {
  std::string bodies;
  for (int i = 0; i < count; ++i) {
    bodies += "<body name='b" + std::to_string(i) + "' pos='" + std::to_string(40 * (i % 10)) +
              " " + std::to_string(40 * (i / 10)) +
              " 0'><freejoint/><inertial pos='0 0 0' mass='8000' diaginertia='9000 70000 70000'/>"
              "</body>";
  }
  return "<mujoco><option timestep='0.005' gravity='0 0 -9.80665'/><worldbody>" + bodies +
         "</worldbody></mujoco>";
}

const WaterSurface& sea() {
  static const WaterSurface water = [] {
    OctaveFitOptions options;
    options.octaves = 12;
    return WaterSurface(WaveField(fitGroupOctaves(jonswap({1.12, 5.6, 3.3}), options).octaves));
  }();
  return water;
}

enum class Water { none, columns, mesh };

void steps(benchmark::State& state, Water kind) {
  const int count = static_cast<int>(state.range(0));
  test::MujocoWorld world(fleet(count));
  HullSettings settings;
  settings.level = kind == Water::columns ? LoadLevel::columns : LoadLevel::meshDynamic;
  settings.mass = 8000.0;
  settings.columns = {10, 5};
  const auto hull = std::make_shared<HullModel>(boxMesh(12.0, 3.6, 1.6, 0.2, 800), settings);
  std::optional<HullCoupling> coupling;
  if (kind != Water::none) {
    coupling.emplace(*world.model, sea());
    for (int i = 0; i < count; ++i) coupling->add("b" + std::to_string(i), hull);
  } else {
    world.model->opt.gravity[2] = 0.0;
  }
  for (auto _ : state) mj_step(world.model.get(), world.data.get());
  state.counters["steps/s"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

BENCHMARK_CAPTURE(steps, alone, Water::none)->Arg(1)->Arg(10)->Arg(100)->UseRealTime();
BENCHMARK_CAPTURE(steps, columns, Water::columns)->Arg(1)->Arg(10)->Arg(100)->UseRealTime();
BENCHMARK_CAPTURE(steps, mesh, Water::mesh)->Arg(1)->Arg(10)->Arg(100)->UseRealTime();

}  // namespace
}  // namespace seaway::bridge

BENCHMARK_MAIN();
