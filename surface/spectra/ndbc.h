#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "surface/spectra/frequency_spectrum.h"

namespace seaway {

/// One record of a spectral file.
struct SpectrumRecord {
  std::string time;                           ///< ISO 8601, UTC: 2020-06-08T03:50Z
  std::optional<double> separationFrequency;  ///< Hz, between swell and wind sea
  FrequencySpectrum spectrum;                 ///< not valid where too many bins are missing
  std::size_t missingBins = 0;  ///< bins the file marks as missing, left out of `spectrum`
  int line = 0;                 ///< where it stands in the file, from 1
};

/// Reads an NDBC spectral density file (`*.data_spec`): per line date and time, separation
/// frequency (9.999: missing), then density (m²/Hz) and frequency (Hz, in parentheses) in turn;
/// densities of 999 are missing. Records are in the file's order (newest first as NDBC writes them).
///
/// Throws InputError naming file and line for anything else: a file that cannot be read, a line cut
/// short, text where a number belongs, frequencies that do not rise, negative densities.
std::vector<SpectrumRecord> readNdbcSpectralDensity(const std::filesystem::path& path);

/// The record nearest to an ISO 8601 time (UTC; `2020-06-08T03:50` with optional seconds and Z).
/// Throws InputError for a malformed time, or where no record is within `tolerance` seconds.
const SpectrumRecord& recordAt(const std::vector<SpectrumRecord>& records, const std::string& time,
                               double tolerance = 1800.0);

}  // namespace seaway
