#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim_bridge/selftest/verdict.h"

namespace seaway::bridge {

/// A command on a scene, and what is asked of it.
struct HardCase {
  std::string name;
  std::string area;              ///< such as "pictures"
  std::string property;          ///< what must hold, for people
  nlohmann::ordered_json scene;  ///< null: the command needs none
  /// Words of the command line; SCENE stands for the scene's file, OUT for a fresh folder.
  std::vector<std::string> arguments;
  Expectation expectation;
  /// Doors that a service opens: once they are open it is asked through them (served_case.h) and
  /// then ended by SIGTERM; 0: the command ends by itself.
  int endpoints = 0;
};

/// Hard cases of one area that tests of the tree try, by ctest's names.
struct HardTests {
  std::string area;
  std::string covers;  ///< for people
  std::string tests;   ///< regular expression for `ctest -L hard -R`
};

struct HardCases {
  std::vector<HardCase> cases;
  std::vector<HardTests> tests;
};

/// Reads the catalogue. Each case's scene is a scene file's content with single values replaced;
/// paths in it become absolute. Throws InputError.
HardCases readHardCases(const std::filesystem::path& file);

/// Runs a case with `program` in a folder that is gone afterwards. Returns what is wrong, empty
/// where nothing is; `seconds` says how long it took.
std::string tryCase(const HardCase& hardCase, const std::filesystem::path& program,
                    const ChildLimits& limits, double* seconds = nullptr);

}  // namespace seaway::bridge
