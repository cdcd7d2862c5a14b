#pragma once

#include <span>
#include <vector>

#include "surface/spectra/readers/spectrum_record.h"
#include "surface/spectra/readers/text_file.h"

/// The readers behind `readSpectra`, one pair of functions a format: does a file look like it, and
/// its records. Readers throw InputError naming file and line for whatever they cannot make a valid
/// record of. Internal to surface/spectra/readers.
namespace seaway::formats {

// NDBC realtime2: *.data_spec, *.swdir, *.swdir2, *.swr1, *.swr2 (ndbc_realtime.cpp).
bool looksLikeNdbcRealtime(const TextFile& file);
std::vector<SpectrumRecord> readNdbcRealtime(std::span<const TextFile> files);

// NDBC historical: a header row of frequencies, one row a record (ndbc_yearly.cpp).
bool looksLikeNdbcYearly(const TextFile& file);
std::vector<SpectrumRecord> readNdbcYearly(std::span<const TextFile> files);

// SWAN standard spectral file, 1-D and 2-D (swan.cpp).
bool looksLikeSwan(const TextFile& file);
std::vector<SpectrumRecord> readSwan(const TextFile& file);

// WAVEWATCH III point spectra of ww3_outp (wavewatch.cpp).
bool looksLikeWavewatch(const TextFile& file);
std::vector<SpectrumRecord> readWavewatch(const TextFile& file);

// Datawell Waverider *.spt (datawell.cpp).
bool looksLikeDatawell(const TextFile& file);
std::vector<SpectrumRecord> readDatawell(const TextFile& file);

// AXYS TRIAXYS directional and non-directional spectra (triaxys.cpp).
bool looksLikeTriaxys(const TextFile& file);
std::vector<SpectrumRecord> readTriaxys(const TextFile& file);

// Sofar Spotter JSON: spectra, or bulk parameters (spotter.cpp).
bool looksLikeSpotter(const TextFile& file);
std::vector<SpectrumRecord> readSpotter(const TextFile& file);

}  // namespace seaway::formats
