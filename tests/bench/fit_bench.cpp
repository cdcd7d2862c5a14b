// Time of fits (Google Benchmark); `fit_bench --sweep FOLDER [STARTS]` fits all records of an NDBC
// station's five files 41010.* in a folder, moors a buoy in each field, and prints how well they
// agree.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <vector>

#include "sim_bridge/commands/fit_verification.h"
#include "surface/angles.h"
#include "surface/fit/octave_fit.h"
#include "surface/fit/sea_parameters.h"
#include "surface/spectra/families.h"
#include "surface/spectra/readers/read_spectra.h"

namespace seaway {
namespace {

/// A JONSWAP sea on a buoy's 46 bins, with directions.
DirectionalSpectrum buoySea() {
  DirectionalSpectrum sea;
  const FrequencySpectrum family = jonswap({2.0, 8.0, 3.3});
  for (int i = 0; i < 46; ++i) {
    const double f = 0.04 + 0.01 * i;
    const double r1 = 0.9 - 0.4 * std::abs(f - 0.125);
    sea.energy.frequency.push_back(f);
    sea.energy.density.push_back(family.at(f));
    sea.moments.push_back({r1 * std::cos(1.0 + f), r1 * std::sin(1.0 + f)});
  }
  return sea;
}

void fitFrequencies(benchmark::State& state) {
  OctaveFitOptions options;
  options.octaves = static_cast<int>(state.range(0));
  const FrequencySpectrum target = buoySea().energy;
  for (auto step : state) benchmark::DoNotOptimize(fitGroupOctaves(target, options));
}
BENCHMARK(fitFrequencies)->Arg(12)->Arg(24)->Unit(benchmark::kMillisecond);

void fitDirections(benchmark::State& state) {
  OctaveFitOptions options;
  options.octaves = static_cast<int>(state.range(0));
  const DirectionalSpectrum target = buoySea();
  for (auto step : state) benchmark::DoNotOptimize(fitGroupOctaves(target, options));
}
BENCHMARK(fitDirections)->Arg(16)->Arg(24)->Unit(benchmark::kMillisecond);

void fitParameters(benchmark::State& state) {
  const DirectionalSpectrum target = buoySea();
  for (auto step : state) {
    benchmark::DoNotOptimize(
        fitSeaParameters(target, {.systems = static_cast<int>(state.range(0))}));
  }
}
BENCHMARK(fitParameters)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond);

void fitBatch(benchmark::State& state) {
  OctaveFitOptions options;
  options.octaves = 12;
  DirectionalSpectrum target = buoySea();
  target.moments.clear();
  const std::vector<DirectionalSpectrum> targets(static_cast<std::size_t>(state.range(0)), target);
  for (auto step : state) {
    benchmark::DoNotOptimize(
        fitGroupOctaves(std::span<const DirectionalSpectrum>(targets), options));
  }
}
BENCHMARK(fitBatch)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

void print(const char* name, std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
  };
  std::printf("%-44s median %8.4f  97 %% %8.4f  worst %8.4f\n", name, at(0.5), at(0.97), at(1.0));
}

int sweep(const std::filesystem::path& folder, int starts) {
  const auto records =
      readSpectra({folder / "41010.data_spec", folder / "41010.swdir", folder / "41010.swdir2",
                   folder / "41010.swr1", folder / "41010.swr2"});
  std::vector<DirectionalSpectrum> targets;
  for (const SpectrumRecord& record : records) targets.push_back(record.spectrum);
  OctaveFitOptions options;
  options.octaves = 16;
  options.starts = starts;
  const auto fits = fitGroupOctaves(std::span<const DirectionalSpectrum>(targets), options);
  std::vector<double> residual, height, period, waveNumber, heights, periods;
  std::vector<double> direction, directions, spread, spreads;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    const OctaveFitSummary& s = fits[i].summary;
    if (!s.usable) {
      std::printf("%s: %s\n", records[i].time.c_str(), s.message.c_str());
      continue;
    }
    residual.push_back(s.residualL2);
    height.push_back(100.0 * std::abs(s.hm0Band / s.hm0Target - 1.0));
    period.push_back(100.0 * std::abs(s.tm02Fit / s.tm02Target - 1.0));
    waveNumber.push_back(100.0 * s.waveNumberDeviation);
    const auto buoy = bridge::verifyWithBuoy(targets[i], fits[i], options.depth, i + 1, 3.0);
    heights.push_back(buoy.quantities[0].deviations());
    periods.push_back(buoy.quantities[1].deviations());
    if (buoy.quantities.size() < 4) continue;
    direction.push_back(std::abs(buoy.quantities[2].read - buoy.quantities[2].asked));
    directions.push_back(buoy.quantities[2].deviations());
    const double r1 = 1.0 - 0.5 * std::pow(radiansFromDegrees(buoy.quantities[3].asked), 2);
    if (r1 < 0.5) continue;
    spread.push_back(std::abs(buoy.quantities[3].read - buoy.quantities[3].asked));
    spreads.push_back(buoy.quantities[3].deviations());
  }
  std::printf("%zu records, 16 octaves, %d starts; buoy: 3 h\n", fits.size(), starts);
  print("residual of S(f), relative L2", residual);
  print("H_m0 over the band, % off", height);
  print("T_m02, % off", period);
  print("wave numbers off the dispersion relation, %", waveNumber);
  print("buoy: H_m0, standard errors off", heights);
  print("buoy: T_m02, standard errors off", periods);
  print("buoy: direction at the peak, deg off", direction);
  print("buoy: direction, standard errors off", directions);
  print("buoy: spread at the peak (r1 >= 0.5), deg off", spread);
  print("buoy: spread, standard errors off", spreads);
  return 0;
}

}  // namespace
}  // namespace seaway

int main(int argc, char** argv) {
  if (argc >= 3 && std::strcmp(argv[1], "--sweep") == 0) {
    return seaway::sweep(argv[2], argc > 3 ? std::atoi(argv[3]) : 4);
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
