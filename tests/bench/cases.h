#pragma once

#include <string>
#include <vector>

namespace seaway::bench {

/// Registers field/KIND/OCTAVES/BATCH and its rivals. Counters, CPU time: `ns_per_point`,
/// `ns_per_point_octave` (or component), `ms_per_step`; `wall_ns_per_point` by the clock, which is
/// also what field/two_threads reports as `ns_per_point`. Returns the names in order.
std::vector<std::string> registerFieldCases();

}  // namespace seaway::bench
