#include "sim_bridge/scene/sea.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "sim_bridge/scene/parametric_spectrum.h"
#include "sim_bridge/scene/partial_sea.h"
#include "sim_bridge/scene_detail.h"
#include "surface/angles.h"
#include "surface/fit/octave_directions.h"
#include "surface/fit/octave_fit.h"
#include "surface/input_error.h"
#include "surface/spectra/directional_spread.h"
#include "surface/spectra/steepness.h"

namespace seaway::bridge {
namespace {

struct Waves {
  std::vector<Octave> octaves;
  double hm0Asked = 0.0;
};

Waves wavesOf(const ParametricState& state, const Scene& scene) {
  const bool group = scene.sea.model == OctaveKind::group;
  const int count = state.octaves > 0 ? state.octaves : group ? 24 : 8;
  const FrequencySpectrum target = spectrumOf(state, scene.sea.depth);
  const auto exponentOf = exponentsOf(state, target, scene.sea.depth);
  const bool oneDirection =
      state.spreading == Spreading::cosinePower && std::isinf(state.spreadExponent);
  OctaveFitOptions options;
  options.octaves = group && !oneDirection ? octavesBeforeSpreading(count) : count;
  options.toward = towardFromCompassFrom(state.from_deg);
  if (state.spreading == Spreading::cosinePower) {
    options.directionalWidth = directionalWidthFor(state.spreadExponent);
  }
  options.depth = scene.sea.depth;
  OctaveFit fit = group ? fitGroupOctaves(target, options) : fitPerlinOctaves(target, options);
  if (!fit.summary.usable) throw InputError("cannot be fitted: " + fit.summary.message);
  if (group && !oneDirection) {
    fit.octaves = spreadDirections(fit.octaves, exponentOf, static_cast<std::size_t>(count));
  } else if (!group) {
    unsigned index = 0;
    for (Octave& octave : fit.octaves) {
      octave.toward += spreadQuantile(exponentOf(octave), vanDerCorput(index++));
    }
  }
  return {std::move(fit.octaves), target.significantWaveHeight()};
}

Waves wavesOf(const CalmState&, const Scene&) { return {}; }

Waves wavesOf(const FittedSeaState& state, const Scene& scene) {
  return {octavesOf(state, scene.sea.depth), state.significantWaveHeight()};
}

Waves wavesOf(const FileState& state, const Scene& scene) {
  Waves waves = wavesOf(state.seaState, scene);
  const double target = state.seaState.provenance.hm0Target;
  if (target > 0.0) waves.hm0Asked = target;
  return waves;
}

WaveField fieldOf(std::vector<Octave> octaves, const SeaSettings& sea) {
  WaveFieldSettings settings;
  settings.seed = static_cast<std::uint64_t>(sea.seed);
  settings.depth = sea.depth;
  settings.current =
      sea.current.speed * unitVector(towardFromCompassToward(sea.current.toward_deg));
  return WaveField(std::move(octaves), settings);
}

void warnOf(const std::vector<BlockedOctave>& blocked, const Scene& scene) {
  if (blocked.empty()) return;
  const BlockedOctave& longest = blocked.front();
  spdlog::warn(
      "{}: the current stops {} of the sea's octaves, up to a wavelength of {:.3g} m: {:.3g} m/s "
      "against a group speed of {:.3g} m/s",
      scene.file.string(), blocked.size(), longest.wavelength, longest.currentAgainst,
      longest.groupSpeed);
}

void warnOfSteepness(const WaveField& field, const Scene& scene) {
  const double period = meanPeriod(field.octaves(), scene.sea.depth);
  const double steepness = averageSteepness(field.significantWaveHeight(), period);
  if (!(steepness > limitingSteepness(period))) return;
  spdlog::warn(
      "{}: waves of H_m0 {:.3g} m and T_m02 {:.3g} s are steeper than seas get before they break: "
      "1/{:.1f}, where 1/{:.1f} is the limit",
      scene.file.string(), field.significantWaveHeight(), period, 1.0 / steepness,
      1.0 / limitingSteepness(period));
}

/// Leaves the `kept` largest octaves, each in its place, which its waves depend on.
void silenceAllBut(std::size_t kept, std::vector<Octave>& octaves) {
  if (kept >= octaves.size()) return;
  std::vector<std::size_t> order(octaves.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return octaves[a].standardDeviation > octaves[b].standardDeviation;
  });
  for (std::size_t i = kept; i < order.size(); ++i) octaves[order[i]].standardDeviation = 0.0;
}

Sea seaOf(const Scene& scene, std::size_t kept) {
  const SeaSettings& sea = scene.sea;
  try {
    Waves waves;
    if (scene.effects[static_cast<std::size_t>(Effect::waves)] != EffectSetting::off) {
      waves = std::visit([&](const auto& state) { return wavesOf(state, scene); }, sea.state);
    }
    silenceAllBut(kept, waves.octaves);
    WaterSurface surface(fieldOf(std::move(waves.octaves), sea));
    const EffectSetting shores = scene.effects[static_cast<std::size_t>(Effect::outline)];
    if (sea.outline && shores != EffectSetting::off) {
      surface.setOutline(sea.outline);
    }
    if (scene.effects[static_cast<std::size_t>(Effect::terrain)] != EffectSetting::off) {
      surface.setTerrain(scene.terrain.map);
    }
    const WaveField& field = surface.waves();
    const Geodesy geodesy({sea.anchor.latitude_deg, sea.anchor.longitude_deg, 0.0});
    surface.setEvents(sceneEvents(scene, geodesy, {field.settings().current, sea.depth}));
    std::vector<BlockedOctave> blocked =
        blockedOctaves(field.octaves(), sea.depth, field.settings().current);
    return {geodesy, SeaLevel(sea.waterLevel), std::move(surface), waves.hm0Asked,
            std::move(blocked)};
  } catch (const InputError& fault) {
    throw InputError(scene.file.string(), sea.stateLine,
                     std::string("key 'sea.state': ") + fault.what());
  }
}

}  // namespace

Sea buildSea(const Scene& scene) {
  Sea sea = seaOf(scene, std::numeric_limits<std::size_t>::max());
  warnOf(sea.blocked, scene);
  warnOfSteepness(sea.surface.waves(), scene);
  return sea;
}

Sea buildPartialSea(const Scene& scene, std::size_t kept) { return seaOf(scene, kept); }

double realisedSignificantWaveHeight(const WaterSurface& surface) {
  constexpr int times = 64;
  constexpr int placesPerTime = 1024;
  double longest = 0.0;
  for (const Octave& octave : surface.waves().octaves()) {
    // A regular wave never forgets: a few hundred of its lengths are as good as any.
    const double length = octave.kind == OctaveKind::regular ? 0.0 : correlationLength(octave);
    longest = std::max({longest, length, dominantWavelength(octave)});
  }
  if (longest == 0.0) return 0.0;
  // The generator's own bits, not a distribution's: those differ between libraries.
  std::mt19937_64 random(20200608);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53 - 0.5; };
  std::vector<glm::dvec2> places(placesPerTime);
  std::vector<SurfaceSample> samples(placesPerTime);
  double sum = 0.0;
  double sumOfSquares = 0.0;
  for (int time = 0; time < times; ++time) {
    for (glm::dvec2& place : places) place = 400.0 * longest * glm::dvec2(uniform(), uniform());
    surface.waves().sample(places, 1e4 * (uniform() + 0.5), samples);
    for (const SurfaceSample& sample : samples) {
      sum += sample.height;
      sumOfSquares += sample.height * sample.height;
    }
  }
  constexpr double count = static_cast<double>(times) * placesPerTime;
  const double mean = sum / count;
  return 4.0 * std::sqrt(sumOfSquares / count - mean * mean);
}

}  // namespace seaway::bridge
