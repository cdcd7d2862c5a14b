#include "tests/bench/setups.h"

#include <map>
#include <memory>
#include <random>

namespace seaway::bench {
namespace {

PreparedField makeField(OctaveKind kind) {
  if (kind == OctaveKind::regular) return {regularWaves(benchOctaves), sineResidual(benchOctaves)};
  FittedOctaves fit =
      kind == OctaveKind::group ? groupOctaves(benchOctaves) : perlinOctaves(benchOctaves);
  // A fit may leave an octave empty; the field would drop it and the benchmark flatter itself.
  for (Octave& octave : fit.octaves) {
    if (octave.standardDeviation == 0.0) octave.standardDeviation = 1e-6;
  }
  return {std::move(fit.octaves), fit.residual};
}

const FittedOctaves& halvingOctaves() {
  static const FittedOctaves octaves = halvingPerlinOctaves();
  return octaves;
}

}  // namespace

BenchPoints::BenchPoints(std::size_t count) : x(count), y(count), points(count) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-10e3, 10e3);
  for (std::size_t i = 0; i < count; ++i) {
    x[i] = uniform(random);
    y[i] = uniform(random);
    points[i] = {x[i], y[i]};
  }
}

PreparedField::PreparedField(std::vector<Octave> octaves, double spectralResidual)
    : field(std::move(octaves)), now(field.at(benchTime)), residual(spectralResidual) {}

const PreparedField& preparedField(OctaveKind kind) {
  static std::map<OctaveKind, std::unique_ptr<PreparedField>> fields;
  auto& field = fields[kind];
  if (!field) field.reset(new PreparedField(makeField(kind)));
  return *field;
}

const SineSum& sineSum(int components) {
  static std::map<int, SineSum> sums;
  const auto found = sums.find(components);
  if (found != sums.end()) return found->second;
  const auto parts = sineComponents(targetSpectrum(), static_cast<std::size_t>(components));
  SineSum& sum = sums.emplace(components, SineSum(parts)).first->second;
  sum.prepare(benchTime);
  return sum;
}

FftTile& fftTile(std::uint32_t size) {
  static std::map<std::uint32_t, std::unique_ptr<FftTile>> tiles;
  auto& tile = tiles[size];
  if (!tile) {
    const double length = tileLength * size / 256.0;
    tile = std::make_unique<FftTile>(targetSpectrum(), size, length, FFTW_MEASURE);
    tile->step(benchTime);
  }
  return *tile;
}

CachedOctaves& cachedOctaves() {
  static CachedOctaves cached = [] {
    CachedOctaves octaves(halvingOctaves().octaves);
    octaves.step(benchTime);
    return octaves;
  }();
  return cached;
}

double cachedResidual() { return halvingOctaves().residual; }

}  // namespace seaway::bench
