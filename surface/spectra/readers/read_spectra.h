#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "surface/spectra/readers/spectrum_record.h"
#include "surface/spectra/readers/text_file.h"

namespace seaway {

/// A format that `readSpectra` knows.
struct SpectrumFormatName {
  std::string name;     ///< as `--format` takes it
  std::string summary;  ///< what it is
};
std::vector<SpectrumFormatName> spectrumFormats();

/// Reads the records of measured or computed spectra, in the files' order. The format is told from
/// the content, or given by its name. Several files are one data set where the format spreads
/// a record over files (NDBC: any of density, α1, α2, r1, r2, matched by time; the density is
/// needed), else one after the other.
///
/// Densities come as m²/Hz(/rad), directions as where waves go, rad counter-clockwise from east,
/// times as UTC. Throws InputError naming file, line, value and what is allowed for a file that
/// cannot be read, is of no known format, or holds anything that is not a valid record: all records
/// or none.
std::vector<SpectrumRecord> readSpectra(const std::vector<std::filesystem::path>& paths,
                                        const std::string& format = "");
std::vector<SpectrumRecord> readSpectra(const std::filesystem::path& path,
                                        const std::string& format = "");

/// The same for files in memory.
std::vector<SpectrumRecord> parseSpectra(const std::vector<TextFile>& files,
                                         const std::string& format = "");

/// An NDBC density file and those of its directional files that lie beside it under their usual
/// names (41010.data_spec: 41010.swdir …; 41010w2019.txt: 41010d2019.txt …); any other file alone.
std::vector<std::filesystem::path> withCompanions(const std::filesystem::path& path);

}  // namespace seaway
