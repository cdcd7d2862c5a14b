#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>

namespace seaway {

/// Forward discrete Fourier transform of real values, double precision:
/// X_m = Σ_n x_n exp(−2πi m n/N), m = 0 … N/2, not scaled.
///
/// Construction is serialised within the process, because planning shares state; `forward` on one
/// object is safe from any number of threads and, with FFTW, allocates nothing. Errors are below
/// 1e-14 of the largest bin for lengths up to 4096 (tests/surface/real_fft_test.cpp, against the
/// plain sum).
class RealFft {
 public:
  /// A transform of `size` ≥ 1 values; lengths of small prime factors are quickest. Throws
  /// std::runtime_error where it cannot be planned.
  explicit RealFft(std::size_t size);
  ~RealFft();
  RealFft(RealFft&&) noexcept;
  RealFft& operator=(RealFft&&) noexcept;

  std::size_t size() const { return size_; }
  std::size_t bins() const { return size_ / 2 + 1; }

  /// `values` has size() elements and is kept, `bins` has bins().
  void forward(std::span<const double> values, std::span<std::complex<double>> bins) const;

 private:
  struct Plan;
  std::size_t size_;
  std::unique_ptr<Plan> plan_;
};

}  // namespace seaway
