#pragma once

#include <complex>
#include <cstddef>
#include <memory>

namespace seaway {

/// Inverse discrete Fourier transforms of complex values, single precision, in place, not scaled:
/// x_n = Σ_m X_m exp(+2πi m n/N).
///
/// Transforms are the same bits in every process on one machine: no plan depends on a measurement.
/// Errors are below 1e-6 of the largest value for lengths up to 1024
/// (tests/surface/complex_fft_test.cpp, against the plain sum in double).
///
/// Values lie on boundaries of 64 bytes (AlignedVector): FFTW uses no vector instructions
/// elsewhere. Construction is serialised within the process; transforms of one object are safe from
/// any number of threads and allocate nothing in the calling thread after its first transform.
/// Copies share their plans.
class ComplexFft {
 public:
  /// Transforms that `inverseTogether` does side by side.
  static constexpr std::size_t together = 4;

  /// Transforms of `size` ≥ 1 values; powers of two are quickest. Throws std::runtime_error where
  /// they cannot be planned.
  explicit ComplexFft(std::size_t size);

  std::size_t size() const { return size_; }

  /// One transform of size() values.
  void inverse(std::complex<float>* values) const;

  /// `together` transforms at once, value n of transform j at [n · together + j]: columns of a
  /// matrix that were copied side by side.
  void inverseTogether(std::complex<float>* values) const;

 private:
  struct Plan;
  std::size_t size_;
  std::shared_ptr<const Plan> plan_;
};

}  // namespace seaway
