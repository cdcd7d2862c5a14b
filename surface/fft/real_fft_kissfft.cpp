#include <cassert>
#include <kissfft/kissfft.hh>
#include <limits>
#include <stdexcept>
#include <vector>

#include "surface/fft/real_fft.h"

namespace seaway {

/// KissFFT's header-only form: its compiled library is single precision.
struct RealFft::Plan {
  kissfft<double> forward;
  explicit Plan(std::size_t size) : forward(size, false) {}
};

RealFft::RealFft(std::size_t size) : size_(size) {
  if (size < 1 || size > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw std::runtime_error("a Fourier transform of this length cannot be planned");
  }
  plan_ = std::make_unique<Plan>(size);
}

RealFft::~RealFft() = default;
RealFft::RealFft(RealFft&&) noexcept = default;
RealFft& RealFft::operator=(RealFft&&) noexcept = default;

void RealFft::forward(std::span<const double> values, std::span<std::complex<double>> out) const {
  assert(values.size() == size() && out.size() == bins());
  thread_local std::vector<std::complex<double>> whole, transformed;
  whole.assign(values.begin(), values.end());
  transformed.resize(size_);
  // A copy, for it writes to buffers of its own.
  kissfft<double>(plan_->forward).transform(whole.data(), transformed.data());
  std::copy(transformed.begin(), transformed.begin() + static_cast<std::ptrdiff_t>(bins()),
            out.begin());
}

}  // namespace seaway
