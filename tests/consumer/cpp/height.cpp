#include <cmath>
#include <cstdio>

#include "surface/fit/octave_fit.h"
#include "surface/geodesy.h"
#include "surface/spectra/families.h"
#include "surface/water_surface.h"

// A height from the installed C++ library.
int main() {
  using namespace seaway;
  const OctaveFit fit = fitGroupOctaves(jonswap({1.12, 5.6, 3.3}));
  const WaterSurface water{WaveField(fit.octaves, {.seed = 7})};
  const Geodesy geodesy({28.878, -78.467, 0.0});
  const auto place = geodesy.seaPlaneFromGeodetic(28.8781, -78.4671).position;
  const SurfaceSample sample = water.sample(place, 12.5);
  std::printf("%.4f m +- %.4f m\n", sample.height, sample.bound);
  return std::isfinite(sample.height) ? 0 : 1;
}
