#pragma once

#include <optional>
#include <string>
#include <vector>

/// Figures of reports as SVG text, drawn by gnuplot in colours that stay apart for colour-blind
/// readers (Okabe & Ito; viridis for maps). Labels carry their units. Values that are not finite
/// leave gaps. All throw std::runtime_error where gnuplot is missing or fails.
namespace seaway::bridge {

enum class CurveStyle { line, dashed, points, mark, boxes };

struct Curve {
  std::string label;
  std::vector<double> x, y;
  CurveStyle style = CurveStyle::line;
  std::vector<double> width = {};  ///< boxes: of each, in units of x; empty: touching
};

struct Axis {
  std::string label;  ///< with its unit
  bool logarithmic = false;
  std::optional<double> low = {}, high = {};  ///< else from the data
};

/// Curves over one pair of axes.
struct Plot {
  std::string title;
  Axis x, y;
  std::vector<Curve> curves;
};

/// Named bars, one a value.
struct BarPlot {
  std::string title;
  Axis y;
  std::vector<std::string> names;
  std::vector<double> values;
};

/// Values on rings and compass directions, north up: value[ring * directions + direction].
struct PolarMap {
  std::string title;
  std::string valueLabel;             ///< with its unit
  std::string radiusLabel;            ///< with its unit
  std::vector<double> radius;         ///< of the rings, rising
  std::vector<double> direction_deg;  ///< compass, clockwise from north, rising
  std::vector<double> value;
};

std::string svgOf(const Plot& plot);
std::string svgOf(const char* title, const Axis& x, const Axis& y,
                  const std::vector<Curve>& curves);
std::string svgOf(const BarPlot& plot);
std::string svgOf(const PolarMap& map);

/// Throws std::runtime_error unless plots can be drawn here; to be asked before long work.
void requirePlotter();

}  // namespace seaway::bridge
