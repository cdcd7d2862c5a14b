#include "surface/spectra/readers/direction_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "surface/angles.h"
#include "surface/spectra/readers/text_cursor.h"

namespace seaway {
namespace {

std::string degrees(double radians) {
  std::string text = std::to_string(degreesFromRadians(radians));
  return text.substr(0, text.find('.') + 3) + " deg";
}

double wrapped(double angle) {
  const double turn = 2.0 * pi;
  const double rest = std::fmod(angle, turn);
  return rest < 0.0 ? rest + turn : rest;
}

}  // namespace

DirectionGrid::DirectionGrid(const std::vector<double>& toward, const TextCursor& cursor) {
  const std::size_t columns = toward.size();
  if (columns < 3 || columns > 3600) {
    cursor.fail(std::to_string(columns) + " directions are not allowed; must be in [3, 3600]");
  }
  std::vector<std::size_t> order(columns);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return wrapped(toward[a]) < wrapped(toward[b]); });
  // From each to the next, the last one across the end of the turn.
  std::vector<double> gaps(columns);
  for (std::size_t i = 0; i < columns; ++i) {
    gaps[i] = wrapped(toward[order[(i + 1) % columns]] - toward[order[i]]);
  }
  // The widest gap is what a sector leaves out, or one like the others.
  const double widest = *std::max_element(gaps.begin(), gaps.end());
  const double mean = (2.0 * pi - widest) / static_cast<double>(columns - 1);
  if (!(mean > 2.0 * pi / 3601.0)) cursor.fail("directions closer than 0.1 deg are not allowed");
  const auto count = static_cast<std::size_t>(std::lround(2.0 * pi / mean));
  const double spacing = 2.0 * pi / static_cast<double>(count);
  std::vector<std::size_t> step(columns);
  std::size_t total = 0;
  for (std::size_t i = 0; i < columns; ++i) {
    step[i] = static_cast<std::size_t>(std::lround(gaps[i] / spacing));
    const double error = std::abs(gaps[i] - static_cast<double>(step[i]) * spacing);
    total += step[i];
    if (step[i] == 0 || error > 0.1 * spacing) {
      cursor.fail("directions must be even over a turn or a sector of it; after " +
                  degrees(toward[order[i]]) + " comes " +
                  degrees(toward[order[(i + 1) % columns]]));
    }
  }
  if (total != count) cursor.fail("directions do not make one turn");

  // The even grid that lies nearest to the rounded directions.
  double offset = 0.0;
  gridColumn_.resize(columns);
  std::size_t at = 0;
  for (std::size_t i = 0; i < columns; ++i) {
    gridColumn_[order[i]] = at;
    offset += wrapped(toward[order[i]]) - static_cast<double>(at) * spacing;
    at += step[i];
  }
  offset /= static_cast<double>(columns);
  directions_.resize(count);
  for (std::size_t d = 0; d < count; ++d) {
    directions_[d] = offset + static_cast<double>(d) * spacing;
  }
}

void DirectionGrid::addRow(double frequency, const std::vector<double>& fileRow,
                           DirectionalSpectrum& spectrum) const {
  spectrum.direction = directions_;
  spectrum.energy.frequency.push_back(frequency);
  const std::size_t start = spectrum.density.size();
  spectrum.density.resize(start + directions_.size(), 0.0);
  for (std::size_t column = 0; column < fileRow.size(); ++column) {
    spectrum.density[start + gridColumn_[column]] = fileRow[column];
  }
}

void requireRisingFrequencies(const std::vector<double>& frequencies, const TextCursor& cursor) {
  for (std::size_t i = 0; i < frequencies.size(); ++i) {
    const std::string text = std::to_string(frequencies[i]);
    if (!(frequencies[i] > 0.0 && frequencies[i] <= 100.0)) {
      cursor.fail("frequency " + text + " Hz is not allowed; must be in (0, 100]");
    }
    if (i > 0 && !(frequencies[i] > frequencies[i - 1])) {
      cursor.fail("frequency " + text + " Hz does not rise above " +
                  std::to_string(frequencies[i - 1]));
    }
  }
}

}  // namespace seaway
