#include "sim_bridge/scene/parametric_spectrum.h"

#include <algorithm>

#include "surface/constants.h"
#include "surface/dispersion.h"
#include "surface/spectra/families.h"
#include "surface/spectra/sea_states.h"
#include "surface/spectra/spreading.h"
#include "surface/spectra/swell.h"

namespace seaway::bridge {
namespace {

double frequencyOf(const Octave& octave, double depth) {
  if (octave.kind != OctaveKind::perlin) return bandOf(octave, depth).frequency;
  return angularFrequency(2.0 * pi / dominantWavelength(octave), depth) / (2.0 * pi);
}

}  // namespace

FrequencySpectrum spectrumOf(const ParametricState& state, double depth) {
  const double hm0 = state.significantWaveHeight, tp = state.peakPeriod;
  switch (state.family) {
    case SpectralFamily::jonswap:
      return jonswap({hm0, tp, state.peakEnhancement});
    case SpectralFamily::piersonMoskowitzOfWind:
      return piersonMoskowitzOfWind(state.windSpeed);
    case SpectralFamily::tma:
      return tma({hm0, tp, state.peakEnhancement}, depth);
    case SpectralFamily::ochiHubble:
      return state.swell ? ochiHubble(*state.swell, *state.windSea) : ochiHubbleMostProbable(hm0);
    case SpectralFamily::torsethaugen:
      return torsethaugen(hm0, tp);
    case SpectralFamily::swell:
      return gaussianSwell(hm0, tp, state.width);
    case SpectralFamily::wmo:
      return seaStateSpectrum(state.code);
  }
  return {};
}

std::function<double(const Octave&)> exponentsOf(const ParametricState& state,
                                                 const FrequencySpectrum& spectrum, double depth) {
  if (state.spreading == Spreading::cosinePower) {
    return [s = state.spreadExponent](const Octave&) { return s; };
  }
  const double peak = 1.0 / spectrum.peakPeriod();
  const double atPeak = mitsuyasuPeakExponent(peak, state.spreadWind);
  return [=](const Octave& octave) {
    return std::max(0.5, mitsuyasuExponent(frequencyOf(octave, depth), peak, atPeak));
  };
}

}  // namespace seaway::bridge
