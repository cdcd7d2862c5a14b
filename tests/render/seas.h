#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "render/headless_context.h"
#include "render/render_technique.h"
#include "surface/angles.h"
#include "surface/water_surface.h"

/// Seas and cameras that the tests of render/ share.
namespace seaway::render::test {

inline WaterSurface stillSea() { return WaterSurface(WaveField({})); }

/// Eight Perlin octaves with the fall-off of a wind sea. `longest` is the largest lattice size, m.
inline WaterSurface windSea(double significantWaveHeight, double longest) {
  std::vector<Octave> octaves;
  double variance = 0.0, lattice = longest;
  for (int i = 0; i < 8; ++i, lattice *= 0.5) {
    octaves.push_back(makePerlinOctave(std::pow(0.45, i), lattice, 0.3));
    variance += std::pow(0.45, 2 * i);
  }
  for (Octave& octave : octaves) {
    octave.standardDeviation *= 0.25 * significantWaveHeight / std::sqrt(variance);
  }
  return WaterSurface(WaveField(octaves));
}

/// Twelve group octaves around `peakPeriod` s that spread by ±0.5 rad, at which height falls off
/// as in a wind sea.
inline std::vector<Octave> groupOctaves(double significantWaveHeight, double peakPeriod,
                                        double depth = std::numeric_limits<double>::infinity()) {
  std::vector<Octave> octaves;
  double variance = 0.0;
  for (int i = 0; i < 12; ++i) {
    const double ratio = 0.8 * std::pow(1.12, i);
    const double a = std::pow(ratio, -2.0) * std::exp(-0.6 * std::pow(ratio, -4.0));
    octaves.push_back(makeGroupOctave(a, ratio / peakPeriod, 0.12 * ratio / peakPeriod,
                                      0.3 + 0.5 * std::sin(2.4 * i), 0.5, depth));
    variance += a * a;
  }
  for (Octave& octave : octaves) {
    octave.standardDeviation *= 0.25 * significantWaveHeight / std::sqrt(variance);
  }
  return octaves;
}

inline WaterSurface groupSea(double significantWaveHeight, double peakPeriod) {
  return WaterSurface(WaveField(groupOctaves(significantWaveHeight, peakPeriod)));
}

/// Every kind of octave, in 20 m of water and on a current.
inline WaterSurface mixedSea() {
  std::vector<Octave> octaves = groupOctaves(1.0, 6.0, 20.0);
  octaves.push_back(makePerlinOctave(0.1, 7.0, 1.0, 20.0));
  octaves.push_back(makePerlinOctave(0.04, 2.5, -0.4, 20.0));
  octaves.push_back(makeRegularWave(0.2, 0.09, 2.0, 0.7, 20.0));
  octaves.push_back(makeRegularWave(0.05, 0.4, -2.5, 0.1, 20.0));
  return WaterSurface(WaveField(octaves, {.seed = 11, .depth = 20.0, .current = {0.7, -0.4}}));
}

inline WaterSurface moderateSea() { return windSea(1.12, 25.0); }
inline WaterSurface stormSea() { return windSea(9.0, 130.0); }

inline Camera cameraAt(glm::dvec3 position, double pitch_deg, double roll_deg = 0.0,
                       double fov_deg = 60.0, glm::ivec2 size = {160, 90}) {
  Camera camera;
  camera.position = position;
  camera.worldFromCamera =
      attitude(0.4, radiansFromDegrees(pitch_deg), radiansFromDegrees(roll_deg));
  camera.verticalFieldOfView = radiansFromDegrees(fov_deg);
  camera.size = size;
  return camera;
}

/// One context for all tests of a process: starting one takes longer than most tests.
inline HeadlessContext& sharedContext() {
  static const std::unique_ptr<HeadlessContext> context = makeHeadlessContext("osmesa");
  context->makeCurrent();
  return *context;
}

/// A frame of `water`, with normals if asked.
inline Frame drawnBy(RenderTechnique& technique, const WaterSurface& water, const Camera& camera,
                     double time = 0.0, bool wantsNormals = true) {
  EffectLedger effects;
  View view;
  view.water = &water;
  view.time = time;
  view.camera = camera;
  view.effects = &effects;
  view.wantsNormals = wantsNormals;
  return technique.draw(view);
}

/// A frame of `water` by a projected grid of its own.
inline Frame drawn(const WaterSurface& water, const Camera& camera, double time = 0.0,
                   const ProjectedGridOptions& options = {}) {
  return drawnBy(*makeProjectedGrid(sharedContext(), options), water, camera, time, false);
}

/// The same without OpenGL.
inline Frame drawnInSoftware(const WaterSurface& water, const Camera& camera, double time = 0.0,
                             const ProjectedGridOptions& options = {}) {
  return drawnBy(*makeSoftwareGrid(options), water, camera, time, false);
}

}  // namespace seaway::render::test
