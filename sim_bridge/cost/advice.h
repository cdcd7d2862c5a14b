#pragma once

#include <string>
#include <vector>

#include "sim_bridge/cost/study.h"

namespace seaway::bridge {

/// What a user may do about the studies' figures, a sentence each, of heights, ways to ask,
/// pictures, hulls and wakes: those that `studies` hold. Every number is one of a study's points.
std::vector<std::string> costAdvice(const std::vector<Study>& studies);

}  // namespace seaway::bridge
