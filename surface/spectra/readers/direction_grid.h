#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "surface/spectra/directional_spectrum.h"
#include "surface/spectra/readers/text_cursor.h"

namespace seaway {

/// How a file's columns of directions become an even, rising grid over the whole turn.
///
/// Files give directions in any order, rounded to as little as three digits, and sometimes only a
/// sector: the missing directions then get no energy.
class DirectionGrid {
 public:
  DirectionGrid() = default;

  /// From a file's directions, rad toward, any turn. Fails at the cursor's line for fewer than 3 or
  /// more than 3600 directions, two alike, or uneven ones (a tenth of the spacing is let pass).
  DirectionGrid(const std::vector<double>& toward, const TextCursor& cursor);

  std::size_t fileColumns() const { return gridColumn_.size(); }
  const std::vector<double>& directions() const { return directions_; }  ///< rad toward, rising
  bool wasSector() const { return fileColumns() < directions_.size(); }

  /// Adds a frequency with its densities (m²/Hz/rad, in the file's order of columns) to a spectrum
  /// whose grid is this one.
  void addRow(double frequency, const std::vector<double>& fileRow,
              DirectionalSpectrum& spectrum) const;

 private:
  std::vector<double> directions_;
  std::vector<std::size_t> gridColumn_;  ///< of each of the file's columns
};

/// Fails at the cursor's line unless frequencies are in (0, 100] Hz and rise.
void requireRisingFrequencies(const std::vector<double>& frequencies, const TextCursor& cursor);

}  // namespace seaway
