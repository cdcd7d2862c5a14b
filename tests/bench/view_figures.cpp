#include "tests/bench/view_figures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <glm/geometric.hpp>
#include <utility>

namespace seaway::bench {
namespace {

using render::PixelClass;
using Figure = std::function<double(const ViewFigures&)>;

constexpr std::size_t worstListed = 5;

std::size_t notNumbers(const render::Frame& frame) {
  std::size_t found = 0;
  for (std::size_t i = 0; i < frame.classes.size(); ++i) {
    const float depth = frame.depth.metres[i], length = glm::length(frame.normals[i]);
    const bool isSky = frame.classes[i] == PixelClass::sky;
    const bool depthIsRight = depth > 0.0f && std::isinf(depth) == isSky;
    found += !depthIsRight || !(std::abs(length - (isSky ? 0.0f : 1.0f)) < 1e-3f);
  }
  return found;
}

bool hasWater(const ViewFigures& view) { return view.comparison.compared > 0; }

std::vector<std::pair<const char*, Figure>> figures() {
  return {{"position_rms_px", [](const auto& v) { return v.comparison.positionRms; }},
          {"position_p99_px", [](const auto& v) { return v.comparison.positionPercentile99; }},
          {"depth_median_m", [](const auto& v) { return v.comparison.depthMedian; }},
          {"missing_and_extra_percent", [](const auto& v) { return 100.0 * v.mismatch; }},
          {"far_from_silhouettes_px",
           [](const auto& v) { return static_cast<double>(v.comparison.misplaced); }}};
}

nlohmann::ordered_json spreadOf(std::vector<double> values) {
  if (values.empty()) return {{"views", 0}};
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  return {{"median", at(0.5)}, {"p99", at(0.99)}, {"worst", at(1.0)}, {"views", values.size()}};
}

nlohmann::ordered_json parametersOf(const ViewFigures& v) {
  return {{"number", v.number},
          {"sea", v.sea == render::test::SeaKind::group ? "group" : "perlin"},
          {"wave_height_m", v.waveHeight},
          {"time_s", v.time},
          {"position_m", {v.position.x, v.position.y, v.position.z}},
          {"yaw_pitch_roll_deg",
           {degreesFromRadians(v.yaw), degreesFromRadians(v.pitch), degreesFromRadians(v.roll)}},
          {"fov_deg", degreesFromRadians(v.fieldOfView)}};
}

nlohmann::ordered_json worstViews(const std::vector<ViewFigures>& views, const Figure& figure) {
  std::vector<const ViewFigures*> order;
  for (const ViewFigures& view : views) order.push_back(&view);
  std::sort(order.begin(), order.end(),
            [&](const auto* a, const auto* b) { return figure(*a) > figure(*b); });
  nlohmann::ordered_json worst = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < std::min(worstListed, order.size()); ++i) {
    if (figure(*order[i]) == 0.0) break;
    nlohmann::ordered_json entry{{"figure", figure(*order[i])}};
    entry.update(parametersOf(*order[i]));
    worst.push_back(entry);
  }
  return worst;
}

double largest(const std::vector<ViewFigures>& views, const Figure& figure) {
  double result = 0.0;
  for (const ViewFigures& view : views) result = std::max(result, figure(view));
  return result;
}

}  // namespace

ViewFigures figuresOf(std::uint64_t number, render::test::SeaKind sea,
                      const render::test::RandomView& view, const render::Frame& drawn,
                      const render::Frame& reference) {
  ViewFigures result;
  result.number = number;
  result.sea = sea;
  result.waveHeight = view.waveHeight;
  result.time = view.time;
  result.position = view.camera.position;
  result.yaw = view.yaw;
  result.pitch = view.pitch;
  result.roll = view.roll;
  result.fieldOfView = view.camera.verticalFieldOfView;
  result.comparison = render::compareFrames(view.camera, drawn, reference);
  result.mismatch = static_cast<double>(result.comparison.missing + result.comparison.extra) /
                    static_cast<double>(drawn.classes.size());
  result.hasVertices = drawn.stats.vertices > 0;
  result.vertexEfficiency = drawn.stats.vertexEfficiency;
  result.notNumbers = notNumbers(drawn) + notNumbers(reference);
  return result;
}

std::string worstSoFar(const std::vector<ViewFigures>& views) {
  char line[200];
  std::snprintf(line, sizeof line,
                "%.4f px rms, %.4f px 99 %%, %.4f %% of another class, %.0f far, %.0f not a number",
                largest(views, [](const auto& v) { return v.comparison.positionRms; }),
                largest(views, [](const auto& v) { return v.comparison.positionPercentile99; }),
                largest(views, [](const auto& v) { return 100.0 * v.mismatch; }),
                largest(views, [](const auto& v) { return double(v.comparison.misplaced); }),
                largest(views, [](const auto& v) { return double(v.notNumbers); }));
  return line;
}

nlohmann::ordered_json summaryOf(const std::vector<ViewFigures>& views) {
  nlohmann::ordered_json summary;
  std::size_t withWater = 0, broken = 0;
  std::vector<double> efficiency;
  for (const ViewFigures& view : views) {
    withWater += hasWater(view);
    broken += view.notNumbers;
    if (view.hasVertices) efficiency.push_back(view.vertexEfficiency);
  }
  summary["views"] = views.size();
  summary["views_with_water"] = withWater;
  summary["not_a_number"] = broken;
  for (const auto& [name, figure] : figures()) {
    std::vector<double> values;
    const bool needsWater = std::string(name).ends_with("_px") || std::string(name).ends_with("_m");
    for (const ViewFigures& view : views) {
      if (!needsWater || hasWater(view)) values.push_back(figure(view));
    }
    summary[name] = spreadOf(values);
  }
  summary["vertex_efficiency"] = spreadOf(efficiency);
  for (const auto& [name, figure] : figures()) summary["worst"][name] = worstViews(views, figure);
  return summary;
}

}  // namespace seaway::bench
