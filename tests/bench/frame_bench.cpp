#include <benchmark/benchmark.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "render/headless_context.h"
#include "render/png.h"
#include "render/render_technique.h"
#include "surface/angles.h"
#include "surface/fit/octave_fit.h"
#include "surface/spectra/families.h"

/// What a frame costs by each variant of the projected grid, in one process, interleaved:
///
///   frame_bench                 medians of interleaved repetitions, then ratios to the GL mesh
///   frame_bench --write FOLDER  writes the pictures instead
///
/// Sea of 12 group octaves, sky, sun, the picture in memory at the end. Frames differ in time, as a
/// film's do. Flags of Google Benchmark are understood.
namespace seaway::bench {
namespace {

using namespace seaway::render;

struct Setup {
  const char* name;
  glm::ivec2 size, grid;
};
constexpr Setup setups[] = {{"1280x720/256x512", {1280, 720}, {256, 512}},
                            {"1280x720/128x256", {1280, 720}, {128, 256}},
                            {"640x480/128x256", {640, 480}, {128, 256}}};

constexpr GridVariant variants[] = {GridVariant::cpuVertices, GridVariant::software};

/// Twelve group octaves of a wind sea, their directions spread.
std::vector<Octave> spreadOctaves() {
  std::vector<Octave> octaves = fitGroupOctaves(jonswap({1.12, 5.6, 3.3}), {.octaves = 12}).octaves;
  for (std::size_t i = 0; i < octaves.size(); ++i) {
    octaves[i].toward = 0.5 * std::sin(2.4 * static_cast<double>(i));
  }
  return octaves;
}

/// A view and what it refers to.
struct Film {
  explicit Film(glm::ivec2 size) : water(WaveField(spreadOctaves())) {
    view.water = &water;
    view.camera.position = {0.0, 0.0, 6.0};
    view.camera.worldFromCamera = attitude(0.6, radiansFromDegrees(-9.0), 0.0);
    view.camera.verticalFieldOfView = radiansFromDegrees(50.0);
    view.camera.size = size;
    view.light.sunElevation = radiansFromDegrees(25.0);
    view.light.sunDirection = 0.9;
    view.effects = &effects;
  }
  WaterSurface water;
  EffectLedger effects;
  View view;
};

std::unique_ptr<RenderTechnique> make(GridVariant variant, glm::ivec2 grid) {
  const ProjectedGridOptions options{.grid = grid, .variant = variant};
  if (variant == GridVariant::software) return makeSoftwareGrid(options);
  static const std::unique_ptr<HeadlessContext> context = makeHeadlessContext();
  return makeProjectedGrid(*context, options);
}

void measure(benchmark::State& state, const Setup& setup, GridVariant variant) {
  Film film(setup.size);
  const auto technique = make(variant, setup.grid);
  Frame frame;
  technique->drawInto(film.view, frame);  // tables and sky are made once
  std::vector<double> passes(frame.stats.passesMs.size() + 1, 0.0);
  for (auto _ : state) {
    film.view.time += 0.04;
    technique->drawInto(film.view, frame);
    for (std::size_t i = 0; i < frame.stats.passesMs.size(); ++i) {
      passes[i] += frame.stats.passesMs[i].second;
    }
  }
  for (std::size_t i = 0; i < frame.stats.passesMs.size(); ++i) {
    state.counters[frame.stats.passesMs[i].first] =
        benchmark::Counter(passes[i], benchmark::Counter::kAvgIterations);
  }
}

std::string caseName(const Setup& setup, GridVariant variant) {
  return std::string("frame/") + setup.name + '/' + std::string(gridVariantName(variant));
}

/// Console output that also remembers medians.
class Medians : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (run.aggregate_name == "median") {
        medians_.emplace_back(run.run_name.function_name, run.GetAdjustedRealTime());
      }
    }
  }
  double of(const std::string& name) const {
    for (const auto& [known, time] : medians_) {
      if (known == name) return time;
    }
    return 0.0;
  }

 private:
  std::vector<std::pair<std::string, double>> medians_;
};

void printRatios(const Medians& medians) {
  for (const Setup& setup : setups) {
    const double baseline = medians.of(caseName(setup, GridVariant::cpuVertices));
    for (const GridVariant variant : variants) {
      const double time = medians.of(caseName(setup, variant));
      if (baseline > 0.0 && time > 0.0) {
        std::printf("%-44s %8.2f ms a frame, %.3f of the GL mesh\n",
                    caseName(setup, variant).c_str(), time, time / baseline);
      }
    }
  }
}

void writePictures(const std::string& folder) {
  for (const GridVariant variant : variants) {
    Film film(setups[0].size);
    const Frame frame = make(variant, setups[0].grid)->draw(film.view);
    writePng(folder + '/' + std::string(gridVariantName(variant)) + ".png", frame.colour);
  }
}

}  // namespace
}  // namespace seaway::bench

int main(int argc, char** argv) {
  using namespace seaway::bench;
  if (argc == 3 && std::strcmp(argv[1], "--write") == 0) {
    writePictures(argv[2]);
    return 0;
  }
  char interleave[] = "--benchmark_enable_random_interleaving=true";
  char repeat[] = "--benchmark_repetitions=5";
  char shortly[] = "--benchmark_min_time=0.3";
  char aggregates[] = "--benchmark_report_aggregates_only=true";
  std::vector<char*> arguments{argv[0], interleave, repeat, shortly, aggregates};
  arguments.insert(arguments.end(), argv + 1, argv + argc);
  int count = static_cast<int>(arguments.size());
  arguments.push_back(nullptr);
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 1;
  for (const Setup& setup : setups) {
    for (const auto variant : variants) {
      benchmark::RegisterBenchmark(
          caseName(setup, variant).c_str(),
          [&setup, variant](benchmark::State& state) { measure(state, setup, variant); })
          ->Unit(benchmark::kMillisecond)
          ->UseRealTime()
          ->MeasureProcessCPUTime();
    }
  }
  Medians medians;
  benchmark::RunSpecifiedBenchmarks(&medians);
  printRatios(medians);
  benchmark::Shutdown();
  return 0;
}
