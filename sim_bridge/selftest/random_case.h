#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "sim_bridge/selftest/hard_case.h"

namespace seaway::bridge {

/// A command on a scene at random: as the tables allow, or (a third of them) with one thing broken,
/// which must be refused with a message that names file and line. The same `seed` and `examples`
/// (scene files) give the same case.
HardCase randomCase(std::uint64_t seed, const std::vector<std::filesystem::path>& examples);

/// The same case with as little in its scene as still fails: keys and items are left out one after
/// another as long as `fails`, which is asked at most `most` times.
HardCase shrunk(HardCase hardCase, const std::function<bool(const HardCase&)>& fails, int most);

}  // namespace seaway::bridge
