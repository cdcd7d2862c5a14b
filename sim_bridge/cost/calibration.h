#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <vector>

#include "sim_bridge/report/html_page.h"

namespace seaway::bridge {

struct Scene;
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

/// Heights of the sea that pictures show, of a grid of `side` by `side` vertices: the error
/// foreseen from its spacing (render::GridError), and the one that pixels have.
struct GridCheck {
  int side = 0, pixels = 0;
  double predicted = 0.0;          ///< rms over the pixels of one standard deviation, m
  double measured = 0.0;           ///< rms difference from the field, m
  std::array<double, 3> within{};  ///< share of pixels within 1, 2 and 3 standard deviations
};

/// Heights of a vessel's wake by cells of `cell` m: the error foreseen from what cells of twice the
/// size change, and the difference from cells of a quarter of the size or less. Cells leave out
/// short waves; those that twice the size leaves out besides are the longest of them, and mostly
/// the highest. Only where eight cells or more lie on the longest waves that keep up with the
/// vessel, 2πU²/g in deep water: of waves that cells do not carry they foretell nothing.
struct CellCheck {
  double cell = 0.0, predicted = 0.0, measured = 0.0;  ///< m; rms, m; rms, m
};

/// Whether what samples of a sea say of their own errors is so.
struct Calibration {
  std::vector<LeftOutCheck> leftOut;
  std::vector<BoundCheck> bounds;
  std::vector<GridCheck> grids;
  std::vector<CellCheck> cells;
};

/// Random points within 400 km at random times of a day; what the scene's first camera sees of the
/// sea, 6 times from its start on, 61 s apart, where it is above the water; the wake of its first
/// vessel under way. Flat water and scenes without these have none.
Calibration calibrate(const Scene& scene, const Sea& sea, const StudyOptions& options);

/// Parts of it.
std::vector<GridCheck> checkGrids(const Scene& scene, const Sea& sea, const StudyOptions& options);
std::vector<CellCheck> checkWakeCells(const Scene& scene);

nlohmann::ordered_json asJson(const Calibration& calibration);

/// Plot and tables of predicted against measured errors.
void addCalibration(const Calibration& calibration, HtmlPage& page);

}  // namespace seaway::bridge
