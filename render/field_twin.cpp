#include "render/field_twin.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/grid_layout.h"
#include "surface/constants.h"
#include "surface/input_error.h"

namespace seaway::render {
namespace {

namespace shader {
using namespace glm;
using uint = unsigned int;
#define exact
#include "render/shaders/field.glsl"
#undef exact
}  // namespace shader

/// A linear coordinate around `origin`; whole units are handed on.
glm::vec4 around(glm::dvec2 origin, const LinearCoordinate& coordinate, double shift,
                 double& whole) {
  const double here = coordinate.at(origin) - shift;
  whole = std::nearbyint(here);
  return {glm::vec2(coordinate.gradient), static_cast<float>(here - whole), 0.0f};
}

/// The same for a lattice coordinate: the cell goes into the seed of its axis.
glm::vec4 latticeAround(glm::dvec2 origin, const LinearCoordinate& coordinate, std::uint32_t stride,
                        std::uint32_t& seed) {
  double cell = 0.0;
  const glm::vec4 result = around(origin, coordinate, 0.5, cell);
  seed += cellBits(cell) * stride;
  return result;
}

TwinOctave groupTwin(const GroupOctave& octave, double time, glm::dvec2 origin) {
  GroupAtTime now = octave.at(time);
  TwinOctave twin;
  double turns = 0.0;
  twin.first = latticeAround(origin, now.along, latticeStrideX, now.seeds.x);
  twin.second = latticeAround(origin, now.across, latticeStrideY, now.seeds.y);
  twin.third = around(origin, now.turns, 0.0, turns);
  twin.seeds = {now.seeds.x, now.seeds.y, 0u, 0u};
  twin.first.w = static_cast<float>(now.amplitude);
  twin.second.w = static_cast<float>(octave.wavelength());
  return twin;
}

TwinOctave regularTwin(const GroupOctave& octave, double time, glm::dvec2 origin) {
  const GroupAtTime now = octave.at(time);
  TwinOctave twin;
  double turns = 0.0;
  twin.first = around(origin, now.turns, 0.0, turns);
  twin.first.w = static_cast<float>(now.amplitude);
  twin.second.w = static_cast<float>(octave.wavelength());
  return twin;
}

TwinOctave perlinTwin(const PerlinOctave& octave, double time, glm::dvec2 origin) {
  PerlinOctave::AtTime now = octave.at(time);
  TwinOctave twin;
  for (LatticeSeeds& slice : now.slice) {
    twin.first = latticeAround(origin, now.first, latticeStrideX, slice.x);
    twin.second = latticeAround(origin, now.second, latticeStrideY, slice.y);
  }
  twin.third = {now.weight[0], now.weight[1], 0.0, 0.0};
  twin.seeds = {now.slice[0].x, now.slice[1].x, now.slice[0].y, now.slice[1].y};
  twin.first.w = static_cast<float>(now.amplitude);
  twin.second.w = static_cast<float>(octave.wavelength());
  return twin;
}

}  // namespace

glm::vec2 TwinRow::point(int column) const {
  const float x = static_cast<float>(column);
  return {x * step.x + start.x, x * step.y + start.y};
}

std::vector<TwinRow> twinRows(const Projector& projector, const WaveField& waves, glm::ivec2 size) {
  const GridLayout layout = projectedLayout(projector, waves, size);
  std::vector<TwinRow> rows;
  rows.reserve(layout.rows.size());
  for (const auto& [start, step, plan] : layout.rows) {
    rows.push_back({glm::vec2(start), glm::vec2(step), static_cast<float>(plan.keptWavelength),
                    static_cast<float>(plan.fadingWavelength), static_cast<float>(plan.weight),
                    static_cast<float>(plan.missingSlope)});
  }
  return rows;
}

FieldTwin::FieldTwin(const WaveField& waves, double time, glm::dvec2 origin) {
  if (!WaveField::serves(origin, time)) return;
  const OctaveLists lists = waves.lists();
  const std::size_t count = lists.groups.size() + lists.perlins.size() + lists.regulars.size();
  if (count > mostOctaves) {
    throw InputError("a sea of " + std::to_string(count) +
                     " octaves is too much for the graphics card: " + std::to_string(mostOctaves) +
                     " at most; let the processor compute the vertices");
  }
  octaves_.reserve(count);
  for (const GroupOctave& octave : lists.groups) {
    octaves_.push_back(groupTwin(octave, time, origin));
  }
  for (const PerlinOctave& octave : lists.perlins) {
    octaves_.push_back(perlinTwin(octave, time, origin));
  }
  for (const GroupOctave& octave : lists.regulars) {
    octaves_.push_back(regularTwin(octave, time, origin));
  }
  counts_ = {lists.groups.size(), lists.perlins.size(), lists.regulars.size()};
}

double FieldTwin::heightBound(const WaveField& waves, double reach) {
  double bound = 0.0;
  for (const Octave& octave : waves.octaves()) {
    const double turns = 1.0 + reach / dominantWavelength(octave);
    // 2⁻²⁴ each for gradient, product and sum; three standard deviations stand for the peak.
    bound += octave.standardDeviation * (3.0 * 2.0 * pi * 3.0 * turns + 20.0) * 0x1.0p-24;
  }
  return bound;
}

glm::vec3 FieldTwin::sample(glm::vec2 point, const TwinRow& row) const {
  const glm::vec4 band(row.keptWavelength, row.fadingWavelength, row.weight, row.missingSlope);
  glm::vec3 sum(0.0f);
  for (std::size_t i = 0; i < octaves_.size(); ++i) {
    const TwinOctave& octave = octaves_[i];
    const float part = shader::carriedPart(octave.second.w, band);
    if (part == 0.0f) continue;
    const int index = static_cast<int>(i);
    const glm::vec3 waves = index < counts_.x               ? shader::groupOctave(octave, point)
                            : index < counts_.x + counts_.y ? shader::perlinOctave(octave, point)
                                                            : shader::regularOctave(octave, point);
    sum = glm::vec3(waves.x * part + sum.x, waves.y * part + sum.y, waves.z * part + sum.z);
  }
  return sum;
}

}  // namespace seaway::render
