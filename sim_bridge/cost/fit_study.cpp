#include "sim_bridge/cost/study.h"
#include "surface/fit/octave_fit.h"
#include "surface/spectra/families.h"

namespace seaway::bridge {

Study studyFitOctaves(const StudyOptions& options) {
  Study study{"fit_octaves",
              "group octaves fitted to JONSWAP, gamma 3.3; error: relative L2 residual of S(f)",
              "",
              "ms/fit",
              {}};
  const FrequencySpectrum target = jonswap({2.0, 8.0, 3.3});
  const std::vector<int> counts =
      options.quick ? std::vector<int>{4, 8, 16} : std::vector<int>{4, 6, 8, 12, 16, 24, 32};
  for (const int count : counts) {
    OctaveFitOptions fitOptions;
    fitOptions.octaves = count;
    OctaveFit fit;
    const Timing timing =
        timeRepeated([&] { fit = fitGroupOctaves(target, fitOptions); }, options.quick ? 3 : 7);
    study.points.push_back({"octaves " + std::to_string(count), fit.summary.residualL2,
                            1e3 * timing.median, 1e3 * timing.spread, static_cast<double>(count)});
  }
  return study;
}

}  // namespace seaway::bridge
