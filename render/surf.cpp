#include "render/surf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "render/grid_cover.h"
#include "render/render_technique.h"
#include "render/terrain/terrain_in_view.h"
#include "surface/angles.h"
#include "surface/constants.h"

namespace seaway::render {
namespace {

constexpr double breakerIndex = 0.42;
constexpr double leastHeight = 0.02;  // m, H_m0: ripples leave no foam

// Angles of a wave's phase, 0 at the crest, growing ahead of it.
constexpr float toe = 0.9f;           // how far the roller reaches down the front
constexpr float toeEdge = 0.1f;       // over which it begins
constexpr float leastRoller = 0.35f;  // its length; else of `heightsLong` wave heights
constexpr float heightsLong = 3.0f;
constexpr float rollerCover = 0.85f, leftCover = 0.4f;
constexpr float lifetime = 2.5f;  // s
constexpr float turn = static_cast<float>(2.0 * pi);

/// Of the bores that a row of a grid carries.
struct Bores {
  float variance = 0.0f;    // of height, m²
  float waveNumber = 0.0f;  // of slope along their direction, 1/m
  float fade = 0.0f;        // phase over which foam falls to 1/e, rad, inverse
  float shown = 0.0f;       // part of them that has crests and troughs here, [0, 1]
};

Bores boresOf(const WaveField& field, double shortest, glm::dvec2 towards) {
  double variance = 0.0, slope = 0.0;
  for (const Octave& octave : field.octaves()) {
    const double wavelength = dominantWavelength(octave);
    if (wavelength < shortest) continue;
    const double square = octave.standardDeviation * octave.standardDeviation;
    const double along = 2.0 * pi / wavelength * glm::dot(unitVector(octave.toward), towards);
    variance += square;
    slope += square * along * along;
  }
  Bores bores;
  const double share = variance / std::pow(field.standardDeviation(), 2);
  if (!(slope > 0.0)) return bores;
  const double waveNumber = std::sqrt(slope / variance);
  const double depth = std::min(waveNumber * field.settings().depth, 20.0);
  const double turnsPerSecond = std::sqrt(standardGravity * waveNumber * std::tanh(depth));
  bores.variance = static_cast<float>(variance);
  bores.waveNumber = static_cast<float>(waveNumber);
  bores.fade = static_cast<float>(1.0 / (turnsPerSecond * lifetime));
  bores.shown = static_cast<float>(std::clamp(2.5 * share - 0.75, 0.0, 1.0));
  return bores;
}

/// Foam at a phase behind the toe of a roller of some length, both rad.
float foamBehind(float phase, float roller, float fade) {
  if (phase < roller) return rollerCover * std::min(phase / toeEdge, 1.0f);
  return leftCover * std::exp((roller - phase) * fade);
}

/// Foam of a wave that `part` of all waves break like, where still water is `depth` deep. `slope`
/// along the waves' direction.
float boreFoam(const Bores& bores, float part, float depth, float height, float slope) {
  const float across = slope / bores.waveNumber;
  const float square = height * height + across * across;          // of the amplitude
  const float higher = std::exp(-0.5f * square / bores.variance);  // part of all waves
  const float breaks = std::clamp((1.25f * part - higher) / (0.5f * part), 0.0f, 1.0f);
  if (breaks <= 0.0f) return 0.0f;
  const float waveHeight = 2.0f * std::sqrt(square);
  const float water = std::clamp((depth + height) / std::max(waveHeight, 1e-3f), 0.0f, 1.0f);
  const float roller =
      std::clamp(heightsLong * waveHeight * water * bores.waveNumber, leastRoller, 0.8f);
  float behind = toe - std::atan2(-across, height);
  if (behind < 0.0f) behind += turn;
  return breaks * std::sqrt(water) * foamBehind(behind, roller, bores.fade);
}

/// Its mean over a wave's phases and the heights of waves by Rayleigh's distribution.
float meanFoam(const Bores& bores, float part, float depth) {
  constexpr int heights = 6, phases = 24;
  float sum = 0.0f;
  for (int i = 0; i < heights; ++i) {
    const float higher = (static_cast<float>(i) + 0.5f) / heights;
    const float amplitude = std::sqrt(-2.0f * bores.variance * std::log(higher));
    for (int j = 0; j < phases; ++j) {
      const float phase = turn * static_cast<float>(j) / phases;
      sum += boreFoam(bores, part, depth, amplitude * std::cos(phase),
                      amplitude * bores.waveNumber * std::sin(phase));
    }
  }
  return sum / (heights * phases);
}

/// In deviations of height: as much higher than still water waves do not come.
constexpr double highest = 2.5;

}  // namespace

Surf::Surf(std::shared_ptr<const TerrainMap> terrain, const WaveField& waves)
    : terrain_(std::move(terrain)),
      allBreak_(waves.significantWaveHeight() / (std::sqrt(2.0) * breakerIndex)),
      deepest_(allBreak_ * std::pow(255.0, 0.25)) {
  double wavelengths = 0.0;
  glm::dvec2 towards(0.0);
  for (const Octave& octave : waves.octaves()) {
    const double square = octave.standardDeviation * octave.standardDeviation;
    wavelengths += square * dominantWavelength(octave);
    towards += square * unitVector(octave.toward);
  }
  const double variance = std::pow(waves.standardDeviation(), 2);
  if (variance > 0.0) shortest_ = 0.5 * wavelengths / variance;
  if (glm::length(towards) > 1e-6 * variance) towards_ = glm::normalize(towards);
  driest_ = -highest * waves.standardDeviation();
  const Bores bores = boresOf(waves, shortest_, towards_);
  for (std::size_t i = 0; i < means_.size(); ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(means_.size() - 1);
    means_[i] = meanFoam(bores, 1.0f, static_cast<float>(glm::mix(driest_, allBreak_, share)));
  }
}

float Surf::mean(double depth) const {
  if (!(allBreak_ > driest_)) return 0.0f;  // no waves
  const double share = std::clamp((depth - driest_) / (allBreak_ - driest_), 0.0, 1.0);
  const double place = share * static_cast<double>(means_.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(place), means_.size() - 2);
  const float there = static_cast<float>(place - static_cast<double>(i));
  return static_cast<float>(breaking(depth)) * glm::mix(means_[i], means_[i + 1], there);
}

double Surf::breaking(double depth) const {
  if (depth <= allBreak_) return 1.0;
  const double part = allBreak_ / depth;
  return part * part * part * part;
}

bool Surf::addTo(const SurfaceAtTime& water, std::span<const double> x, std::span<const double> y,
                 double keptWavelength, std::span<float> foam) const {
  std::array<float, gridChunk> part;
  bool any = false;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double depth = -terrain_->heightAt({x[i], y[i]});
    part[i] = depth < deepest_ ? static_cast<float>(breaking(depth)) : 0.0f;
    any = any || part[i] > 0.0f;
  }
  if (!any) return false;
  const double shortest = std::max(shortest_, keptWavelength);
  const Bores bores = boresOf(water.waves().field(), shortest, towards_);
  std::array<float, gridChunk> height, slopeX, slopeY;
  const auto first = [&](auto& array) { return std::span(array).first(x.size()); };
  if (bores.shown > 0.0f) {
    water.waves().sample(
        x, y,
        {.height = first(height), .slopeX = first(slopeX), .slopeY = first(slopeY), .rate = {}},
        {.shortestWavelength = shortest});
  }
  const glm::vec2 towards(towards_);
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (part[i] <= 0.0f) continue;
    const double depth = -terrain_->heightAt({x[i], y[i]});
    float white = mean(depth);
    if (bores.shown > 0.0f) {
      const float slope = towards.x * slopeX[i] + towards.y * slopeY[i];
      const float bore = boreFoam(bores, part[i], static_cast<float>(depth), height[i], slope);
      white = glm::mix(white, bore, bores.shown);
    }
    foam[i] += (1.0f - foam[i]) * white;
  }
  return true;
}

std::optional<Surf> surfOf(const View& view) {
  const TerrainMap* terrain = view.water ? view.water->terrain() : nullptr;
  if (!terrain || view.water->waves().significantWaveHeight() < leastHeight ||
      view.effects->isOff(Effect::foam) || view.effects->isOff(Effect::terrain) ||
      !mapMayShow(*terrain, view.camera)) {
    return std::nullopt;
  }
  return Surf(view.water->sharedTerrain(), view.water->waves());
}

}  // namespace seaway::render
