#pragma once

#include <optional>
#include <string>
#include <vector>

#include "surface/spectra/directional_spectrum.h"

namespace seaway::bridge {

/// A spectrum to fit and where it came from.
struct SpectrumSource {
  DirectionalSpectrum spectrum;    ///< of a family: without directions
  std::string source;              ///< as given, or file and line
  std::string recordTime;          ///< ISO 8601; empty for a family, or where the file gives none
  std::vector<std::string> notes;  ///< what the reader assumed or left out
};

/// The spectrum that an argument names: one of `spectrumFamilies`, or a record of a file that
/// `readSpectra` knows, by number from 0 or by time (else the first). NDBC directional files beside
/// a density file are read with it. `format` overrides the detection. Throws InputError where it
/// cannot be read or has no energy.
SpectrumSource spectrumFrom(const std::string& argument, std::optional<int> record,
                            const std::string& time, const std::string& format = "");

/// The families in their command-line form, one a line with what it is: for help.
std::string spectrumFamilies();

/// The names of the file formats with what they are, one a line: for help.
std::string spectrumFileFormats();

}  // namespace seaway::bridge
