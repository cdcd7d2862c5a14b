#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "render/headless_context.h"
#include "render/png.h"
#include "render/render_technique.h"
#include "surface/angles.h"
#include "surface/spectra/families.h"

/// What a frame costs on a graphics card, by variant of the projected grid:
///
///   frame_gpu_bench --backend egl:0                  the context to draw with (default egl)
///   frame_gpu_bench --backend egl:0 --write FOLDER   writes the pictures instead
///
/// Sea of 16 group octaves, sky, sun. Time is wall time of whole frames, each waited for; the
/// counters give milliseconds a frame: `gpu` by timer queries in all, `gpu_PASS` of each pass (on
/// hardware alone), `cpu_PASS` wall time. "kept" leaves the picture on the card, "read" brings it
/// to memory and smooths its edges there. Flags of Google Benchmark are understood.
namespace seaway::bench {
namespace {

using namespace seaway::render;

std::unique_ptr<HeadlessContext> context;

struct Setup {
  const char* name;
  glm::ivec2 size, grid;
};
constexpr Setup setups[] = {{"1920x1080/512x1024", {1920, 1080}, {512, 1024}},
                            {"3840x2160/512x1024", {3840, 2160}, {512, 1024}},
                            {"160x90/64x128", {160, 90}, {64, 128}}};

struct Eye {
  const char* name;
  double height, pitch_deg;
};
constexpr Eye eyes[] = {{"mast", 6.0, -9.0}, {"bow", 2.0, -3.0}, {"air", 300.0, -20.0}};

/// Sixteen group octaves of a JONSWAP sea from the energy in their bands: without the fit's
/// libraries the program stays small.
std::vector<Octave> spreadOctaves() {
  const FrequencySpectrum spectrum = jonswap({1.12, 5.6, 3.3});
  std::vector<Octave> octaves;
  constexpr double lowest = 0.09, ratio = 1.12;
  for (int i = 0; i < 16; ++i) {
    const double frequency = lowest * std::pow(ratio, i);
    const double band = frequency * (std::sqrt(ratio) - 1.0 / std::sqrt(ratio));
    octaves.push_back(makeGroupOctave(std::sqrt(spectrum.at(frequency) * band), frequency, band,
                                      0.5 * std::sin(2.4 * i), 0.5));
  }
  return octaves;
}

/// A view and what it refers to.
struct Film {
  Film(glm::ivec2 size, const Eye& eye) : water(WaveField(spreadOctaves())) {
    view.water = &water;
    view.camera.position = {0.0, 0.0, eye.height};
    view.camera.worldFromCamera = attitude(0.6, radiansFromDegrees(eye.pitch_deg), 0.0);
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

void measure(benchmark::State& state, const Setup& setup, const Eye& eye,
             const ProjectedGridOptions& options) {
  Film film(setup.size, eye);
  const auto technique = makeProjectedGrid(*context, options);
  Frame frame;
  for (int i = 0; i < 3; ++i) technique->drawInto(film.view, frame);  // tables, sky, programs
  std::map<std::string, double> sums;
  for (auto _ : state) {
    film.view.time += 0.04;
    film.view.camera.position.x += 0.24;
    technique->drawInto(film.view, frame);
    for (const auto& [pass, ms] : frame.stats.gpuMs) {
      sums["gpu"] += ms;
      sums["gpu_" + pass] += ms;
    }
    for (const auto& [pass, ms] : frame.stats.passesMs) sums["cpu_" + pass] += ms;
  }
  for (const auto& [name, sum] : sums) {
    state.counters[name] = benchmark::Counter(sum, benchmark::Counter::kAvgIterations);
  }
}

void registerFrames() {
  for (const Setup& setup : setups) {
    for (const Eye& eye : eyes) {
      for (const GridVariant variant :
           {GridVariant::marched, GridVariant::gpu, GridVariant::cpuVerticesGpuNormals}) {
        for (const bool read : {false, true}) {
          const ProjectedGridOptions options{
              .grid = setup.grid, .variant = variant, .readBack = read};
          const std::string name = std::string("frame_gpu/") + setup.name + '/' + eye.name + '/' +
                                   std::string(gridVariantName(variant)) +
                                   (read ? "/read" : "/kept");
          benchmark::RegisterBenchmark(
              name.c_str(),
              [&setup, &eye, options](auto& state) { measure(state, setup, eye, options); })
              ->UseRealTime()
              ->Unit(benchmark::kMillisecond);
        }
      }
    }
  }
}

void writePictures(const std::string& folder) {
  for (const Eye& eye : eyes) {
    for (const GridVariant variant : {GridVariant::marched, GridVariant::gpu}) {
      Film film({1280, 720}, eye);
      const auto technique = makeProjectedGrid(*context, {.grid = {512, 1024}, .variant = variant});
      const std::string path =
          folder + '/' + eye.name + '_' + std::string(gridVariantName(variant)) + ".png";
      writePng(path, technique->draw(film.view).colour);
      std::printf("%s\n", path.c_str());
    }
  }
}

}  // namespace
}  // namespace seaway::bench

int main(int argc, char** argv) {
  std::string backend = "egl", folder;
  std::vector<char*> arguments{argv[0]};
  for (int i = 1; i < argc; ++i) {
    const bool hasValue = i + 1 < argc;
    if (hasValue && std::strcmp(argv[i], "--backend") == 0) {
      backend = argv[++i];
    } else if (hasValue && std::strcmp(argv[i], "--write") == 0) {
      folder = argv[++i];
    } else {
      arguments.push_back(argv[i]);
    }
  }
  int count = static_cast<int>(arguments.size());
  arguments.push_back(nullptr);
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 1;
  try {
    seaway::bench::context = seaway::render::makeHeadlessContext(backend);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
  std::printf("%s: %s, OpenGL %s\n", backend.c_str(), seaway::bench::context->renderer().c_str(),
              seaway::bench::context->version().c_str());
  if (folder.empty()) {
    seaway::bench::registerFrames();
    benchmark::RunSpecifiedBenchmarks();
  } else {
    seaway::bench::writePictures(folder);
  }
  benchmark::Shutdown();
  seaway::bench::context.reset();
  return 0;
}
