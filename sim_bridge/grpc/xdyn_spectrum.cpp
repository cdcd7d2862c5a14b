#include "sim_bridge/grpc/xdyn_spectrum.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "sim_bridge/grpc/xdyn_frame.h"
#include "surface/input_error.h"

namespace seaway::bridge::rpc {
namespace {

LocalWave localWave(const GroupOctave& octave, glm::dvec2 point, double t) {
  GroupAtTime now = octave.at(t);
  // A quarter turn apart, the envelope's two parts are the sides of the wave's own triangle.
  const double inPhase = octave.sample(point, now).height;
  now.turns.offset -= 0.25;
  const double quadrature = octave.sample(point, now).height;
  const LinearCoordinate& turns = now.turns;
  const double travelled = glm::dot(turns.gradient, point) + turns.rate * t;
  LocalWave wave;
  wave.amplitude = std::hypot(inPhase, quadrature);
  wave.waveNumber = 2.0 * pi * glm::length(turns.gradient);
  wave.frequency = -2.0 * pi * turns.rate;
  const glm::dvec2 direction = octave.direction();
  wave.direction = xdynDirectionFromPlane(std::atan2(direction.y, direction.x));
  const double argument = std::atan2(quadrature, inPhase) + 0.5 * pi;  // a sine's
  wave.phase = std::remainder(argument - 2.0 * pi * std::remainder(travelled, 1.0), 2.0 * pi);
  return wave;
}

}  // namespace

std::vector<LocalWave> localWaves(const WaveField& waves, glm::dvec2 point, double t) {
  const OctaveLists lists = waves.lists();
  if (!lists.perlins.empty()) {
    throw InputError("the sea's Perlin octaves are no waves of one length and direction");
  }
  std::vector<LocalWave> all;
  for (const GroupOctave& octave : lists.groups) all.push_back(localWave(octave, point, t));
  for (const GroupOctave& octave : lists.regulars) all.push_back(localWave(octave, point, t));
  return all;
}

}  // namespace seaway::bridge::rpc
