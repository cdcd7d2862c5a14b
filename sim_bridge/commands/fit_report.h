#pragma once

#include <filesystem>

#include "sim_bridge/commands/fit_result.h"

namespace seaway::bridge {

/// Writes `sea.yaml` and a self-contained `report.html` into a folder, each whole or not at all.
/// Throws InputError where it cannot write, std::runtime_error where figures cannot be drawn.
void writeFitReport(const FitResult& result, const std::filesystem::path& folder);

}  // namespace seaway::bridge
