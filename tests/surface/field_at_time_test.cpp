#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "surface/field/wave_field.h"

namespace seaway {
namespace {

struct Counts {
  int groups, perlins, regulars;
};

WaveField fieldOf(const Counts& counts) {
  std::vector<Octave> octaves;
  const auto frequency = [](int i) { return 0.1 + 0.004 * i; };
  for (int i = 0; i < counts.groups; ++i) {
    octaves.push_back(makeGroupOctave(0.05, frequency(i), 0.02, 0.1 * i, 0.5));
  }
  for (int i = 0; i < counts.perlins; ++i) {
    octaves.push_back(makePerlinOctave(0.04, 20.0 + i, 0.2 * i));
  }
  for (int i = 0; i < counts.regulars; ++i) {
    octaves.push_back(makeRegularWave(0.03, frequency(i), 0.3 * i));
  }
  return WaveField(octaves);
}

bool areSame(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

// What it held before, more octaves or fewer, of other kinds, must not show.
TEST(FieldAtTime, OneThatIsMovedHasTheBitsOfOneMadeThere) {
  const std::vector<Counts> all{{40, 20, 30}, {5, 0, 0}, {0, 3, 0},   {16, 0, 16},
                                {70, 40, 1},  {1, 1, 1}, {0, 0, 2},   {33, 0, 65},
                                {64, 32, 64}, {0, 0, 0}, {17, 17, 17}};
  const std::vector<glm::dvec2> places{{0.0, 0.0}, {13.5, -70.0}, {-400.0, 2.0}, {1e4, 1e5}};
  std::vector<SurfaceSample> moved(places.size()), made(places.size());
  const WaveField first = fieldOf({2, 2, 2});
  FieldAtTime water(first, 0.0);
  std::vector<WaveField> fields;
  for (const Counts& counts : all) fields.push_back(fieldOf(counts));
  for (int round = 0; round < 3; ++round) {
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const WaveField& field = fields[round == 1 ? fields.size() - 1 - i : i];
      const double t = 3.7 * static_cast<double>(i) + round;
      if (i % 4 == 3) water.moveTo(field, std::numeric_limits<double>::infinity());
      water.moveTo(field, t);
      const FieldAtTime anew(field, t);
      water.sample(places, moved);
      anew.sample(places, made);
      for (std::size_t k = 0; k < places.size(); ++k) {
        const SurfaceSample one = water.sample(places[k]);
        EXPECT_TRUE(areSame(moved[k].height, made[k].height)) << i << " " << k;
        EXPECT_TRUE(areSame(moved[k].slope.x, made[k].slope.x)) << i << " " << k;
        EXPECT_TRUE(areSame(moved[k].verticalVelocity, made[k].verticalVelocity)) << i << " " << k;
        EXPECT_TRUE(areSame(one.height, made[k].height)) << i << " " << k;
      }
    }
  }
}

}  // namespace
}  // namespace seaway
