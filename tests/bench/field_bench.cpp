#include <benchmark/benchmark.h>

#include <cstring>
#include <vector>

#include "tests/bench/cases.h"
#include "tests/bench/cost_table.h"

/// What a point of the sea costs, beside other ways to make a sea: see cases.h.
///
///   field_bench                medians of interleaved repetitions
///   field_bench --table        time beside error, as Markdown
///
/// Flags of Google Benchmark are understood and override the defaults below.
int main(int argc, char** argv) {
  char interleave[] = "--benchmark_enable_random_interleaving=true";
  char repeat[] = "--benchmark_repetitions=9";
  char shortly[] = "--benchmark_min_time=0.05";
  char aggregates[] = "--benchmark_display_aggregates_only=true";
  bool table = false;
  std::vector<char*> arguments{argv[0], interleave, repeat, shortly};
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--table") == 0)
      table = true;
    else
      arguments.push_back(argv[i]);
  }
  // The table takes its own medians, of every repetition.
  if (!table) arguments.insert(arguments.begin() + 1, aggregates);
  int count = static_cast<int>(arguments.size());
  arguments.push_back(nullptr);
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 1;
  const auto names = seaway::bench::registerFieldCases();
  if (table)
    seaway::bench::printCostTable(names);
  else
    benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
