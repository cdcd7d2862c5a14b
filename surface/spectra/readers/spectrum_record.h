#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "surface/spectra/directional_spectrum.h"

namespace seaway {

/// Where a record was measured or computed, WGS84 degrees.
struct RecordPosition {
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
};

/// One record of a spectral file, in this project's units and directions.
struct SpectrumRecord {
  std::string time;  ///< ISO 8601, UTC: 2020-06-08T03:50Z; empty where the file does not say
  std::optional<RecordPosition> position;
  std::string location;                       ///< the file's name or number for the place, if any
  std::optional<double> depth;                ///< of the water, m
  std::optional<double> separationFrequency;  ///< Hz, between swell and wind sea
  std::string format;                         ///< its name in `spectrumFormats`

  /// Valid, or without any bin where fewer than two were left. Bins that the file marks as missing
  /// are left out; directions that it marks as missing are NaN.
  DirectionalSpectrum spectrum;
  std::size_t missingBins = 0;     ///< densities that the file marks as missing
  std::vector<std::string> notes;  ///< what was assumed, left out or found odd

  std::string file;
  int line = 0;  ///< where it starts in `file`, from 1; 0 in JSON, which has no lines

  bool hasSpectrum() const { return !spectrum.energy.frequency.empty(); }
};

/// The record nearest to an ISO 8601 time (UTC; `2020-06-08T03:50` with optional seconds and Z);
/// the first of several. Throws InputError for a malformed time, or where no record is within
/// `tolerance` seconds.
const SpectrumRecord& recordAt(const std::vector<SpectrumRecord>& records, const std::string& time,
                               double tolerance = 1800.0);

/// A record by its number from 0, in the order read. Throws InputError for a number that is none.
const SpectrumRecord& recordNumber(const std::vector<SpectrumRecord>& records, int number);

/// Leaves a spectrum with fewer than two bins without any, and checks the rest: `validate`, and
/// H_m0 below 100 m, beyond which a unit or a digit is wrong. Throws InputError naming file and
/// line.
void finishRecord(SpectrumRecord& record);

/// Directional moments from those of the distribution over compass directions that waves come
/// *from*: `first` = ∫D e^(iA) dA, `second` = ∫D e^(2iA) dA, A clockwise from north. θ = 3π/2 − A.
DirectionalMoments momentsFromCompassFrom(double firstReal, double firstImaginary,
                                          double secondReal, double secondImaginary);

/// First moment of a mean direction (degrees, from) and its r₁; no second.
DirectionalMoments momentsOfMeanDirection(double from_deg, double r1);

/// r₁ of a directional spread σ = √(2(1 − r₁)) in degrees (Kuik et al. 1988).
double r1OfSpread(double spread_deg);

}  // namespace seaway
