#include "sim_bridge/service/sea_state_reading.h"

#include <cmath>
#include <variant>

#include "surface/angles.h"
#include "surface/spectra/buoy_analysis.h"

namespace seaway::bridge {
namespace {

constexpr double recordStep = 0.5;  // s
constexpr std::size_t recordSamples = 14400;

BuoyRecord recordOf(const WaterSurface& surface) {
  BuoyRecord record;
  record.timeStep = recordStep;
  const glm::dvec2 anchor(0.0);
  for (std::size_t i = 0; i < recordSamples; ++i) {
    SurfaceSample sample;
    surface.waves().sample(std::span(&anchor, 1), static_cast<double>(i) * recordStep,
                           std::span(&sample, 1));
    record.heave.push_back(sample.height);
    record.slopeEast.push_back(sample.slope.x);
    record.slopeNorth.push_back(sample.slope.y);
  }
  return record;
}

std::optional<double> known(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace

SeaStateFigures askedSeaState(const Scene& scene, const Sea& sea) {
  SeaStateFigures asked;
  asked.significantWaveHeight = sea.hm0Asked;
  if (const auto* state = std::get_if<ParametricState>(&scene.sea.state)) {
    if (state->peakPeriod > 0.0) asked.peakPeriod = state->peakPeriod;
    asked.from_deg = compassWrapped(state->from_deg);
  }
  return asked;
}

SeaStateFigures realisedSeaState(const WaterSurface& surface, const Geodesy& geodesy) {
  SeaStateFigures real;
  real.significantWaveHeight = realisedSignificantWaveHeight(surface);
  if (!(*real.significantWaveHeight > 0.0)) return real;
  const BuoyAnalysis buoy = analyseBuoy(recordOf(surface));
  real.peakPeriod = known(buoy.peakPeriod);
  const double toward = buoy.overall.meanDirection();
  if (std::isfinite(toward)) {
    real.from_deg = compassWrapped(geodesy.trueHeadingFromDirection({0.0, 0.0}, toward) + 180.0);
  }
  return real;
}

SeaStateFigures SeaStateReading::of(const ServedSea& sea) {
  const std::lock_guard lock(mutex_);
  const std::uint64_t version = sea.wavesVersion();
  if (version_ != version) {
    figures_ = realisedSeaState(*sea.surface(), sea.geodesy());
    version_ = version;
  }
  return figures_;
}

}  // namespace seaway::bridge
