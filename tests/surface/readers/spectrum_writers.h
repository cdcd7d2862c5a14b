#pragma once

#include <string>
#include <vector>

#include "surface/spectra/directional_spectrum.h"
#include "surface/spectra/readers/text_file.h"

/// Files of every format that `readSpectra` knows, written from known spectra.
namespace seaway::test {

/// A known record. Directions in its grid are spread evenly.
struct KnownRecord {
  std::string time = "2020-06-08T03:50Z";
  double latitude_deg = 28.878;
  double longitude_deg = -78.467;
  DirectionalSpectrum spectrum;
};

/// Two records on `bins` frequencies and `directions` directions: waves from 350 deg and from 10
/// deg, JONSWAP and Pierson–Moskowitz, cos²ˢ with s = 6 and 15.
std::vector<KnownRecord> knownRecords(std::size_t bins, std::size_t directions);

/// A data set in one format.
struct WrittenFiles {
  std::string format;
  std::vector<TextFile> files;
};

WrittenFiles ndbcRealtimeFiles(const std::vector<KnownRecord>& records);
WrittenFiles ndbcYearlyFiles(const std::vector<KnownRecord>& records);
WrittenFiles swanFile(const std::vector<KnownRecord>& records);
WrittenFiles swanLineFile(const std::vector<KnownRecord>& records);  ///< 1-D
WrittenFiles wavewatchFile(const std::vector<KnownRecord>& records);
WrittenFiles datawellFile(const KnownRecord& record);  ///< on the format's own 64 frequencies
WrittenFiles triaxysFile(const KnownRecord& record);
WrittenFiles triaxysLineFile(const KnownRecord& record);  ///< non-directional
WrittenFiles spotterFile(const std::vector<KnownRecord>& records);
WrittenFiles spotterBulkFile(const std::vector<KnownRecord>& records);

/// One of each, `bins` frequencies and `directions` directions (Datawell: its own 64).
std::vector<WrittenFiles> everyFormat(std::size_t bins, std::size_t directions);

/// The 64 frequencies of a Waverider's spectrum file, Hz.
std::vector<double> datawellFrequencies();

}  // namespace seaway::test
