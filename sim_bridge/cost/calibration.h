#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <vector>

#include "sim_bridge/report/html_page.h"

namespace seaway::bridge {

struct Sea;
struct StudyOptions;

/// Heights with `kept` octaves: the error that samples state, and the one that they have.
struct LeftOutCheck {
  std::size_t kept = 0;
  double predicted = 0.0;          ///< `SurfaceSample::error`, one standard deviation, m
  double measured = 0.0;           ///< rms difference from all octaves, m
  std::array<double, 3> within{};  ///< share of differences within 1, 2 and 3 standard deviations
};

/// Rounding at points up to `reach` m from the anchor: the bound that samples state, and the
/// largest difference from the field in double precision.
struct BoundCheck {
  double reach = 0.0, bound = 0.0, largest = 0.0;
};

/// Whether what samples of a sea say of their own errors is so.
struct Calibration {
  std::vector<LeftOutCheck> leftOut;
  std::vector<BoundCheck> bounds;
};

/// Random points within 400 km at random times of a day. Empty for flat water.
Calibration calibrate(const Sea& sea, const StudyOptions& options);

nlohmann::ordered_json asJson(const Calibration& calibration);

/// Plot and tables of predicted against measured errors.
void addCalibration(const Calibration& calibration, HtmlPage& page);

}  // namespace seaway::bridge
