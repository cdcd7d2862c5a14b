#pragma once

#include <optional>
#include <string>

#include "surface/spectra/frequency_spectrum.h"

namespace seaway::bridge {

/// A spectrum to fit and where it came from.
struct SpectrumSource {
  FrequencySpectrum spectrum;
  std::string source;      ///< as given, or file and line
  std::string recordTime;  ///< ISO 8601; empty for a family
};

/// The spectrum that an argument names: `jonswap:Hs,Tp[,gamma]`, `pm:Hs,Tp`, or a record of an NDBC
/// file, by number from 0 or by time (else the file's first). Throws InputError where it cannot be
/// read or has no energy.
SpectrumSource spectrumFrom(const std::string& argument, std::optional<int> record,
                            const std::string& time);

}  // namespace seaway::bridge
