#include <cmath>
#include <functional>
#include <random>

#include "sim_bridge/cost/rivals/field_models.h"
#include "sim_bridge/cost/study.h"
#include "sim_bridge/scene/sea.h"
#include "surface/constants.h"
#include "surface/dispersion.h"

namespace seaway::bridge {
namespace {

using rivals::FieldModel;

/// Points asked at one time: what a grid's step is shared by.
constexpr double pointsPerStep = 10000.0;

Timing nanosecondsPerPoint(const FieldModel& model, const StudyOptions& options) {
  constexpr std::size_t batch = 1024;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-10e3, 10e3);
  std::vector<double> x(batch), y(batch);
  for (std::size_t i = 0; i < batch; ++i) x[i] = uniform(random), y[i] = uniform(random);
  std::vector<float> height(batch);
  const int repetitions = options.quick ? 5 : 31;
  const Timing points = timeRepeated([&] { model.sample(x, y, height); }, repetitions);
  Timing total{1e9 * points.median / batch, 1e9 * points.spread / batch};
  if (model.step) {
    const Timing step = timeRepeated(model.step, options.quick ? 3 : 7);
    total.median += 1e9 * step.median / pointsPerStep;
    total.spread += 1e9 * step.spread / pointsPerStep;
  }
  return total;
}

/// The scene's sea as a JONSWAP spectrum: its wave height, and the period of its strongest octave.
JonswapParameters seaLike(const Sea& sea) {
  const WaveField& waves = sea.surface.waves();
  JonswapParameters parameters;
  if (waves.octaves().empty()) return parameters;
  parameters.significantWaveHeight = waves.significantWaveHeight();
  const double k = 2.0 * pi / dominantWavelength(waves.octaves().front());
  parameters.peakPeriod = 2.0 * pi / angularFrequency(k);
  return parameters;
}

}  // namespace

std::vector<Study> studyFieldModels(const Sea& sea, const StudyOptions& options) {
  const JonswapParameters parameters = seaLike(sea);
  const FrequencySpectrum target = jonswap(parameters);
  const std::string what =
      " for a JONSWAP sea with the scene's wave height and peak (gamma 3.3, deep water); height, "
      "slope and rate, batches of 1024; a grid's step is shared by 10000 points";
  Study spectrum{
      "field_models_spectrum", "relative L2 residual of the spectrum" + what, "1", "ns/point", {}};
  Study height{"field_models_height",
               "rms height error against each model's own exact field" + what,
               "m",
               "ns/point",
               {}};
  const std::vector<std::function<FieldModel()>> models = {
      [&] { return rivals::groupModel(target, 6); },
      [&] { return rivals::groupModel(target, 12); },
      [&] { return rivals::groupModel(target, 24); },
      [&] { return rivals::perlinModel(target, 8); },
      [&] { return rivals::sineModel(target, 50); },
      [&] { return rivals::sineModel(target, 200); },
      [&] { return rivals::sineModel(target, 1000); },
      [&] { return rivals::fftModel(parameters, 256, false); },
      [&] { return rivals::fftModel(parameters, 256, true); },
      [&] { return rivals::fftModel(parameters, 512, true); },
      [&] { return rivals::cachedModel(parameters, false, 0.0); },
      [&] { return rivals::cachedModel(parameters, true, 0.0); },
  };
  for (const auto& make : models) {
    const FieldModel model = make();
    const Timing cost = nanosecondsPerPoint(model, options);
    spectrum.points.push_back({model.name, model.spectralResidual, cost.median, cost.spread});
    height.points.push_back({model.name, rivals::heightError(model), cost.median, cost.spread});
  }
  return {spectrum, height};
}

}  // namespace seaway::bridge
