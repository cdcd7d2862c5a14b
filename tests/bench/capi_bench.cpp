// What the C interface costs on top of the library: 1000 points of a sea of 12 octaves, in turns
// with the C++ calls in one process. `--table` prints medians and 99th percentiles of single calls,
// and the median difference of neighbours; without it Google Benchmark times them.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <vector>

#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/scene/sea.h"
#include "sim_bridge/seaway.h"

namespace {

using seaway::SampleOptions;
using seaway::SurfaceSample;

const char* const scene = R"(sea:
  anchor: {latitude_deg: 28.878, longitude_deg: -78.467}
  seed: 7
  state: {jonswap: {hm0_m: 1.12, tp_s: 5.6, from_deg: 196, octaves: 12}}
)";

/// One sea and the same points, through both doors.
struct Setup {
  seaway::bridge::Sea sea = seaway::bridge::buildSea(seaway::bridge::sceneFromText(scene, "."));
  seaway_sea* handle = nullptr;
  std::vector<glm::dvec2> places;
  std::vector<SurfaceSample> answers;
  std::vector<double> east, north, height, slopeEast, slopeNorth, rate;
  std::vector<float> heights, slopesEast, slopesNorth, rates;
  std::vector<std::uint32_t> status;
  seaway::SurfaceAtTime prepared = sea.surface.at(0.0);
  seaway_points points = seaway_points_default();
  seaway_samples samples = seaway_samples_default();

  explicit Setup(std::size_t count) : answers(count) {
    seaway_sea_from_text(scene, nullptr, nullptr, &handle);
    for (std::size_t i = 0; i < count; ++i) {
      east.push_back(0.37 * static_cast<double>(i % 40));
      north.push_back(0.41 * static_cast<double>(i / 40));
      places.emplace_back(east[i], north[i]);
    }
    for (auto* out : {&height, &slopeEast, &slopeNorth, &rate}) out->resize(count);
    for (auto* out : {&heights, &slopesEast, &slopesNorth, &rates}) out->resize(count);
    status.resize(count);
    points.count = count;
    points.first = east.data();
    points.second = north.data();
    samples.height = height.data();
    samples.slope_east = slopeEast.data();
    samples.slope_north = slopeNorth.data();
    samples.vertical_velocity = rate.data();
    samples.status = status.data();
  }
  ~Setup() { seaway_sea_destroy(handle); }
  Setup(const Setup&) = delete;

  void throughLibrary(double t) { sea.surface.sample(places, t, answers); }
  /// The cheapest form that there is: from arrays to arrays of floats, without error and status.
  void throughArrays(double t) {
    prepared.moveTo(sea.surface, t);
    prepared.sample(east, north, {heights, slopesEast, slopesNorth, rates});
  }
  /// The same, and then what C is handed: doubles, and a status each.
  void throughWidenedArrays(double t) {
    throughArrays(t);
    std::copy(heights.begin(), heights.end(), height.begin());
    std::copy(slopesEast.begin(), slopesEast.end(), slopeEast.begin());
    std::copy(slopesNorth.begin(), slopesNorth.end(), slopeNorth.begin());
    std::copy(rates.begin(), rates.end(), rate.begin());
    for (std::size_t i = 0; i < east.size(); ++i) {
      const bool served = seaway::WaveField::serves({east[i], north[i]}, t);
      status[i] = static_cast<std::uint32_t>(served ? seaway::SampleStatus::ok
                                                    : seaway::SampleStatus::outOfRange);
    }
  }
  void throughC(double t) { seaway_sea_sample(handle, t, &points, nullptr, &samples); }
};

void library(benchmark::State& state) {
  Setup setup(static_cast<std::size_t>(state.range(0)));
  double t = 0.0;
  for (auto _ : state) setup.throughLibrary(t += 0.01);
}
void throughC(benchmark::State& state) {
  Setup setup(static_cast<std::size_t>(state.range(0)));
  double t = 0.0;
  for (auto _ : state) setup.throughC(t += 0.01);
}
void arrays(benchmark::State& state) {
  Setup setup(static_cast<std::size_t>(state.range(0)));
  double t = 0.0;
  for (auto _ : state) setup.throughArrays(t += 0.01);
}
BENCHMARK(arrays)->Arg(1)->Arg(1000);
BENCHMARK(library)->Arg(1)->Arg(1000);
BENCHMARK(throughC)->Arg(1)->Arg(1000);

double microseconds(const auto& call) {
  const auto start = std::chrono::steady_clock::now();
  call();
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start)
      .count();
}

double percentile(std::vector<double> values, double part) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

void printRow(std::size_t count, int rounds) {
  Setup setup(count);
  const auto library = [&](double t) { return microseconds([&] { setup.throughLibrary(t); }); };
  const auto arrays = [&](double t) { return microseconds([&] { setup.throughArrays(t); }); };
  const auto c = [&](double t) { return microseconds([&] { setup.throughC(t); }); };
  const auto widened = [&](double t) {
    return microseconds([&] { setup.throughWidenedArrays(t); });
  };
  std::vector<double> times[4], overLibrary, overArrays, overWidened;
  for (int i = 0; i < rounds; ++i) {
    const double t = 0.01 * i;
    // Who goes first changes, so that none finds the warmer cache.
    for (int k = 0; k < 4; ++k) {
      const int who = (i + k) % 4;
      times[who].push_back(who == 0   ? library(t)
                           : who == 1 ? arrays(t)
                           : who == 2 ? widened(t)
                                      : c(t));
    }
    overLibrary.push_back(times[3].back() - times[0].back());
    overArrays.push_back(times[3].back() - times[1].back());
    overWidened.push_back(times[3].back() - times[2].back());
  }
  std::printf("| %zu ", count);
  for (const auto& column : times) {
    std::printf("| %.2f / %.2f / %.2f ", percentile(column, 0.0), percentile(column, 0.5),
                percentile(column, 0.99));
  }
  std::printf("| %+.2f | %+.2f | %+.2f |\n", percentile(overLibrary, 0.5),
              percentile(overArrays, 0.5), percentile(overWidened, 0.5));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && std::strcmp(argv[1], "--table") == 0) {
    std::printf(
        "us, best / median / p99; differences of neighbours, median\n"
        "| points | C++ samples | C++ arrays of floats | the same as doubles with status | C | C - "
        "samples | C - arrays | C - doubles |\n"
        "|---|---|---|---|---|---|---|---|\n");
    for (const std::size_t count : {1, 10, 100, 1000, 10000}) printRow(count, 4000);
    return 0;
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
