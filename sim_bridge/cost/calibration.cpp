#include "sim_bridge/cost/calibration.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "sim_bridge/cost/study.h"
#include "sim_bridge/report/plot.h"
#include "sim_bridge/scene/sea.h"

namespace seaway::bridge {
namespace {

constexpr std::size_t batch = 1024;

class RandomPlaces {
 public:
  std::vector<glm::dvec2> within(double reach) {
    std::vector<glm::dvec2> points(batch);
    for (glm::dvec2& point : points) point = reach * glm::dvec2(part(), part());
    return points;
  }
  double time() { return 43200.0 * (1.0 + part()); }

 private:
  double part() { return static_cast<double>(random_() >> 11) * 0x1p-52 - 1.0; }
  std::mt19937_64 random_{1};
};

LeftOutCheck checkLeftOut(const WaveField& field, std::size_t kept, int batches) {
  RandomPlaces places;
  LeftOutCheck check{kept, field.leftOut(kept), 0.0, {}};
  const SampleOptions options{.tolerance = field.leftOut(kept)};
  std::vector<SurfaceSample> whole(batch), cut(batch);
  for (int n = 0; n < batches; ++n) {
    const std::vector<glm::dvec2> points = places.within(4e5);
    const FieldAtTime now = field.at(places.time());
    now.sample(points, whole);
    now.sample(points, cut, options);
    for (std::size_t i = 0; i < batch; ++i) {
      const double error = std::abs(whole[i].height - cut[i].height);
      check.measured += error * error;
      for (std::size_t k = 0; k < 3; ++k) {
        check.within[k] += error <= (static_cast<double>(k) + 1.0) * cut[i].error;
      }
    }
  }
  const double all = static_cast<double>(batches) * static_cast<double>(batch);
  check.measured = std::sqrt(check.measured / all);
  for (double& share : check.within) share /= all;
  return check;
}

BoundCheck checkBound(const WaveField& field, double reach, int batches) {
  RandomPlaces places;
  BoundCheck check{reach, 0.0, 0.0};
  std::vector<SurfaceSample> samples(batch), truth(batch);
  for (int n = 0; n < batches; ++n) {
    const std::vector<glm::dvec2> points = places.within(reach);
    const double time = places.time();
    field.sample(points, time, samples);
    field.sampleReference(points, time, truth);
    for (std::size_t i = 0; i < batch; ++i) {
      check.bound = std::max(check.bound, samples[i].bound);
      check.largest = std::max(check.largest, std::abs(samples[i].height - truth[i].height));
    }
  }
  return check;
}

std::string percent(double share) { return fmt::format("{:.1f} %", 100.0 * share); }

using Row = std::vector<std::string>;

/// What a check of coverage says, after its setting.
template <class Check>
Row coverageRow(std::string setting, const Check& check) {
  return {std::move(setting),
          fmt::format("{:.3g}", check.predicted),
          fmt::format("{:.3g}", check.measured),
          percent(check.within[0]),
          percent(check.within[1]),
          percent(check.within[2])};
}

Row coverageHead(const char* setting) {
  return {setting, "predicted, m", "measured, m", "within 1 σ", "within 2 σ", "within 3 σ"};
}

void addLeftOut(const std::vector<LeftOutCheck>& checks, HtmlPage& page) {
  if (checks.empty()) return;
  page.paragraph(
      "What samples state as one standard deviation of the waves that a tolerance leaves out, "
      "beside the rms of what is missing, at random places within 400 km. Of Gaussian errors 68.3, "
      "95.4 and 99.7 % lie within one, two and three.");
  std::vector<Row> rows;
  for (const LeftOutCheck& check : checks) {
    rows.push_back(coverageRow(std::to_string(check.kept), check));
  }
  page.table(coverageHead("octaves"), rows);
}

void addGrids(const std::vector<GridCheck>& checks, HtmlPage& page) {
  if (checks.empty()) return;
  page.paragraph(
      "Heights of the sea that pictures of the first camera show, where pixels lie: one standard "
      "deviation foreseen from where the grid's vertices are, beside the rms difference from the "
      "field, at six times 61 s apart.");
  std::vector<Row> rows;
  for (const GridCheck& check : checks) {
    const std::string side = std::to_string(check.side);
    rows.push_back(coverageRow(side + "x" + side, check));
  }
  page.table(coverageHead("grid"), rows);
}

void addCells(const std::vector<CellCheck>& checks, HtmlPage& page) {
  if (checks.empty()) return;
  page.paragraph(
      "Heights of a wake by the size of its cells: the rms change from cells of twice the size, "
      "which foretells the error to a factor of two, beside the difference from cells of a quarter "
      "of the size or less.");
  std::vector<Row> rows;
  for (const CellCheck& check : checks) {
    rows.push_back({fmt::format("{:g}", check.cell), fmt::format("{:.3g}", check.predicted),
                    fmt::format("{:.3g}", check.measured)});
  }
  page.table({"cell, m", "predicted, m", "measured, m"}, rows);
}

void addBounds(const std::vector<BoundCheck>& checks, HtmlPage& page) {
  if (checks.empty()) return;
  page.paragraph(
      "The bound that samples state for rounding, beside the largest difference from the field in "
      "double precision.");
  std::vector<Row> rows;
  for (const BoundCheck& check : checks) {
    rows.push_back({fmt::format("{:g}", check.reach), fmt::format("{:.2g}", check.bound),
                    fmt::format("{:.2g}", check.largest),
                    fmt::format("{:.1f}", check.bound / check.largest)});
  }
  page.table({"distance up to, m", "bound, m", "largest error, m", "bound / error"}, rows);
}

}  // namespace

Calibration calibrate(const Scene& scene, const Sea& sea, const StudyOptions& options) {
  Calibration calibration;
  calibration.cells = checkWakeCells(scene);
  const WaveField& field = sea.surface.waves();
  const std::size_t count = field.octaves().size();
  if (field.standardDeviation() == 0.0) return calibration;
  const int batches = options.quick ? 16 : 64;
  // Fewer than four octaves left out are no Gaussian sum.
  for (std::size_t kept = 0; kept + 4 <= count; kept += std::max<std::size_t>(1, count / 12)) {
    calibration.leftOut.push_back(checkLeftOut(field, kept, batches));
  }
  for (const double reach : {1e2, 1e3, 1e4, 1e5, 4e5}) {
    calibration.bounds.push_back(checkBound(field, reach, batches));
  }
  calibration.grids = checkGrids(scene, sea, options);
  return calibration;
}

nlohmann::ordered_json asJson(const Calibration& calibration) {
  nlohmann::ordered_json leftOut = nlohmann::ordered_json::array(), bounds = leftOut;
  for (const LeftOutCheck& check : calibration.leftOut) {
    leftOut.push_back({{"octaves", check.kept},
                       {"predicted_m", check.predicted},
                       {"measured_m", check.measured},
                       {"within_1_sigma", check.within[0]},
                       {"within_2_sigma", check.within[1]},
                       {"within_3_sigma", check.within[2]}});
  }
  for (const BoundCheck& check : calibration.bounds) {
    bounds.push_back(
        {{"reach_m", check.reach}, {"bound_m", check.bound}, {"largest_error_m", check.largest}});
  }
  nlohmann::ordered_json grids = nlohmann::ordered_json::array(), cells = grids;
  for (const GridCheck& check : calibration.grids) {
    grids.push_back({{"grid", {check.side, check.side}},
                     {"pixels", check.pixels},
                     {"predicted_m", check.predicted},
                     {"measured_m", check.measured},
                     {"within_1_sigma", check.within[0]},
                     {"within_2_sigma", check.within[1]},
                     {"within_3_sigma", check.within[2]}});
  }
  for (const CellCheck& check : calibration.cells) {
    cells.push_back(
        {{"cell_m", check.cell}, {"predicted_m", check.predicted}, {"measured_m", check.measured}});
  }
  return {{"left_out", std::move(leftOut)},
          {"bounds", std::move(bounds)},
          {"grids", std::move(grids)},
          {"wake_cells", std::move(cells)}};
}

void addCalibration(const Calibration& calibration, HtmlPage& page) {
  if (calibration.leftOut.empty() && calibration.cells.empty()) return;
  page.heading("Predicted against measured errors");
  Plot plot;
  plot.title = "error of the height";
  plot.x = {"predicted, m", true};
  plot.y = {"measured rms, m", true};
  Curve equal{"as predicted", {}, {}};
  const auto addPoints = [&](const char* label, const auto& checks) {
    if (checks.empty()) return;
    Curve curve{label, {}, {}, CurveStyle::points};
    for (const auto& check : checks) {
      if (!(check.predicted > 0.0 && check.measured > 0.0)) continue;  // no place on the axes
      curve.x.push_back(check.predicted);
      curve.y.push_back(check.measured);
      equal.x.push_back(check.predicted);
    }
    plot.curves.push_back(curve);
  };
  addPoints("queries by a tolerance", calibration.leftOut);
  addPoints("pictures by their grid", calibration.grids);
  addPoints("wakes by their cells", calibration.cells);
  std::sort(equal.x.begin(), equal.x.end());
  equal.y = equal.x;
  plot.curves.insert(plot.curves.begin(), equal);
  page.figure(svgOf(plot), "Points on the line: the prediction is right.");
  addLeftOut(calibration.leftOut, page);
  addGrids(calibration.grids, page);
  addCells(calibration.cells, page);
  addBounds(calibration.bounds, page);
}

}  // namespace seaway::bridge
