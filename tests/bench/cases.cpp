#include "tests/bench/cases.h"

#include <benchmark/benchmark.h>
#include <tbb/task_arena.h>

#include <chrono>
#include <cmath>
#include <ctime>
#include <functional>
#include <glm/geometric.hpp>
#include <memory>
#include <string>
#include <vector>

#include "surface/field/kernels/field_blocks.h"
#include "surface/parallel_sampling.h"
#include "surface/water_kinematics.h"
#include "tests/bench/setups.h"

namespace seaway::bench {
namespace {

using Work = std::function<void()>;

/// What a name stands for.
struct Case {
  std::string name;
  std::size_t points = 0;      ///< answered by one run; 0: a step
  int octaves = 0;             ///< or components; 0: has none
  std::function<Work()> make;  ///< called once a repetition, outside the clock
  const char* target = "";     ///< instruction set forced
  bool wall = false;           ///< `ns_per_point` by the clock instead of CPU time
};

/// CPU time of this thread, ns.
double threadTime() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e9 * static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec);
}

void measure(benchmark::State& state, const Case& what) {
  if (!forceKernelTarget(what.target)) {
    state.SkipWithError("this machine lacks the instruction set");
    return;
  }
  const Work work = what.make();
  work();
  const auto start = std::chrono::steady_clock::now();
  const double startOfThread = threadTime();
  for (auto _ : state) {
    work();
    benchmark::ClobberMemory();
  }
  const double cpu = threadTime() - startOfThread;
  const std::chrono::duration<double, std::nano> wall = std::chrono::steady_clock::now() - start;
  forceKernelTarget("");
  const double runs = static_cast<double>(state.iterations());
  if (what.points == 0) {
    state.counters["ms_per_step"] = 1e-6 * cpu / runs;
    return;
  }
  const double answers = runs * static_cast<double>(what.points);
  const double perPoint = (what.wall ? wall.count() : cpu) / answers;
  state.counters["wall_ns_per_point"] = wall.count() / answers;
  state.counters["ns_per_point"] = perPoint;
  if (what.octaves > 0) state.counters["ns_per_point_octave"] = perPoint / what.octaves;
}

std::vector<std::string>& names() {
  static std::vector<std::string> all;
  return all;
}

void add(const Case& what) {
  names().push_back(what.name);
  benchmark::RegisterBenchmark(what.name.c_str(),
                               [what](benchmark::State& state) { measure(state, what); });
}

/// Work on points and room for arrays that live as long as itself.
Work onArrays(std::size_t batch, std::function<void(const BenchPoints&, BenchArrays&)> what) {
  const auto points = std::make_shared<BenchPoints>(batch);
  const auto out = std::make_shared<BenchArrays>(batch);
  return [=] { what(*points, *out); };
}

Work batchOf(OctaveKind kind, std::size_t batch) {
  const FieldAtTime& now = preparedField(kind).now;
  return onArrays(batch, [&now](const BenchPoints& at, BenchArrays& out) {
    now.sample(at.x, at.y, out.arrays());
  });
}

tbb::task_arena& twoThreads() {
  static tbb::task_arena arena(2);
  return arena;
}

Work onTwoThreads(std::size_t batch) {
  const FieldAtTime& now = preparedField(OctaveKind::group).now;
  return onArrays(batch, [&now](const BenchPoints& at, BenchArrays& out) {
    twoThreads().execute([&] { sampleInParallel(now, at.x, at.y, out.arrays()); });
  });
}

Work heights(std::size_t batch) {
  const FieldAtTime& now = preparedField(OctaveKind::group).now;
  return onArrays(batch, [&now](const BenchPoints& at, BenchArrays& out) {
    now.sample(at.x, at.y, {.height = out.height, .slopeX = {}, .slopeY = {}, .rate = {}});
  });
}

/// Points within 1e-14 cells of the lattice lines and of the cells' middles of the strongest
/// octave: where fractions might become denormal numbers.
Work besideLatticeLines(std::size_t batch) {
  const PreparedField& prepared = preparedField(OctaveKind::group);
  const GroupAtTime octave = prepared.field.lists().groups[0].at(benchTime);
  const auto points = std::make_shared<BenchPoints>(batch);
  for (std::size_t i = 0; i < batch; ++i) {
    const double cell = std::floor(0.01 * points->x[i]) + (i % 4 < 2 ? 0.0 : 0.5);
    const double metres = (cell + (i % 2 ? 1e-14 : -1e-14) - octave.along.offset) /
                          glm::length(octave.along.gradient);
    const glm::dvec2 at = metres * glm::normalize(octave.along.gradient);
    points->x[i] = at.x;
    points->y[i] = at.y;
  }
  const auto out = std::make_shared<BenchArrays>(batch);
  return [=, &prepared] { prepared.now.sample(points->x, points->y, out->arrays()); };
}

/// Velocity, acceleration and pressure one metre down.
Work motion(std::size_t batch) {
  const FieldAtTime& now = preparedField(OctaveKind::group).now;
  std::vector<glm::dvec3> points;
  for (const glm::dvec2& point : BenchPoints(batch).points) points.emplace_back(point, -1.0);
  const auto out = std::make_shared<std::vector<WaterKinematics>>(batch);
  return [=, &now] { sampleKinematics(now, points, *out); };
}

/// Work on points as vectors and whole samples.
Work onSamples(std::size_t batch,
               std::function<void(std::span<const glm::dvec2>, std::span<SurfaceSample>)> what) {
  const auto points = std::make_shared<BenchPoints>(batch);
  const auto out = std::make_shared<std::vector<SurfaceSample>>(batch);
  return [=] { what(points->points, *out); };
}

Work reference(std::size_t batch) {
  const WaveField& field = preparedField(OctaveKind::group).field;
  return onSamples(
      batch, [&field](auto points, auto out) { field.sampleReference(points, benchTime, out); });
}

Work samples(std::size_t batch, const SampleOptions& options) {
  const FieldAtTime& now = preparedField(OctaveKind::group).now;
  return onSamples(batch,
                   [&now, options](auto points, auto out) { now.sample(points, out, options); });
}

Work singles(std::size_t count) {
  const FieldAtTime& now = preparedField(OctaveKind::group).now;
  return onSamples(count, [&now](auto points, auto) {
    for (const glm::dvec2& point : points) benchmark::DoNotOptimize(now.sample(point));
  });
}

Work sines(int components, std::size_t batch) {
  const SineSum& sum = sineSum(components);
  return onArrays(batch, [&sum](const BenchPoints& at, BenchArrays& out) {
    sum.sample(at.x, at.y, out.arrays());
  });
}

/// Look-ups answer in texels.
Work onTexels(std::size_t batch, std::function<void(const BenchPoints&, std::span<Texel>)> what) {
  const auto points = std::make_shared<BenchPoints>(batch);
  const auto out = std::make_shared<std::vector<Texel>>(batch);
  return [=] { what(*points, *out); };
}

Work tile(std::uint32_t size, Interpolation interpolation, std::size_t batch) {
  const FftTile& sea = fftTile(size);
  return onTexels(batch, [&sea, interpolation](const BenchPoints& at, std::span<Texel> out) {
    sea.sample(at.x, at.y, interpolation, out);
  });
}

Work cached(Interpolation interpolation, double detail, std::size_t batch) {
  const CachedOctaves& sea = cachedOctaves();
  return onTexels(batch, [&sea, interpolation, detail](const BenchPoints& at, auto out) {
    sea.sample(at.x, at.y, interpolation, detail, out);
  });
}

void registerOctaves() {
  constexpr int n = benchOctaves;
  for (const std::size_t batch : {64u, 1024u, 65536u}) {
    add({"field/group/12/" + std::to_string(batch), batch, n,
         [=] { return batchOf(OctaveKind::group, batch); }});
  }
  const auto group = [] { return batchOf(OctaveKind::group, 1024); };
  const auto perlin = [] { return batchOf(OctaveKind::perlin, 1024); };
  add({"field/perlin/12/1024", 1024, n, perlin});
  add({"field/regular/12/1024", 1024, n, [] { return batchOf(OctaveKind::regular, 1024); }});
  add({"field/scalar/12/1024", 1024, n, [] { return reference(1024); }});
  add({"field/single/12", 1024, n, [] { return singles(1024); }});
  add({"field/group_samples/12/1024", 1024, n, [] { return samples(1024, {}); }});
  add({"field/group_orbital/12/1024", 1024, n,
       [] { return samples(1024, {.orbitalVelocity = true}); }});
  add({"field/group_avx2/12/1024", 1024, n, group, "AVX2"});
  add({"field/perlin_avx2/12/1024", 1024, n, perlin, "AVX2"});
  add({"field/height/12/1024", 1024, n, [] { return heights(1024); }});
  add({"field/lattice_lines/12/1024", 1024, n, [] { return besideLatticeLines(1024); }});
  add({"field/motion/12/1024", 1024, n, [] { return motion(1024); }});
  add({"field/two_threads/65536", 65536, 0, [] { return onTwoThreads(65536); }, "", true});
}

void registerRivals() {
  for (const int count : {50, 200, 1000}) {
    add({"field/sines/" + std::to_string(count) + "/1024", 1024, count,
         [=] { return sines(count, 1024); }});
  }
  add({"field/sines_avx2/200/1024", 1024, 200, [] { return sines(200, 1024); }, "AVX2"});
  for (const std::uint32_t size : {256u, 512u}) {
    const std::string name = "field/fft" + std::to_string(size);
    add({name + "_bilinear/1024", 1024, 0,
         [=] { return tile(size, Interpolation::bilinear, 1024); }});
    add({name + "_bicubic/1024", 1024, 0, [=] { return tile(size, Interpolation::cubic, 1024); }});
    add({name + "_step", 0, 0,
         [=]() -> Work { return [&sea = fftTile(size)] { sea.step(benchTime); }; }});
  }
  add({"field/cached_bilinear/1024", 1024, 0,
       [] { return cached(Interpolation::bilinear, 0.0, 1024); }});
  add({"field/cached_trilinear/1024", 1024, 0,
       [] { return cached(Interpolation::bilinear, 0.5, 1024); }});
  add({"field/cached_cubic/1024", 1024, 0, [] { return cached(Interpolation::cubic, 0.0, 1024); }});
  add({"field/cached_step", 0, 0,
       []() -> Work { return [&sea = cachedOctaves()] { sea.step(benchTime); }; }});
}

}  // namespace

std::vector<std::string> registerFieldCases() {
  registerOctaves();
  registerRivals();
  return names();
}

}  // namespace seaway::bench
