#pragma once

#include <array>

#include "surface/spectra/frequency_spectrum.h"

namespace seaway {

/// A state of the sea by the WMO's code table 3700.
struct SeaState {
  int code = 0;                ///< 0–9
  const char* name = "";       ///< the table's description
  double lowestHeight = 0.0;   ///< of the class, H_m0 in m
  double highestHeight = 0.0;  ///< infinity for 9
  /// Representative H_m0, m: the middle of the class; of 9, which is open, its bound.
  double significantWaveHeight = 0.0;
  /// Typical T_p, s. From 2 on the most probable modal period of the open North Atlantic (Bales
  /// 1983, as in STANAG 4194); of 1, which has none there, the fully developed sea's: 5.00 √H_m0.
  double peakPeriod = 0.0;
};

/// All ten, by code.
const std::array<SeaState, 10>& seaStates();

/// One of them. Throws InputError for a code outside 0–9.
const SeaState& seaState(int code);

/// Pierson–Moskowitz spectrum of a state's representative height and period. Throws InputError for
/// a code outside 0–9, and for 0: a calm sea has no spectrum.
FrequencySpectrum seaStateSpectrum(int code);

}  // namespace seaway
