#include <fftw3.h>

#include <limits>
#include <stdexcept>

#include "surface/fft/aligned_vector.h"
#include "surface/fft/complex_fft.h"
#include "surface/fft/fftw_planning.h"

namespace seaway {
namespace {

fftwf_complex* asFftw(std::complex<float>* values) {
  return reinterpret_cast<fftwf_complex*>(values);
}

}  // namespace

struct ComplexFft::Plan {
  fftwf_plan one = nullptr;
  fftwf_plan side = nullptr;
  Plan() = default;
  Plan(const Plan&) = delete;
  Plan& operator=(const Plan&) = delete;
  ~Plan() {
    const std::lock_guard lock(fftwPlanning());
    if (one) fftwf_destroy_plan(one);
    if (side) fftwf_destroy_plan(side);
  }
};

ComplexFft::ComplexFft(std::size_t size) : size_(size) {
  if (size < 1 || size > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw std::runtime_error("a Fourier transform of this length cannot be planned");
  }
  // FFTW_ESTIMATE makes the same plan every time. For 512 values it is within a third of
  // FFTW_MEASURE where the columns lie side by side, but three times slower on columns in place.
  constexpr unsigned flags = FFTW_ESTIMATE;
  constexpr int side = static_cast<int>(together);
  const int length = static_cast<int>(size);
  AlignedVector<std::complex<float>> values(size * together);
  fftwf_complex* data = asFftw(values.data());
  const auto plan = std::make_shared<Plan>();
  {
    const std::lock_guard lock(fftwPlanning());
    plan->one = fftwf_plan_dft_1d(length, data, data, FFTW_BACKWARD, flags);
    plan->side = fftwf_plan_many_dft(1, &length, side, data, nullptr, side, 1, data, nullptr, side,
                                     1, FFTW_BACKWARD, flags);
  }
  if (!plan->one || !plan->side) {
    throw std::runtime_error("a Fourier transform of this length cannot be planned");
  }
  plan_ = plan;
}

void ComplexFft::inverse(std::complex<float>* values) const {
  fftwf_execute_dft(plan_->one, asFftw(values), asFftw(values));
}

void ComplexFft::inverseTogether(std::complex<float>* values) const {
  fftwf_execute_dft(plan_->side, asFftw(values), asFftw(values));
}

}  // namespace seaway
