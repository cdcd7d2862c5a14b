#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "surface/field/group_octave.h"
#include "surface/field/kernels/field_blocks.h"
#include "surface/field/perlin_octave.h"

namespace seaway {

/// Octaves by kind, each list in order of falling standard deviation, and the current they ride on.
struct OctaveLists {
  std::span<const GroupOctave> groups;
  std::span<const PerlinOctave> perlins;
  std::span<const GroupOctave> regulars;
  glm::dvec2 current{0.0};  ///< m/s (east, north)
};

/// Which octaves to evaluate: so many leading ones of each list, and of those only the ones that
/// are no shorter than a wavelength.
struct KeptOctaves {
  std::size_t groups = 0, perlins = 0, regulars = 0;
  float shortestWavelength = 0.0f;  ///< m
};

/// Up to 64 group, 32 Perlin and 64 regular octaves at one time, as the kernels read them. A field
/// with more has several sections.
class FieldSection {
 public:
  static constexpr std::size_t groupBlocks = 4, perlinBlocks = 2, regularBlocks = 4;

  /// Sections that lists of these sizes fill; at least 1.
  static std::size_t count(const OctaveLists& lists);

  /// Fills this object with section number `section` of the lists at time `t`.
  void prepare(const OctaveLists& lists, std::size_t section, double t) noexcept;

  /// Adds what is kept of this section at `count` ≤ pointsPerTile points; see FieldSums.
  void addBatch(const KeptOctaves& kept, const double* x, const double* y, std::size_t count,
                const FieldSums& sums) const noexcept;
  /// The same for one point, bit for bit.
  void addPoint(const KeptOctaves& kept, double x, double y, const FieldSums& sums) const noexcept;

 private:
  template <class Block, std::size_t N, class Action>
  void forEachKept(const std::array<Block, N>& blocks, std::size_t kept, float shortestWavelength,
                   Action action) const;

  std::array<GroupBlock, groupBlocks> groups_;
  std::array<PerlinBlock, perlinBlocks> perlins_;
  std::array<RegularBlock, regularBlocks> regulars_;
  std::size_t section_ = 0;
};

}  // namespace seaway
