#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "sim_bridge/cost/study.h"
#include "sim_bridge/output/number_text.h"
#include "sim_bridge/scene/sea.h"
#include "surface/hull/analytic_hulls.h"
#include "surface/hull/hull_loads.h"

namespace seaway::bridge {
namespace {

constexpr double length = 12.0, beam = 3.6, draft = 0.8, freeboard = 1.0;

HullModel modelOf(LoadLevel level, std::size_t triangles, glm::ivec2 columns,
                  std::optional<double> cutoff) {
  HullSettings settings;
  settings.level = level;
  settings.mass = seaWaterDensity * 4.0 / 9.0 * length * beam * draft;
  settings.knownVolume = 4.0 / 9.0 * length * beam * draft;
  settings.columns = columns;
  settings.shortestWavelength = cutoff;
  return {wigleyMesh(length, beam, draft, freeboard, triangles), settings};
}

/// The same hull about the sea, upright and leaning, at rest.
std::vector<HullPose> poses(int count) {
  std::mt19937_64 random(2);
  const auto uniform = [&](double reach) {
    return (2.0 * static_cast<double>(random() >> 11) * 0x1p-53 - 1.0) * reach;
  };
  std::vector<HullPose> all(static_cast<std::size_t>(count));
  for (HullPose& pose : all) {
    pose.position = {uniform(5e3), uniform(5e3), uniform(0.1)};
    pose.worldFromBody = glm::angleAxis(uniform(3.1), glm::dvec3(0.0, 0.0, 1.0)) *
                         glm::angleAxis(uniform(0.05), glm::dvec3(0.0, 1.0, 0.0)) *
                         glm::angleAxis(uniform(0.15), glm::dvec3(1.0, 0.0, 0.0));
  }
  return all;
}

struct Measured {
  std::vector<glm::dvec3> forces;
  Timing timing;
};

Measured measure(const HullModel& hull, const SurfaceAtTime& water,
                 const std::vector<HullPose>& all, int repetitions) {
  Measured result;
  result.forces.resize(all.size());
  LoadScratch scratch;
  result.timing = timeRepeated(
      [&] {
        for (std::size_t i = 0; i < all.size(); ++i) {
          result.forces[i] = loads(hull, all[i], water, scratch).buoyancy.force;
        }
      },
      repetitions);
  return result;
}

/// Rms of the difference of forces, % of the hull's weight.
double errorOf(const Measured& found, const Measured& truth, double weight) {
  double sum = 0.0;
  for (std::size_t i = 0; i < found.forces.size(); ++i) {
    const glm::dvec3 off = found.forces[i] - truth.forces[i];
    sum += glm::dot(off, off);
  }
  return 100.0 * std::sqrt(sum / static_cast<double>(found.forces.size())) / weight;
}

}  // namespace

std::vector<Study> studyHullLoads(const Sea& sea, const StudyOptions& options) {
  const auto all = poses(options.quick ? 20 : 100);
  const int repetitions = options.quick ? 3 : 9;
  const SurfaceAtTime water = sea.surface.at(12.0);
  const HullModel truthHull = modelOf(LoadLevel::meshDynamic, 13000, {20, 20}, 0.0);
  const Measured truth = measure(truthHull, water, all, 3);
  const double weight = truthHull.settings().mass * standardGravity;
  const auto add = [&](Study& study, const std::string& setting, const HullModel& hull) {
    const Measured found = measure(hull, water, all, repetitions);
    const double each = 1e6 / static_cast<double>(all.size());
    study.points.push_back({setting, errorOf(found, truth, weight), found.timing.median * each,
                            found.timing.spread * each,
                            static_cast<double>(study.points.size() + 1)});
  };
  const std::string summary =
      "buoyancy of a 12 m Wigley hull about the sea, rms; truth: 13 000 triangles with the waves' "
      "pressure, all octaves; ";
  const auto study = [&](const char* name, const char* dial) {
    return Study{name, summary + dial, "% of weight", "us/evaluation", {}};
  };
  Study columns = study("hull_columns", "columns along and across");
  for (const int n : {5, 10, 20}) {
    add(columns, "columns " + std::to_string(n) + "x" + std::to_string(n / 5 * 2),
        modelOf(LoadLevel::columns, 800, {n, n / 5 * 2}, 0.0));
  }
  Study mesh = study("hull_mesh", "triangles with hydrostatic pressure");
  Study dynamic = study("hull_mesh_dynamic", "triangles with the waves' pressure");
  for (const std::size_t triangles : {200, 800, 3200}) {
    const std::string name = "triangles " + std::to_string(triangles);
    add(mesh, name, modelOf(LoadLevel::mesh, triangles, {20, 20}, 0.0));
    add(dynamic, name, modelOf(LoadLevel::meshDynamic, triangles, {20, 20}, 0.0));
  }
  Study cutoffs = study("hull_cutoffs", "800 triangles, by the shortest waves kept");
  for (const double part : {2.0, 1.0, 0.5, 0.25, 0.0}) {
    add(cutoffs, numberText(part) + " L",
        modelOf(LoadLevel::meshDynamic, 800, {20, 20}, part * length));
  }
  return {columns, mesh, dynamic, cutoffs};
}

}  // namespace seaway::bridge
