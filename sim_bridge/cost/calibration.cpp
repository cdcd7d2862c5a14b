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

}  // namespace

Calibration calibrate(const Sea& sea, const StudyOptions& options) {
  Calibration calibration;
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
  return {{"left_out", std::move(leftOut)}, {"bounds", std::move(bounds)}};
}

void addCalibration(const Calibration& calibration, HtmlPage& page) {
  if (calibration.leftOut.empty()) return;
  page.heading("Predicted against measured errors");
  page.paragraph(
      "What samples state as one standard deviation of the waves that a tolerance leaves out, "
      "beside the rms of what is missing, at random places within 400 km. Of Gaussian errors 68.3, "
      "95.4 and 99.7 % lie within one, two and three.");
  Curve measured{"measured", {}, {}, CurveStyle::points}, equal{"as predicted", {}, {}};
  std::vector<std::vector<std::string>> rows;
  for (const LeftOutCheck& check : calibration.leftOut) {
    measured.x.push_back(check.predicted);
    measured.y.push_back(check.measured);
    equal.x.push_back(check.predicted);
    equal.y.push_back(check.predicted);
    rows.push_back({std::to_string(check.kept), fmt::format("{:.3g}", check.predicted),
                    fmt::format("{:.3g}", check.measured), percent(check.within[0]),
                    percent(check.within[1]), percent(check.within[2])});
  }
  Plot plot;
  plot.title = "error of the height";
  plot.x = {"predicted, m", true};
  plot.y = {"measured rms, m", true};
  plot.curves = {equal, measured};
  page.figure(svgOf(plot), "Points on the line: the prediction is right.");
  page.table({"octaves", "predicted, m", "measured, m", "within 1 σ", "within 2 σ", "within 3 σ"},
             rows);
  page.paragraph(
      "The bound that samples state for rounding, beside the largest difference from the field in "
      "double precision.");
  rows.clear();
  for (const BoundCheck& check : calibration.bounds) {
    rows.push_back({fmt::format("{:g}", check.reach), fmt::format("{:.2g}", check.bound),
                    fmt::format("{:.2g}", check.largest),
                    fmt::format("{:.1f}", check.bound / check.largest)});
  }
  page.table({"distance up to, m", "bound, m", "largest error, m", "bound / error"}, rows);
}

}  // namespace seaway::bridge
