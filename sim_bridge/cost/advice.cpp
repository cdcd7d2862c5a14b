#include "sim_bridge/cost/advice.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <string_view>

namespace seaway::bridge {
namespace {

const Study* studyNamed(const std::vector<Study>& studies, std::string_view name) {
  const auto found = std::find_if(studies.begin(), studies.end(), [&](const Study& study) {
    return study.name == name && !study.points.empty();
  });
  return found == studies.end() ? nullptr : &*found;
}

const CostPoint* pointNamed(const Study& study, std::string_view setting) {
  const auto found = std::find_if(study.points.begin(), study.points.end(),
                                  [&](const CostPoint& point) { return point.setting == setting; });
  return found == study.points.end() ? nullptr : &*found;
}

/// The cheapest of a study's points that are at most `error` wrong, or null.
const CostPoint* cheapestWithin(const Study& study, double error) {
  const CostPoint* best = nullptr;
  for (const CostPoint& point : study.points) {
    if (point.error <= error && (!best || point.cost < best->cost)) best = &point;
  }
  return best;
}

const CostPoint& mostAccurate(const Study& study) {
  return *std::min_element(
      study.points.begin(), study.points.end(),
      [](const CostPoint& a, const CostPoint& b) { return a.error < b.error; });
}

/// The last octaves: what they are worth and what they cost.
void adviseOnHeights(const Study& study, std::vector<std::string>& advice) {
  const double sea_m = study.points.front().error;  // without any octave: the sea's own deviation
  const CostPoint& all = mostAccurate(study);
  // Fewest octaves: the last ones cost so little that the machine's noise would choose among them.
  const auto tenth =
      std::find_if(study.points.begin(), study.points.end(),
                   [&](const CostPoint& point) { return point.error <= 0.1 * sea_m; });
  if (tenth == study.points.end() || &*tenth == &all) return;
  advice.push_back(
      fmt::format("Heights within {:.2g} m rms, a tenth of the sea's own deviation, cost {:.0f} ns "
                  "a point ({}); all of the sea costs {:.0f} ns ({}).",
                  tenth->error, tenth->cost, tenth->setting, all.cost, all.setting));
}

void adviseOnBatches(const Study& study, std::vector<std::string>& advice) {
  const CostPoint* single = pointNamed(study, "batches of 1");
  const CostPoint* batch = pointNamed(study, "batches of 64");
  if (!single || !batch) return;
  advice.push_back(fmt::format(
      "Asking for 64 points together costs {:.0f} ns a point, asking one by one {:.0f} ns.",
      batch->cost, single->cost));
}

/// The finest picture, and the cheapest that is within a tenth of a pixel.
void adviseOnPictures(const Study& study, std::vector<std::string>& advice) {
  const CostPoint& finest = mostAccurate(study);
  const CostPoint* tenth = cheapestWithin(study, 0.1);
  if (!tenth || tenth == &finest) return;
  advice.push_back(fmt::format(
      "A {} puts the sea within {:.2g} px rms for {:.3g} ms a frame; a {} within {:.2g} px for "
      "{:.3g} ms.",
      tenth->setting, tenth->error, tenth->cost, finest.setting, finest.error, finest.cost));
}

void adviseOnHulls(const Study& still, const Study& waves, std::vector<std::string>& advice) {
  const CostPoint& columns = mostAccurate(still);
  const CostPoint* mesh = cheapestWithin(waves, 0.1 * columns.error);
  if (!mesh) return;
  advice.push_back(fmt::format(
      "A 12 m hull's buoyancy is within {:.2g} % of its weight for {:.0f} us ({}, with the waves' "
      "own pressure); by {} it is {:.2g} % off, for {:.0f} us.",
      mesh->error, mesh->cost, mesh->setting, columns.setting, columns.error, columns.cost));
}

void adviseOnWakes(const Study& study, std::vector<std::string>& advice) {
  const CostPoint* percent = cheapestWithin(study, 1.0);
  const CostPoint& finest = mostAccurate(study);
  if (!percent || percent == &finest) return;
  advice.push_back(fmt::format(
      "A wake kept by a {} takes {:.0f} us for 0.1 s of sailing, {:.2g} % of its height wrong; by "
      "a {} {:.0f} us, {:.2g} %.",
      percent->setting, percent->cost, percent->error, finest.setting, finest.cost, finest.error));
}

}  // namespace

std::vector<std::string> costAdvice(const std::vector<Study>& studies) {
  std::vector<std::string> advice;
  if (const Study* study = studyNamed(studies, "query_octaves")) adviseOnHeights(*study, advice);
  if (const Study* study = studyNamed(studies, "query_ways")) adviseOnBatches(*study, advice);
  if (const Study* study = studyNamed(studies, "image_position_grid")) {
    adviseOnPictures(*study, advice);
  }
  const Study* columns = studyNamed(studies, "hull_columns");
  const Study* waves = studyNamed(studies, "hull_mesh_dynamic");
  if (columns && waves) adviseOnHulls(*columns, *waves, advice);
  if (const Study* study = studyNamed(studies, "wake_step")) adviseOnWakes(*study, advice);
  return advice;
}

}  // namespace seaway::bridge
