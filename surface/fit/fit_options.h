#pragma once

#include <optional>
#include <string>

#include "surface/fit/octave_fit.h"

/// Internal to the fits.
namespace seaway::fit {

/// Points of a target's band on which fits are judged.
inline constexpr std::size_t judgedPoints = 600;

/// An octave with less than this share of the variance is nothing: 1e-10 changes H_m0 by 5e-11.
inline constexpr double negligibleShare = 1e-10;

/// Throws InputError for options out of range.
void check(const OctaveFitOptions& options);

/// Why a target cannot be fitted, or nothing.
std::optional<std::string> problemOf(const FrequencySpectrum& target);

/// Heights and periods of a target and of a model on the same band.
void summariseMoments(const FrequencySpectrum& target, OctaveFit& fit);

}  // namespace seaway::fit
