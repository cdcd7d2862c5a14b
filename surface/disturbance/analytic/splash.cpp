#include "surface/disturbance/analytic/splash.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "surface/constants.h"
#include "surface/dispersion.h"
#include "surface/input_error.h"

namespace seaway {
namespace {

void require(const char* what, double value, double least, bool leastAllowed, double most) {
  const bool allowed = (leastAllowed ? value >= least : value > least) && value <= most;
  if (allowed) return;
  throw InputError(std::string("splash: ") + what + " " + std::to_string(value) +
                   " is not allowed; must be in " + (leastAllowed ? "[" : "(") +
                   std::to_string(least) + ", " + std::to_string(most) + "]");
}

const Splash& checked(const Splash& splash) {
  if (!std::isfinite(splash.place.x + splash.place.y + splash.time)) {
    throw InputError("splash: place and time must be finite");
  }
  require("height", splash.height, 0.0, true, Splash::mostHeight);
  require("wavelength", splash.wavelength, 0.0, false, Splash::mostLength);
  require("reach", splash.reach, 0.0, false, Splash::mostLength);
  require("duration", splash.duration, 0.0, false, Splash::mostDuration);
  return splash;
}

/// A factor and its derivative.
struct Factor {
  double value, slope;
};

/// From 0 at `low` to 1 at `high`, smooth at both.
Factor rise(double x, double low, double high) {
  const double width = high - low, f = std::clamp((x - low) / width, 0.0, 1.0);
  return {f * f * (3.0 - 2.0 * f), 6.0 * f * (1.0 - f) / width};
}

Factor fall(double x, double low, double high) {
  const Factor risen = rise(x, low, high);
  return {1.0 - risen.value, -risen.slope};
}

}  // namespace

SplashRings::SplashRings(const Splash& splash, glm::dvec2 current, double depth)
    : splash_(checked(splash)),
      current_(current),
      waveNumber_(2.0 * pi / splash.wavelength),
      angularFrequency_(seaway::angularFrequency(waveNumber_, depth)) {}

SplashRings::Value SplashRings::at(double r, double age) const noexcept {
  if (!(age > 0.0) || !(age < lifetime()) || !(r < radius())) return {};
  const double k = waveNumber_, omega = angularFrequency_;
  const double round = 0.25 * splash_.wavelength;
  const double rho = std::sqrt(r * r + round * round), byR = r / rho;  // dρ/dr

  const double phase = k * rho - omega * age;
  const double wave = std::cos(phase), turned = -std::sin(phase);
  const double far = std::exp(-rho / splash_.reach), old = std::exp(-age / splash_.duration);
  const Factor begins = rise(age, 0.0, 0.5 * pi / omega);
  const Factor ends = fall(age, 0.7 * lifetime(), lifetime());
  const Factor edge = fall(r, 0.7 * radius(), radius());
  // Rings have come this far: half a wavelength about the place moves from the start.
  const Factor front =
      fall(r - omega / k * age, -0.5 * splash_.wavelength, 0.5 * splash_.wavelength);

  const double inSpace = far * edge.value, inTime = old * begins.value * ends.value;
  const double spaceSlope = far * (edge.slope - edge.value * byR / splash_.reach);
  const double timeSlope = old * (begins.slope * ends.value + begins.value * ends.slope -
                                  begins.value * ends.value / splash_.duration);
  const double scale = splash_.height;
  return {scale * inSpace * inTime * front.value * wave,
          scale * inTime *
              (spaceSlope * front.value * wave + inSpace * front.slope * wave +
               inSpace * front.value * turned * k * byR),
          scale * inSpace *
              (timeSlope * front.value * wave - inTime * front.slope * omega / k * wave -
               inTime * front.value * turned * omega)};
}

}  // namespace seaway
