#pragma once

#include <string>
#include <vector>

namespace seaway::bench {

/// Runs all registered benchmarks and prints time beside error as one Markdown table, medians over
/// repetitions, in the order of `names`, with the ratios that the field promises and the crossover
/// with FFT tiles.
void printCostTable(const std::vector<std::string>& names);

}  // namespace seaway::bench
