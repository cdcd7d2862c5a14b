#include <cstdlib>
#include <cstring>
#include <vector>

#include "surface/disturbance/wake_system.h"
#include "surface/water_surface.h"

/// What is counted: valgrind --toggle-collect=sampleManyTimes.
extern "C" [[gnu::noinline]] double sampleManyTimes(const seaway::SurfaceAtTime& now,
                                                    const std::vector<glm::dvec2>& points,
                                                    std::vector<seaway::SurfaceSample>& samples,
                                                    int times) {
  double sum = 0.0;
  for (int i = 0; i < times; ++i) {
    now.sample(points, samples);
    sum += samples.back().height;
  }
  return sum;
}

/// sample_counted plain|idle POINTS TIMES: samples a sea of twelve octaves so often; `idle` with a
/// wake system that has nothing to tell. For idle_cost_test.cpp.
int main(int count, char** arguments) {
  using namespace seaway;
  if (count != 4) return 2;
  const bool idle = std::strcmp(arguments[1], "idle") == 0;
  std::vector<Octave> octaves;
  for (int i = 0; i < 12; ++i)
    octaves.push_back(makeGroupOctave(0.1, 0.1 + 0.03 * i, 0.02, 0.2 * i, 0.4));
  WaterSurface water{WaveField(octaves)};
  WakeSystem wakes;
  const std::uint32_t vessel = wakes.addVessel(HullFootprint::box(12.0, 3.0, 0.5));
  wakes.record(vessel, {0.0, {0.0, 0.0}, 0.0, 1.0});
  wakes.advance(0.0, {});
  if (idle) water.setDisturbances(wakes.feed());
  std::vector<glm::dvec2> points;
  for (int i = 0; i < std::atoi(arguments[2]); ++i) points.emplace_back(0.7 * i, -0.3 * i);
  std::vector<SurfaceSample> samples(points.size());
  const double sum = sampleManyTimes(water.at(1.0), points, samples, std::atoi(arguments[3]));
  return sum == 1e9 ? 1 : 0;
}
