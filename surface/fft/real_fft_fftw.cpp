#include <fftw3.h>

#include <cassert>
#include <limits>
#include <stdexcept>
#include <vector>

#include "surface/fft/fftw_planning.h"
#include "surface/fft/real_fft.h"

namespace seaway {
namespace {

fftw_complex* asFftw(std::complex<double>* bins) { return reinterpret_cast<fftw_complex*>(bins); }

}  // namespace

struct RealFft::Plan {
  fftw_plan plan = nullptr;
  explicit Plan(fftw_plan made) : plan(made) {}
  Plan(const Plan&) = delete;
  Plan& operator=(const Plan&) = delete;
  ~Plan() {
    const std::lock_guard lock(fftwPlanning());
    fftw_destroy_plan(plan);
  }
};

RealFft::RealFft(std::size_t size) : size_(size) {
  if (size < 1 || size > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw std::runtime_error("a Fourier transform of this length cannot be planned");
  }
  // FFTW_ESTIMATE touches neither array and makes the same plan every time. Callers' arrays have
  // any alignment.
  std::vector<double> values(size);
  std::vector<std::complex<double>> out(bins());
  fftw_plan plan = nullptr;
  {
    const std::lock_guard lock(fftwPlanning());
    plan = fftw_plan_dft_r2c_1d(static_cast<int>(size), values.data(), asFftw(out.data()),
                                FFTW_ESTIMATE | FFTW_UNALIGNED | FFTW_PRESERVE_INPUT);
  }
  if (!plan) throw std::runtime_error("a Fourier transform of this length cannot be planned");
  plan_ = std::make_unique<Plan>(plan);
}

RealFft::~RealFft() = default;
RealFft::RealFft(RealFft&&) noexcept = default;
RealFft& RealFft::operator=(RealFft&&) noexcept = default;

void RealFft::forward(std::span<const double> values, std::span<std::complex<double>> out) const {
  assert(values.size() == size() && out.size() == bins());
  // FFTW_PRESERVE_INPUT: the const is kept.
  fftw_execute_dft_r2c(plan_->plan, const_cast<double*>(values.data()), asFftw(out.data()));
}

}  // namespace seaway
