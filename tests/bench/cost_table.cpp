#include "tests/bench/cost_table.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "surface/field/kernels/field_blocks.h"
#include "tests/bench/accuracy.h"

namespace seaway::bench {
namespace {

/// Keeps the counters of every repetition.
class Collector : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
      const std::string name = run.benchmark_name();
      for (const auto& [counter, value] : run.counters) values_[name][counter].push_back(value);
    }
  }

  bool has(const std::string& name) const { return values_.count(name) > 0; }

  /// Median over repetitions; negative where there is none.
  double median(const std::string& name, const std::string& counter) const {
    const auto run = values_.find(name);
    if (run == values_.end()) return -1.0;
    const auto found = run->second.find(counter);
    if (found == run->second.end()) return -1.0;
    std::vector<double> sorted = found->second;
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
  }
  double pointTime(const std::string& name) const { return median(name, "ns_per_point"); }

 private:
  std::map<std::string, std::map<std::string, std::vector<double>>> values_;
};

std::string text(const char* format, double value) {
  if (value < 0.0) return "";
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

void printRows(const std::vector<std::string>& names, const Collector& times,
               const std::map<std::string, Accuracy>& accuracy) {
  std::printf(
      "| setting | ns/point | ns/point/octave | ms/step | rms height error, m | "
      "spectral residual | memory, KiB |\n|---|---:|---:|---:|---:|---:|---:|\n");
  for (const std::string& name : names) {
    if (!times.has(name)) continue;
    const auto found = accuracy.find(name);
    const Accuracy worth = found == accuracy.end() ? Accuracy{-1.0, -1.0, 0} : found->second;
    const double kibibytes = static_cast<double>(worth.memoryBytes) / 1024.0;
    std::printf("| %s | %s | %s | %s | %s | %s | %s |\n", name.c_str(),
                text("%.2f", times.pointTime(name)).c_str(),
                text("%.3f", times.median(name, "ns_per_point_octave")).c_str(),
                text("%.3f", times.median(name, "ms_per_step")).c_str(),
                text("%.2g", worth.heightError).c_str(),
                text("%.3f", worth.spectralResidual).c_str(),
                text("%.1f", worth.memoryBytes == 0 ? -1.0 : kibibytes).c_str());
  }
}

void printRatio(const char* what, double above, double below) {
  if (above > 0.0 && below > 0.0) std::printf("- %s: %.3f\n", what, above / below);
}

/// Points a step from which a tile's step and look-ups cost less than the field's points.
void printCrossover(const Collector& times, const std::string& tile, const char* lookUp,
                    const std::string& step) {
  const double group = times.pointTime("field/group/12/1024");
  const double point = times.pointTime(tile + lookUp + std::string("/1024"));
  const double perStep = times.median(tile + step, "ms_per_step");
  if (group < 0.0 || point < 0.0 || perStep < 0.0) return;
  std::printf("- %s%s against 12 group octaves: ", tile.c_str(), lookUp);
  if (point >= group)
    std::printf("never cheaper\n");
  else
    std::printf("cheaper from %.0f points a step\n", 1e6 * perStep / (group - point));
}

void printSummary(const Collector& times) {
  const auto ns = [&](const char* name) { return times.pointTime(name); };
  const double group = ns("field/group/12/1024");
  printRatio("group/perlin", group, ns("field/perlin/12/1024"));
  printRatio("group/200 sines", group, ns("field/sines/200/1024"));
  printRatio("group/perlin, AVX2", ns("field/group_avx2/12/1024"), ns("field/perlin_avx2/12/1024"));
  printRatio("group/200 sines, AVX2", ns("field/group_avx2/12/1024"),
             ns("field/sines_avx2/200/1024"));
  printRatio("batch of 64/batch of 1024", ns("field/group/12/64"), group);
  printRatio("height alone/all", ns("field/height/12/1024"), group);
  printRatio("beside lattice lines/anywhere", ns("field/lattice_lines/12/1024"), group);
  printRatio("orbital/whole samples", ns("field/group_orbital/12/1024"),
             ns("field/group_samples/12/1024"));
  printRatio("two threads, speed-up by the clock",
             times.median("field/group/12/65536", "wall_ns_per_point"),
             ns("field/two_threads/65536"));
  for (const char* tile : {"field/fft256", "field/fft512"}) {
    printCrossover(times, tile, "_bilinear", "_step");
    printCrossover(times, tile, "_bicubic", "_step");
  }
  printCrossover(times, "field/cached", "_bilinear", "_step");
  printCrossover(times, "field/cached", "_cubic", "_step");
}

}  // namespace

void printCostTable(const std::vector<std::string>& names) {
  Collector times;
  benchmark::RunSpecifiedBenchmarks(&times);
  std::printf("Kernels: %s. Medians of CPU time; JONSWAP 1.12 m, 5.6 s, 3.3.\n\n", kernelTarget());
  printRows(names, times, measureAccuracy());
  std::printf("\n");
  printSummary(times);
}

}  // namespace seaway::bench
