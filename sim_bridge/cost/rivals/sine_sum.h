#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "surface/field/wave_field.h"
#include "surface/spectra/frequency_spectrum.h"

namespace seaway::rivals {

/// One sine: amplitude · cos(k·x − ωt + phase), deep water.
struct SineComponent {
  double amplitude = 0.0;  ///< m
  double frequency = 0.0;  ///< Hz
  double toward = 0.0;     ///< rad
  double phase = 0.0;      ///< rad
};

/// Bands of frequency that carry one component each: narrow where the spectrum is high (edges at
/// equal shares of ∫√S df).
std::vector<double> bandEdges(const FrequencySpectrum& target, std::size_t count);

/// One component of random phase for each band, with the band's variance, at its middle.
std::vector<SineComponent> sineComponents(const FrequencySpectrum& target, std::size_t count);

/// Sum of sine components in vectors of points: phases are reduced in double, as the field's are.
class SineSum {
 public:
  explicit SineSum(std::span<const SineComponent> components);

  void prepare(double t);
  void sample(std::span<const double> x, std::span<const double> y,
              const FieldAtTime::Arrays& out) const;
  std::size_t memoryBytes() const;

  /// Components of one time, one array a constant.
  struct Prepared {
    std::vector<double> turnsPerMetreX, turnsPerMetreY, turns;
    std::vector<float> height, slopeX, slopeY, rate;  // factors of cos, sin, sin, sin
  };

 private:
  Prepared prepared_;
  std::vector<double> turnsPerSecond_, turnsAtStart_;
};

/// Height by std::cos in double: the truth.
double sineSumHeight(std::span<const SineComponent> components, glm::dvec2 point, double t);

}  // namespace seaway::rivals
