#pragma once

#include <cstddef>
#include <functional>
#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <vector>

#include "surface/spectra/families.h"

namespace seaway::rivals {

/// Time at which models are compared, s.
inline constexpr double modelTime = 12.3;

/// One way to make a sea, ready at `modelTime`: how it answers, and what its answers are worth.
struct FieldModel {
  std::string name;               ///< such as "group 12"
  double spectralResidual = 0.0;  ///< √(∫(M − S)²/∫S²) of what it stands for
  std::size_t memoryBytes = 0;
  std::function<void()> step;  ///< what each time costs before any point; empty: nothing
  /// Heights and all that comes with them (slopes, ∂η/∂t) at points.
  std::function<void(std::span<const double> x, std::span<const double> y, std::span<float> height)>
      sample;
  /// Heights of its own exact field in double precision.
  std::function<std::vector<double>(std::span<const glm::dvec2> points)> exact;
};

FieldModel groupModel(const FrequencySpectrum& target, int octaves);
FieldModel perlinModel(const FrequencySpectrum& target, int octaves);
FieldModel regularModel(const FrequencySpectrum& target, int waves);
FieldModel sineModel(const FrequencySpectrum& target, int components);
/// Periodic tile by inverse FFT, `size`² nodes, 49 to the peak's wavelength.
FieldModel fftModel(const JonswapParameters& sea, std::uint32_t size, bool cubic);
/// Perlin octaves cached in tiled textures; `detail` is the mipmap level.
FieldModel cachedModel(const JonswapParameters& sea, bool cubic, double detail);

/// Root mean square of a model's heights less its own exact ones over 400 points within 10 km, m.
double heightError(const FieldModel& model);

}  // namespace seaway::rivals
