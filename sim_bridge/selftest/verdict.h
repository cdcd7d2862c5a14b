#pragma once

#include <filesystem>
#include <string>

#include "sim_bridge/selftest/child_run.h"

namespace seaway::bridge {

/// What is asked of a command.
enum class Expected {
  works,    ///< status 0
  refuses,  ///< status 2 and a message
  either,   ///< one of the two
};

struct Expectation {
  Expected status = Expected::either;
  /// Regular expression (ECMAScript) that standard output or standard error must match somewhere;
  /// empty: any.
  std::string says = {};
  bool namesFile = false;  ///< a refusal must tell file and line: `FILE.yaml:LINE`
};

/// What is wrong with what a command did; empty where nothing is. Wrong are a signal, a time-out, a
/// status other than 0 or 2, a refusal without a message, a message of the C++ runtime's, numbers
/// that are none in standard output or in tables under `folder`, and files left under `folder` by a
/// command that refused.
std::string faultOf(const ChildOutcome& outcome, const Expectation& expectation,
                    const std::filesystem::path& folder);

}  // namespace seaway::bridge
