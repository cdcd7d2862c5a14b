#include "sim_bridge/cost/rivals/cached_octaves.h"

#include <algorithm>
#include <cmath>

#include "sim_bridge/cost/rivals/periodic_noise.h"
#include "surface/field/lattice_hash.h"

namespace seaway::rivals {
namespace {

std::uint64_t seedOf(std::size_t octave) { return mixSeed(0x5EA + octave); }

/// Means of 2×2 texels.
std::vector<Texel> halved(const std::vector<Texel>& fine, std::uint32_t size) {
  const std::uint32_t half = size / 2;
  std::vector<Texel> coarse(std::size_t{half} * half);
  for (std::uint32_t n = 0; n < size * size; ++n) {
    Texel& to = coarse[(n / size / 2) * half + n % size / 2];
    to.height += 0.25f * fine[n].height;
    to.slopeX += 0.25f * fine[n].slopeX;
    to.slopeY += 0.25f * fine[n].slopeY;
    to.rate += 0.25f * fine[n].rate;
  }
  return coarse;
}

}  // namespace

CachedOctaves::CachedOctaves(std::span<const Octave> octaves) {
  for (std::size_t p = 0; p < textures_.size(); ++p) {
    Texture& texture = textures_[p];
    std::copy_n(octaves.begin() + p * octavesPerTexture, octavesPerTexture,
                texture.octaves.begin());
    texture.texelSize = texture.octaves[0].latticeSize * baseCells / texels;
    texture.driftSpeed = texture.octaves[1].driftSpeed;
  }
  step(0.0);
}

void CachedOctaves::fill(Texture& texture, std::size_t first, double t) const {
  texture.drift = texture.driftSpeed * t;
  texture.levels.assign(1, std::vector<Texel>(std::size_t{texels} * texels));
  for (std::size_t i = 0; i < octavesPerTexture; ++i) {
    const Octave& octave = texture.octaves[i];
    const PeriodicNoise noise(seedOf(first + i), baseCells << i, octave.boilTime, t);
    noise.addTo(texture.levels[0], texels, octave.standardDeviation, 1.0 / octave.latticeSize);
  }
  const float speed = static_cast<float>(texture.driftSpeed);
  for (Texel& texel : texture.levels[0]) texel.rate -= speed * texel.slopeX;
  for (std::uint32_t size = texels; size > 1; size /= 2) {
    texture.levels.push_back(halved(texture.levels.back(), size));
  }
}

void CachedOctaves::step(double t) {
  for (std::size_t p = 0; p < textures_.size(); ++p) fill(textures_[p], p * octavesPerTexture, t);
}

void CachedOctaves::sample(std::span<const double> x, std::span<const double> y,
                           Interpolation interpolation, double detail, std::span<Texel> out) const {
  Store store = Store::set;
  const double whole = std::floor(detail);
  for (const Texture& texture : textures_) {
    for (const std::size_t next : {0u, 1u}) {
      const double weight = next ? detail - whole : 1.0 - (detail - whole);
      const std::size_t level =
          std::min(static_cast<std::size_t>(whole) + next, texture.levels.size() - 1);
      if (weight == 0.0) continue;
      const double perMetre = 1.0 / std::ldexp(texture.texelSize, static_cast<int>(level));
      const TexelGrid grid{texture.levels[level].data(), texels >> level, perMetre,
                           -texture.drift * perMetre - 0.5, -0.5};
      lookUp(grid, interpolation, x.data(), y.data(), x.size(), static_cast<float>(weight), store,
             out.data());
      store = Store::add;
    }
  }
}

std::vector<double> CachedOctaves::exactHeights(std::size_t texture,
                                                std::span<const glm::dvec2> points,
                                                double t) const {
  const Texture& from = textures_[texture];
  std::vector<double> heights(points.size(), 0.0);
  for (std::size_t i = 0; i < octavesPerTexture; ++i) {
    const Octave& octave = from.octaves[i];
    const PeriodicNoise noise(seedOf(texture * octavesPerTexture + i), baseCells << i,
                              octave.boilTime, t);
    for (std::size_t p = 0; p < points.size(); ++p) {
      const double u = (points[p].x - from.driftSpeed * t) / octave.latticeSize;
      heights[p] += octave.standardDeviation * noise.at(u, points[p].y / octave.latticeSize);
    }
  }
  return heights;
}

std::vector<double> CachedOctaves::exactHeights(std::span<const glm::dvec2> points,
                                                double t) const {
  std::vector<double> heights = exactHeights(0, points, t);
  const std::vector<double> second = exactHeights(1, points, t);
  for (std::size_t p = 0; p < points.size(); ++p) heights[p] += second[p];
  return heights;
}

glm::dvec2 CachedOctaves::texelCentre(std::size_t texture, std::uint32_t i, std::uint32_t j) const {
  const Texture& from = textures_[texture];
  return {from.drift + (i + 0.5) * from.texelSize, (j + 0.5) * from.texelSize};
}

std::size_t CachedOctaves::memoryBytes() const {
  std::size_t count = 0;
  for (const Texture& texture : textures_) {
    for (const auto& level : texture.levels) count += level.size();
  }
  return count * sizeof(Texel);
}

}  // namespace seaway::rivals
