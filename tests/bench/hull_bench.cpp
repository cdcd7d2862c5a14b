// What loads on hulls cost.
#include <benchmark/benchmark.h>

#include <cmath>

#include "surface/fit/octave_fit.h"
#include "surface/hull/analytic_hulls.h"
#include "surface/hull/hull_loads.h"
#include "surface/spectra/families.h"

namespace seaway {
namespace {

const WaterSurface& sea() {
  static const WaterSurface water = [] {
    OctaveFitOptions options;
    options.octaves = 12;
    return WaterSurface(WaveField(fitGroupOctaves(jonswap({1.12, 5.6, 3.3}), options).octaves));
  }();
  return water;
}

HullModel hull(LoadLevel level, std::size_t triangles, glm::ivec2 columns) {
  HullSettings settings;
  settings.level = level;
  const TriangleMesh mesh = wigleyMesh(12.0, 3.6, 0.8, 1.0, triangles);
  settings.mass = seaWaterDensity * submergedPart(mesh, WaterPlane::at(0.0)).volume;
  settings.columns = columns;
  settings.shortestWavelength = 0.0;  // every octave, whatever the hull's size
  return {mesh, settings};
}

void oneHull(benchmark::State& state, LoadLevel level) {
  const HullModel model = hull(level, static_cast<std::size_t>(state.range(0)), {20, 20});
  LoadScratch scratch;
  HullPose pose;
  pose.velocity = {5.0, 0.0, 0.0};
  double t = 0.0;
  for (auto _ : state) {
    t += 0.01;
    pose.position.x += 0.05;
    benchmark::DoNotOptimize(loads(model, pose, sea(), t, scratch));
  }
  state.counters["triangles"] = static_cast<double>(model.panels().size());
}

void crowd(benchmark::State& state) {
  HullSettings settings;
  settings.level = LoadLevel::columns;
  settings.mass = 0.5 * seaWaterDensity * 12.0 * 3.6 * 1.6;
  settings.shortestWavelength = 0.0;
  const HullModel model(boxMesh(12.0, 3.6, 1.6, 0.8), settings);
  std::vector<PlacedHull> hulls(100);
  for (std::size_t i = 0; i < hulls.size(); ++i) {
    hulls[i].model = &model;
    hulls[i].pose.position = {40.0 * static_cast<double>(i % 10),
                              40.0 * static_cast<double>(i / 10), 0.0};
  }
  std::vector<HullLoads> out(hulls.size());
  std::vector<LoadScratch> scratch(hulls.size());
  SurfaceAtTime now = sea().at(0.0);
  double t = 0.0;
  for (auto _ : state) {
    now.moveTo(sea(), t += 0.01);
    loadsInParallel(hulls, now, out, scratch);
  }
  state.counters["columns"] = static_cast<double>(model.columns().size());
}

BENCHMARK_CAPTURE(oneHull, meshDynamic, LoadLevel::meshDynamic)
    ->Arg(200)
    ->Arg(800)
    ->Arg(3200)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(oneHull, mesh, LoadLevel::mesh)
    ->Arg(200)
    ->Arg(800)
    ->Arg(3200)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(oneHull, columns, LoadLevel::columns)->Arg(800)->Unit(benchmark::kMicrosecond);
BENCHMARK(crowd)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace seaway

BENCHMARK_MAIN();
