#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>

// Smallest and largest of many, in eight places side by side: a compiler makes vectors of them,
// where one place would wait for itself at each value (2 µs of 1000). NaN is neither.
namespace seaway::bridge {

inline constexpr std::size_t placesSideBySide = 8;

struct Extremes {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

inline Extremes extremesOf(std::span<const double> values) noexcept {
  std::array<double, placesSideBySide> low, high;
  low.fill(Extremes().low);
  high.fill(Extremes().high);
  const auto take = [&](std::size_t place, double value) {
    low[place] = value < low[place] ? value : low[place];
    high[place] = value > high[place] ? value : high[place];
  };
  std::size_t i = 0;
  for (; i + placesSideBySide <= values.size(); i += placesSideBySide) {
    for (std::size_t place = 0; place < placesSideBySide; ++place) take(place, values[i + place]);
  }
  for (; i < values.size(); ++i) take(0, values[i]);
  return {*std::min_element(low.begin(), low.end()), *std::max_element(high.begin(), high.end())};
}

/// The largest of value(0) … value(count - 1); minus infinity where there are none.
template <class Value>
double largestOf(std::size_t count, const Value& value) noexcept {
  std::array<double, placesSideBySide> high;
  high.fill(Extremes().high);
  const auto take = [&](std::size_t place, double each) {
    high[place] = each > high[place] ? each : high[place];
  };
  std::size_t i = 0;
  for (; i + placesSideBySide <= count; i += placesSideBySide) {
    for (std::size_t place = 0; place < placesSideBySide; ++place) take(place, value(i + place));
  }
  for (; i < count; ++i) take(0, value(i));
  return *std::max_element(high.begin(), high.end());
}

}  // namespace seaway::bridge
