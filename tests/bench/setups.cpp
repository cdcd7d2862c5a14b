#include "tests/bench/setups.h"

#include <map>
#include <memory>
#include <random>

namespace seaway::bench {
namespace {

PreparedField makeField(OctaveKind kind) {
  const FrequencySpectrum target = jonswap(benchSea);
  if (kind == OctaveKind::regular) return PreparedField(regularWaves(target, benchOctaves));
  FittedOctaves fit = kind == OctaveKind::group ? groupOctaves(target, benchOctaves)
                                                : perlinOctaves(target, benchOctaves);
  // A fit may leave an octave empty; the field would drop it and the benchmark flatter itself.
  for (Octave& octave : fit.octaves) {
    if (octave.standardDeviation == 0.0) octave.standardDeviation = 1e-6;
  }
  return PreparedField(std::move(fit.octaves));
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

PreparedField::PreparedField(std::vector<Octave> octaves)
    : field(std::move(octaves)), now(field.at(benchTime)) {}

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
  const auto parts = sineComponents(jonswap(benchSea), static_cast<std::size_t>(components));
  SineSum& sum = sums.emplace(components, SineSum(parts)).first->second;
  sum.prepare(benchTime);
  return sum;
}

FftTile& fftTile(std::uint32_t size) {
  static std::map<std::uint32_t, std::unique_ptr<FftTile>> tiles;
  auto& tile = tiles[size];
  if (!tile) {
    const double length = tileLength * size / 256.0;
    tile = std::make_unique<FftTile>(jonswap(benchSea), size, length, FFTW_MEASURE);
    tile->step(benchTime);
  }
  return *tile;
}

CachedOctaves& cachedOctaves() {
  static CachedOctaves cached = [] {
    CachedOctaves octaves(halvingPerlinOctaves(benchSea).octaves);
    octaves.step(benchTime);
    return octaves;
  }();
  return cached;
}

}  // namespace seaway::bench
