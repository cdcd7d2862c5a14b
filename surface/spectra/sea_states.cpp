#include "surface/spectra/sea_states.h"

#include <limits>
#include <string>

#include "surface/input_error.h"
#include "surface/spectra/families.h"

namespace seaway {

const std::array<SeaState, 10>& seaStates() {
  constexpr double open = std::numeric_limits<double>::infinity();
  static constexpr std::array<SeaState, 10> states{{
      {0, "calm (glassy)", 0.0, 0.0, 0.0, 0.0},
      {1, "calm (rippled)", 0.0, 0.1, 0.05, 1.12},
      {2, "smooth (wavelets)", 0.1, 0.5, 0.3, 7.5},
      {3, "slight", 0.5, 1.25, 0.875, 7.5},
      {4, "moderate", 1.25, 2.5, 1.875, 8.8},
      {5, "rough", 2.5, 4.0, 3.25, 9.7},
      {6, "very rough", 4.0, 6.0, 5.0, 12.4},
      {7, "high", 6.0, 9.0, 7.5, 15.0},
      {8, "very high", 9.0, 14.0, 11.5, 16.4},
      {9, "phenomenal", 14.0, open, 14.0, 20.0},
  }};
  return states;
}

const SeaState& seaState(int code) {
  if (code < 0 || code > 9) {
    throw InputError("sea state " + std::to_string(code) +
                     " is not allowed; must be in [0, 9] (WMO code table 3700)");
  }
  return seaStates()[static_cast<std::size_t>(code)];
}

FrequencySpectrum seaStateSpectrum(int code) {
  const SeaState& state = seaState(code);
  if (code == 0) throw InputError("sea state 0 is calm: it has no spectrum");
  return piersonMoskowitz(state.significantWaveHeight, state.peakPeriod);
}

}  // namespace seaway
