#include "sim_bridge/commands/cost_report.h"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <limits>

#include "sim_bridge/cost/advice.h"
#include "sim_bridge/report/html_page.h"
#include "sim_bridge/report/plot.h"

namespace seaway::bridge {
namespace {

/// Zero has no place on a logarithmic axis: a gap.
double onAxis(const Axis& axis, double value) {
  return value > 0.0 || !axis.logarithmic ? value : std::numeric_limits<double>::quiet_NaN();
}

/// Errors of a study, as a line with its points, over what `abscissa` takes from them.
template <typename Abscissa>
void addCurves(const Study& study, const std::string& label, Abscissa abscissa, Plot& plot) {
  Curve curve{label, {}, {}};
  for (const CostPoint& point : study.points) {
    curve.x.push_back(onAxis(plot.x, abscissa(point)));
    curve.y.push_back(onAxis(plot.y, point.error));
  }
  plot.curves.push_back(curve);
}

double costOf(const CostPoint& point) { return point.cost; }
double dialOf(const CostPoint& point) { return point.dial; }

/// The settings that no other beats, as a line over cost; beside it all settings, as points.
void addFront(const Study& study, const std::string& label, Plot& plot) {
  Study front = study;
  front.points = paretoFront(study.points);
  addCurves(front, label, costOf, plot);
}
void addSettings(const Study& study, Plot& plot) {
  addCurves(study, "settings", costOf, plot);
  plot.curves.back().style = CurveStyle::points;
}

/// A number with so many digits at least, all of those before the point.
std::string plainText(double value, int digits) {
  if (std::abs(value) >= std::pow(10.0, digits - 1)) return fmt::format("{:.0f}", value);
  return fmt::format("{:.{}g}", value, digits);
}

/// The point of the scene's own setting.
template <typename Abscissa>
void addChosen(const Study& study, Abscissa abscissa, Plot& plot) {
  for (const CostPoint& point : study.points) {
    if (point.setting != study.chosen) continue;
    plot.curves.push_back({"the scene's: " + point.setting,
                           {onAxis(plot.x, abscissa(point))},
                           {onAxis(plot.y, point.error)},
                           CurveStyle::mark});
  }
}

std::string errorLabel(const Study& study) {
  const bool hasUnit = !study.unitError.empty() && study.unitError != "1";
  return hasUnit ? "error, " + study.unitError : "error, relative";
}

/// A cost and its scatter, without exponents.
std::string costText(const CostPoint& point) {
  return fmt::format("{} ± {}", plainText(point.cost, 4), plainText(point.spread, 2));
}

/// Studies of the drawn sea by the grid's size, which share a figure.
bool isByGrid(const Study& study) {
  return study.name.ends_with("_grid") || study.name.starts_with("image_swimming");
}

bool isByTechnique(const Study& study) { return study.name.ends_with("_technique"); }

/// A line a technique, whose name begins its settings.
void addTechniques(const Study& study, HtmlPage& page) {
  Plot plot;
  plot.title = study.name;
  plot.x = {"cost, " + study.unitCost, true};
  plot.y = {errorLabel(study), true};
  for (const CostPoint& point : study.points) {
    const std::string technique = point.setting.substr(0, point.setting.find(' '));
    if (plot.curves.empty() || plot.curves.back().label != technique) {
      plot.curves.push_back({technique, {}, {}});
    }
    plot.curves.back().x.push_back(onAxis(plot.x, point.cost));
    plot.curves.back().y.push_back(onAxis(plot.y, point.error));
  }
  page.figure(svgOf(plot), "Error against cost, a line a technique.");
}

void addStudy(const Study& study, HtmlPage& page) {
  page.heading(study.name);
  page.paragraph(study.summary);
  std::vector<std::vector<std::string>> rows;
  for (const CostPoint& point : study.points) {
    const bool isChosen = point.setting == study.chosen;
    rows.push_back({point.setting + (isChosen ? " (the scene's)" : ""),
                    fmt::format("{:.3g}", point.error), costText(point)});
  }
  page.table({"setting", errorLabel(study), "cost, " + study.unitCost}, rows);
  if (isByTechnique(study)) addTechniques(study, page);
  // Those by the grid are drawn together; settings without a number are no steps of a dial.
  if (isByGrid(study) || study.points.back().dial == 0.0) return;
  if (study.name == "query_octaves") return;  // the page's first figure
  Plot plot;
  plot.title = study.name;
  plot.x = {"cost, " + study.unitCost, true};
  plot.y = {errorLabel(study), true};
  addFront(study, "Pareto front", plot);
  addSettings(study, plot);
  addChosen(study, costOf, plot);
  page.figure(svgOf(plot), "Error against cost: no setting beats those on the line in both.");
}

void addPictures(const std::vector<Study>& studies, HtmlPage& page) {
  Plot byGrid, byCost;
  byGrid.title = "error against the grid's size";
  byGrid.x = {"vertices a side", true};
  byCost.title = "error against cost";
  for (Plot* plot : {&byGrid, &byCost}) plot->y = {"error, px or m", true};
  for (const Study& study : studies) {
    if (!isByGrid(study)) continue;
    const std::string label = study.name + ", " + study.unitError;
    byCost.x = {"cost, " + study.unitCost, true};
    addCurves(study, label, dialOf, byGrid);
    addFront(study, label, byCost);
    if (study.name == "image_position_grid") addChosen(study, costOf, byCost);
  }
  if (byGrid.curves.empty()) return;
  page.heading("Pictures: pixel and metre errors");
  page.figure(svgOf(byGrid), "Errors of the drawn sea by the number of vertices each way.");
  page.figure(svgOf(byCost),
              "The same errors by what a frame costs on this machine, of settings that none beats "
              "in both.");
}

}  // namespace

std::string heightErrorFigure(const std::vector<Study>& studies) {
  Plot plot;
  plot.title = "height error against cost";
  plot.x = {"cost, ns a point"};
  plot.y = {"error, m rms", false, 0.0};  // not logarithmic: the whole sea has no error
  for (const Study& study : studies) {
    if (study.name != "query_octaves") continue;
    addFront(study, "Pareto front", plot);
    addSettings(study, plot);
    plot.curves.back().label = "numbers of octaves";
    addChosen(study, costOf, plot);
  }
  return svgOf(plot);
}

std::string costReport(const std::vector<Study>& studies, const Calibration& calibration,
                       const std::string& scene) {
  HtmlPage page("Seaway: what accuracy costs");
  page.paragraph("Scene " + scene + ", measured in one process on " + machineLine() +
                 ". Costs are medians; "
                 "after ± stands half the distance between quartiles.");
  for (const std::string& sentence : costAdvice(studies)) page.paragraph(sentence);
  page.figure(heightErrorFigure(studies),
              "Height error of queries by what a point costs, from no octave to all.");
  addPictures(studies, page);
  for (const Study& study : studies) {
    if (!study.points.empty()) addStudy(study, page);
  }
  addCalibration(calibration, page);
  return page.text();
}

}  // namespace seaway::bridge
