#include <kissfft/kiss_fft.h>

#include <limits>
#include <stdexcept>
#include <vector>

#include "surface/fft/complex_fft.h"

static_assert(sizeof(kiss_fft_scalar) == sizeof(float), "KissFFT must be built for float");

namespace seaway {
namespace {

/// KissFFT works out of place: one buffer a thread, as long as the longest transform it has done.
std::complex<float>* scratch(std::size_t size) {
  thread_local std::vector<std::complex<float>> values;
  if (values.size() < size) values.resize(size);
  return values.data();
}

kiss_fft_cpx* asKiss(std::complex<float>* values) {
  return reinterpret_cast<kiss_fft_cpx*>(values);
}

}  // namespace

struct ComplexFft::Plan {
  kiss_fft_cfg inverse;
  explicit Plan(int size) : inverse(kiss_fft_alloc(size, 1, nullptr, nullptr)) {}
  Plan(const Plan&) = delete;
  Plan& operator=(const Plan&) = delete;
  ~Plan() { kiss_fft_free(inverse); }
};

ComplexFft::ComplexFft(std::size_t size) : size_(size) {
  if (size < 1 || size > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw std::runtime_error("a Fourier transform of this length cannot be planned");
  }
  plan_ = std::make_shared<const Plan>(static_cast<int>(size));
  if (!plan_->inverse) {
    throw std::runtime_error("a Fourier transform of this length cannot be planned");
  }
}

void ComplexFft::inverse(std::complex<float>* values) const {
  std::complex<float>* const result = scratch(size_);
  kiss_fft(plan_->inverse, asKiss(values), asKiss(result));
  std::copy(result, result + size_, values);
}

void ComplexFft::inverseTogether(std::complex<float>* values) const {
  std::complex<float>* const results = scratch(size_ * together);
  for (std::size_t j = 0; j < together; ++j) {
    kiss_fft_stride(plan_->inverse, asKiss(values + j), asKiss(results + j * size_),
                    static_cast<int>(together));
  }
  for (std::size_t n = 0; n < size_; ++n) {
    for (std::size_t j = 0; j < together; ++j) values[n * together + j] = results[j * size_ + n];
  }
}

}  // namespace seaway
