#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sim_bridge/scene/scene.h"

namespace seaway::bridge {

struct Sea;
class Simulation;

/// A setting that was measured.
struct Setting {
  std::string name;
  double error = 0.0, cost = 0.0;
};

/// Which of `settings` to take: of those with an error of at most `error` and a cost of at most
/// `cost`, as far as they are asked for, the cheapest where an error is asked for, else the most
/// exact. Throws InputError, naming what comes nearest, where there is none; `units` are those of
/// error and cost.
std::size_t chooseSetting(const std::vector<Setting>& settings, std::optional<double> error,
                          std::optional<double> cost, const std::string& what,
                          const std::pair<std::string, std::string>& units);

/// Settings found, and what they will do. A dial nobody asks of stays as it is.
struct Tuning {
  std::optional<double> tolerance;  ///< accuracy.motion_tolerance_m
  std::optional<glm::ivec2> grid;   ///< accuracy.grid
  std::optional<double> wakeCell;   ///< accuracy.wakes.cell_m
  Performance foreseen;
};

/// Measures the scene's dials on this machine and picks settings for what its `accuracy` and
/// `budget` ask. `progress` hears of each of three parts. Throws InputError where that cannot be
/// met or nothing is asked.
Tuning tune(const Scene& scene, const Sea& sea, const std::string& backend,
            const std::function<void(std::size_t done)>& progress = {});

/// Heights as a vessel with the scene's tolerance asks for them, at random places within 10 km, at
/// time `t`: rms error against all octaves, m, and ns a point.
Setting measureQueries(const Scene& scene, const Sea& sea, double t);

/// Place of the sea in the first camera's picture at the simulation's time: rms error against rays
/// in pixels of the scene's own picture, found in one of at most 480 columns; nothing without a
/// camera, or where it sees no water.
std::optional<double> measurePosition(const Scene& scene, const Simulation& simulation,
                                      const std::string& backend);

}  // namespace seaway::bridge
