#pragma once

#include <iosfwd>
#include <optional>

#include "sim_bridge/commands/fit.h"
#include "sim_bridge/commands/fit_verification.h"
#include "sim_bridge/commands/spectrum_source.h"
#include "sim_bridge/scene/sea_state_file.h"
#include "surface/fit/octave_fit.h"
#include "surface/fit/sea_parameters.h"

namespace seaway::bridge {

/// All that `seaway fit` found.
struct FitResult {
  FitOptions options;
  SpectrumSource source;
  bool directional = false;  ///< fitted to the spectrum's own directions
  OctaveFit fit;
  std::optional<SeaParameters> parameters;
  std::optional<BuoyVerification> verification;
};

/// The spectrum that a model is fitted to and judged on: S(k) or S(f), or E(f, θ) in words.
std::string judgedOn(const FitResult& result);

/// What that means, in a sentence.
std::string judgementNote(const FitResult& result);

FittedSeaState seaStateOf(const FitResult& result);
void writeFitText(const FitResult& result, std::ostream& out);
void writeFitJson(const FitResult& result, std::ostream& out);

}  // namespace seaway::bridge
