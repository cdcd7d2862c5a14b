#include "surface/field/field_section.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "surface/constants.h"

namespace seaway {
namespace {

/// Corner values of group octaves come scaled by 2¹⁶ out of the kernels.
constexpr double cornerScale = 0x1.0p-16;
/// Largest slope of a blend's angle, per cell: the kernels' rates are relative to it.
constexpr double blendRate = 15.0 / 16.0 * pi;

void set(Coordinates& coordinates, std::size_t i, const LinearCoordinate& value, double shift) {
  coordinates.x[i] = value.gradient.x;
  coordinates.y[i] = value.gradient.y;
  coordinates.offset[i] = value.offset - shift;
}

/// Factors of one derivative: `scale` times the coordinate's gradient and rate.
void setDerivative(DerivativeFactors& factors, std::size_t i, std::size_t which,
                   const LinearCoordinate& coordinate, double scale) {
  factors.slopeX[which][i] = static_cast<float>(scale * coordinate.gradient.x);
  factors.slopeY[which][i] = static_cast<float>(scale * coordinate.gradient.y);
  factors.rate[which][i] = static_cast<float>(scale * coordinate.rate);
}

/// One term of Dη/Dt: as ∂η/∂t, but at a place that drifts with the current.
void setMaterialRate(MotionFactors& motion, std::size_t i, std::size_t which,
                     const LinearCoordinate& coordinate, glm::dvec2 current, double scale) {
  const double rate = coordinate.rate + glm::dot(current, coordinate.gradient);
  motion.materialRate[which][i] = static_cast<float>(scale * rate);
}

void setMotion(MotionFactors& motion, std::size_t i, const GroupOctave& octave) {
  const glm::dvec2 along = octave.orbitalVelocityPerHeight();
  motion.waveNumber[i] = static_cast<float>(2.0 * pi / octave.wavelength());
  motion.alongX[i] = static_cast<float>(along.x);
  motion.alongY[i] = static_cast<float>(along.y);
  motion.squaredFrequency[i] =
      static_cast<float>(octave.angularFrequency() * octave.angularFrequency());
  motion.horizontal[i] = static_cast<float>(1.0 / (1.0 + octave.bedDecay()));
  motion.vertical[i] = static_cast<float>(1.0 / (1.0 - octave.bedDecay()));
}

void fill(GroupBlock& block, std::size_t i, const GroupOctave& octave, glm::dvec2 current,
          double t) {
  const GroupAtTime now = octave.at(t);
  set(block.along, i, now.along, 0.5);
  set(block.across, i, now.across, 0.5);
  set(block.turns, i, now.turns, 0.0);
  block.seedX[i] = now.seeds.x;
  block.seedY[i] = now.seeds.y;
  const double scale = now.amplitude * cornerScale;
  block.factors.height[i] = static_cast<float>(scale);
  setDerivative(block.factors, i, 0, now.turns, 2.0 * pi * scale);
  setDerivative(block.factors, i, 1, now.along, blendRate * scale);
  setDerivative(block.factors, i, 2, now.across, blendRate * scale);
  setMaterialRate(block.motion, i, 0, now.turns, current, 2.0 * pi * scale);
  setMaterialRate(block.motion, i, 1, now.along, current, blendRate * scale);
  setMaterialRate(block.motion, i, 2, now.across, current, blendRate * scale);
  setMotion(block.motion, i, octave);
  block.wavelength[i] = static_cast<float>(octave.wavelength());
}

void fill(RegularBlock& block, std::size_t i, const GroupOctave& octave, glm::dvec2 current,
          double t) {
  const GroupAtTime now = octave.at(t);
  set(block.turns, i, now.turns, 0.0);
  block.factors.height[i] = static_cast<float>(now.amplitude);
  setDerivative(block.factors, i, 0, now.turns, 2.0 * pi * now.amplitude);
  setMaterialRate(block.motion, i, 0, now.turns, current, 2.0 * pi * now.amplitude);
  setMotion(block.motion, i, octave);
  block.wavelength[i] = static_cast<float>(octave.wavelength());
}

void fill(PerlinBlock& block, std::size_t i, const PerlinOctave& octave, glm::dvec2, double t) {
  const PerlinOctave::AtTime now = octave.at(t);
  set(block.first, i, now.first, 0.5);
  set(block.second, i, now.second, 0.5);
  for (std::size_t slice = 0; slice < 2; ++slice) {
    block.seedX[slice][i] = now.slice[slice].x;
    block.seedY[slice][i] = now.slice[slice].y;
    block.weight[slice][i] = static_cast<float>(now.weight[slice]);
    block.weightRate[slice][i] = static_cast<float>(now.weightRate[slice]);
  }
  block.factors.height[i] = static_cast<float>(now.amplitude);
  block.factors.rate[0][i] = static_cast<float>(now.amplitude);
  setDerivative(block.factors, i, 1, now.first, now.amplitude);
  setDerivative(block.factors, i, 2, now.second, now.amplitude);
  block.wavelength[i] = static_cast<float>(octave.wavelength());
}

/// Fills the blocks of one section; places without an octave get zero factors.
template <class Octave, class Block, std::size_t N>
void fillBlocks(std::array<Block, N>& blocks, std::span<const Octave> octaves, std::size_t section,
                glm::dvec2 current, double t) {
  std::size_t next = section * N * octavesPerBlock;
  for (Block& block : blocks) {
    const std::size_t left = octaves.size() - std::min(next, octaves.size());
    if (left == 0) {
      block.count = 0;  // where readers stop: the rest may be of another time
      break;
    }
    if (left < octavesPerBlock) block = Block{};
    block.count = std::min(octavesPerBlock, left);
    for (std::size_t i = 0; i < block.count; ++i) fill(block, i, octaves[next + i], current, t);
    next += octavesPerBlock;
  }
}

}  // namespace

std::size_t FieldSection::count(const OctaveLists& lists) {
  const auto sections = [](std::size_t octaves, std::size_t blocks) {
    const std::size_t size = blocks * octavesPerBlock;
    return (octaves + size - 1) / size;
  };
  return std::max({std::size_t{1}, sections(lists.groups.size(), groupBlocks),
                   sections(lists.perlins.size(), perlinBlocks),
                   sections(lists.regulars.size(), regularBlocks)});
}

void FieldSection::prepare(const OctaveLists& lists, std::size_t section, double t) noexcept {
  section_ = section;
  fillBlocks(groups_, lists.groups, section, lists.current, t);
  fillBlocks(perlins_, lists.perlins, section, lists.current, t);
  fillBlocks(regulars_, lists.regulars, section, lists.current, t);
}

template <class Block, std::size_t N, class Action>
void FieldSection::forEachKept(const std::array<Block, N>& blocks, std::size_t kept,
                               float shortestWavelength, Action action) const {
  std::size_t first = section_ * N * octavesPerBlock;
  for (const Block& block : blocks) {
    if (block.count == 0 || first >= kept) break;
    const std::size_t count = std::min(block.count, kept - first);
    std::uint32_t octaves = 0;
    for (std::size_t i = 0; i < count; ++i) {
      if (block.wavelength[i] >= shortestWavelength) octaves |= 1u << i;
    }
    if (octaves != 0) action(block, octaves);
    first += octavesPerBlock;
  }
}

void FieldSection::addBatch(const KeptOctaves& kept, const double* x, const double* y,
                            std::size_t count, const FieldSums& sums) const noexcept {
  const float shortest = kept.shortestWavelength;
  forEachKept(groups_, kept.groups, shortest, [&](const auto& block, std::uint32_t octaves) {
    addGroupBatch(block, octaves, x, y, count, sums);
  });
  forEachKept(perlins_, kept.perlins, shortest, [&](const auto& block, std::uint32_t octaves) {
    addPerlinBatch(block, octaves, x, y, count, sums);
  });
  forEachKept(regulars_, kept.regulars, shortest, [&](const auto& block, std::uint32_t octaves) {
    addRegularBatch(block, octaves, x, y, count, sums);
  });
}

void FieldSection::addPoint(const KeptOctaves& kept, double x, double y,
                            const FieldSums& sums) const noexcept {
  const float shortest = kept.shortestWavelength;
  forEachKept(groups_, kept.groups, shortest, [&](const auto& block, std::uint32_t octaves) {
    addGroupPoint(block, octaves, x, y, sums);
  });
  forEachKept(perlins_, kept.perlins, shortest, [&](const auto& block, std::uint32_t octaves) {
    addPerlinPoint(block, octaves, x, y, sums);
  });
  forEachKept(regulars_, kept.regulars, shortest, [&](const auto& block, std::uint32_t octaves) {
    addRegularPoint(block, octaves, x, y, sums);
  });
}

}  // namespace seaway
