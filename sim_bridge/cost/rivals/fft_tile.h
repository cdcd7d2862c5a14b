#pragma once

#include <fftw3.h>

#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <vector>

#include "sim_bridge/cost/rivals/texel_kernels.h"
#include "surface/spectra/frequency_spectrum.h"

namespace seaway::rivals {

/// The Fourier coefficients of a tile at t = 0, half the plane, one array a constant:
/// H(k, t) = p e^(−iωt) + m e^(iωt).
struct TileSpectrum {
  std::vector<float> pReal, pImaginary, mReal, mImaginary;
  std::vector<float> kx, ky;           // rad/m
  std::vector<double> turnsPerSecond;  // ω/2π
};

/// A periodic sea of `size`² nodes by inverse FFT: random phases on S(f) D(θ), deep water,
/// D ∝ cos²⁰(θ/2) about the x axis, scaled to the target's H_m0. `step` makes one time; points
/// are then looked up.
class FftTile {
 public:
  /// `planning` is FFTW's: FFTW_ESTIMATE or FFTW_MEASURE.
  FftTile(const FrequencySpectrum& target, std::uint32_t size, double length,
          unsigned planning = FFTW_ESTIMATE);

  void step(double t);
  void sample(std::span<const double> x, std::span<const double> y, Interpolation interpolation,
              std::span<Texel> out) const;
  const Texel& node(std::uint32_t i, std::uint32_t j) const { return texels_[j * size_ + i]; }

  /// The Fourier sum itself in double at any point: the truth.
  double exactHeight(glm::dvec2 point, double t) const;

  /// Spectrum that the tile stands for, each wave vector's variance spread evenly over its square
  /// of the wave-number plane, as variance in each of `bins` equal bands of the target's range.
  std::vector<double> bandVariance(const FrequencySpectrum& target, std::size_t bins) const;

  std::size_t memoryBytes() const;

 private:
  struct Release {
    void operator()(fftwf_plan_s* plan) const { fftwf_destroy_plan(plan); }
    void operator()(fftwf_complex* data) const { fftwf_free(data); }
  };
  std::size_t halfCount() const { return std::size_t{size_} * (size_ / 2 + 1); }

  std::uint32_t size_;
  double length_;
  TileSpectrum spectrum_;
  std::vector<double> amplitude_;                         // of every wave vector, row by row, m
  std::unique_ptr<fftwf_complex, Release> coefficients_;  // four planes: what a texel holds
  std::vector<Texel> texels_;
  std::unique_ptr<fftwf_plan_s, Release> plan_;
};

}  // namespace seaway::rivals
