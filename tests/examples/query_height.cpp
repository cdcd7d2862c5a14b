// Asks one sea for the water height under three hull points, through the library alone.
#include <cstdio>
#include <vector>

#include "surface/fit/octave_fit.h"
#include "surface/geodesy.h"
#include "surface/spectra/families.h"
#include "surface/water_surface.h"

int main() {
  using namespace seaway;
  const Geodesy geodesy({28.878, -78.467, 0.0});  // the scene's anchor
  const OctaveFit fit = fitGroupOctaves(jonswap({1.12, 5.6, 3.3}));
  if (!fit.summary.usable) return 1;
  const WaterSurface water{WaveField(fit.octaves, {.seed = 7})};

  std::vector<glm::dvec2> points;
  for (const double longitude_deg : {-78.4670, -78.4669, -78.4668}) {
    points.push_back(geodesy.seaPlaneFromGeodetic(28.878, longitude_deg).position);
  }
  std::vector<SurfaceSample> samples(points.size());
  water.sample(points, 12.5, samples, {.tolerance = 0.01});
  for (const SurfaceSample& sample : samples) {
    std::printf("%.3f m +- %.3f m, %s\n", sample.height, sample.error,
                statusText(sample.status).c_str());
  }
}
