#include "render/row_fit.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace seaway::render {
namespace {

using Interval = VisibleShadow::Interval;
using Strip = VisibleShadow::Strip;

constexpr double leastShareOfWidest = 0.05;

void widen(std::optional<Interval>& row, Interval by) {
  row = row ? Interval{std::min(row->least, by.least), std::max(row->most, by.most)} : by;
}

/// A row is as wide as the strips before and behind it ask for.
std::vector<std::optional<Interval>> rowsOf(const std::vector<std::optional<Strip>>& strips) {
  std::vector<std::optional<Interval>> rows(strips.size() + 1);
  for (std::size_t i = 0; i < strips.size(); ++i) {
    if (!strips[i]) continue;
    widen(rows[i], strips[i]->near);
    widen(rows[i + 1], strips[i]->far);
  }
  return rows;
}

/// Rows without a width take that of the row before, the first ones that of the first with one.
std::vector<Interval> filled(const std::vector<std::optional<Interval>>& rows) {
  const auto first = std::find_if(rows.begin(), rows.end(), [](const auto& row) { return row; });
  Interval last = first != rows.end() ? **first : Interval{};
  std::vector<Interval> result(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) result[i] = last = rows[i].value_or(last);
  return result;
}

}  // namespace

std::vector<Interval> fittedRows(const VisibleShadow& shadow, std::span<const double> along,
                                 std::span<const double> sight) {
  std::vector<std::optional<Strip>> strips(along.size() - 1);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, strips.size(), 64),
                    [&](const tbb::blocked_range<std::size_t>& range) {
                      for (std::size_t i = range.begin(); i != range.end(); ++i) {
                        strips[i] = shadow.cover(along[i], along[i + 1]);
                      }
                    });
  std::vector<Interval> ends = filled(rowsOf(strips));
  double widest = 0.0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    widest = std::max(widest, (ends[i].most - ends[i].least) / sight[i]);
  }
  for (std::size_t i = 0; i < ends.size(); ++i) {
    Interval& row = ends[i];
    const double width = row.most - row.least;
    const double lacking = std::max(leastShareOfWidest * widest * sight[i] - width, 0.0);
    // A hair more than the picture, so that rounding, single precision's too, leaves no gap.
    const double hair = 1e-4 * width + 1e-9 +
                        2e-7 * (std::abs(along[i]) + std::abs(row.least) + std::abs(row.most));
    row = {row.least - 0.5 * lacking - hair, row.most + 0.5 * lacking + hair};
  }
  return ends;
}

}  // namespace seaway::render
