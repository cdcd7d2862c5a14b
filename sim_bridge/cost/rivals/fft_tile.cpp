#include "sim_bridge/cost/rivals/fft_tile.h"

#include <array>
#include <cmath>
#include <complex>
#include <random>

#include "sim_bridge/cost/rivals/spectrum_kernel.h"
#include "surface/constants.h"

namespace seaway::rivals {
namespace {

double frequencyOf(double k) { return std::sqrt(standardGravity * k) / (2.0 * pi); }

/// S(f) df/dk D(θ)/k at a wave vector, m⁴; the scale is set afterwards.
double density(const FrequencySpectrum& target, double kx, double ky) {
  const double k = std::hypot(kx, ky), f = frequencyOf(k);
  const double cosine = 0.5 * (1.0 + kx / k);  // cos²(θ/2)
  return target.at(f) * f / (2.0 * k) * std::pow(cosine, 10.0) / k;
}

/// Signed wave number of an index, in units of 2π/length; the Nyquist line counts as none.
int signedIndex(std::uint32_t n, std::uint32_t size) {
  const int i = static_cast<int>(n), whole = static_cast<int>(size);
  return 2 * i < whole ? i : i - whole;
}

std::vector<double> amplitudes(const FrequencySpectrum& target, std::uint32_t size, double dk) {
  std::vector<double> result(std::size_t{size} * size, 0.0);
  double variance = 0.0;
  for (std::uint32_t j = 0; j < size; ++j) {
    for (std::uint32_t i = 0; i < size; ++i) {
      if ((i == 0 && j == 0) || 2 * i == size || 2 * j == size) continue;
      const double part = density(target, dk * signedIndex(i, size), dk * signedIndex(j, size));
      result[std::size_t{j} * size + i] = std::sqrt(2.0 * part);
      variance += part;
    }
  }
  const double scale = target.significantWaveHeight() / (4.0 * std::sqrt(variance));
  for (double& amplitude : result) amplitude *= scale;
  return result;
}

}  // namespace

FftTile::FftTile(const FrequencySpectrum& target, std::uint32_t size, double length,
                 unsigned planning)
    : size_(size),
      length_(length),
      amplitude_(amplitudes(target, size, 2.0 * pi / length)),
      coefficients_(fftwf_alloc_complex(4 * std::size_t{size} * (size / 2 + 1))),
      texels_(std::size_t{size} * size) {
  const double dk = 2.0 * pi / length;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> angle(0.0, 2.0 * pi);
  std::vector<std::complex<double>> wave(amplitude_.size());
  for (std::size_t n = 0; n < wave.size(); ++n) {
    wave[n] = std::polar(0.5 * amplitude_[n], angle(random));
  }
  for (std::uint32_t j = 0; j < size; ++j) {
    for (std::uint32_t i = 0; i <= size / 2; ++i) {
      const std::size_t opposite = std::size_t{(size - j) % size} * size + (size - i) % size;
      const std::complex<double> p = wave[std::size_t{j} * size + i], m = std::conj(wave[opposite]);
      const double kx = dk * signedIndex(i, size), ky = dk * signedIndex(j, size);
      spectrum_.pReal.push_back(static_cast<float>(p.real()));
      spectrum_.pImaginary.push_back(static_cast<float>(p.imag()));
      spectrum_.mReal.push_back(static_cast<float>(m.real()));
      spectrum_.mImaginary.push_back(static_cast<float>(m.imag()));
      spectrum_.kx.push_back(static_cast<float>(kx));
      spectrum_.ky.push_back(static_cast<float>(ky));
      spectrum_.turnsPerSecond.push_back(frequencyOf(std::hypot(kx, ky)));
    }
  }
  const std::size_t padded = (halfCount() + 15) / 16 * 16;
  for (auto* list : {&spectrum_.pReal, &spectrum_.pImaginary, &spectrum_.mReal,
                     &spectrum_.mImaginary, &spectrum_.kx, &spectrum_.ky}) {
    list->resize(padded);
  }
  spectrum_.turnsPerSecond.resize(padded);
  const int n = static_cast<int>(size);
  const std::array<int, 2> sizes{n, n};
  plan_.reset(fftwf_plan_many_dft_c2r(2, sizes.data(), 4, coefficients_.get(), nullptr, 1,
                                      static_cast<int>(halfCount()), &texels_[0].height, nullptr, 4,
                                      1, planning));
}

void FftTile::step(double t) {
  advanceSpectrum(spectrum_, t, halfCount(), &coefficients_.get()[0][0]);
  fftwf_execute(plan_.get());
}

void FftTile::sample(std::span<const double> x, std::span<const double> y,
                     Interpolation interpolation, std::span<Texel> out) const {
  const TexelGrid grid{texels_.data(), size_, size_ / length_, 0.0, 0.0};
  lookUp(grid, interpolation, x.data(), y.data(), x.size(), 1.0f, Store::set, out.data());
}

double FftTile::exactHeight(glm::dvec2 point, double t) const {
  const double dk = 2.0 * pi / length_;
  std::vector<std::complex<double>> across(size_ / 2 + 1);
  for (std::uint32_t i = 0; i <= size_ / 2; ++i) across[i] = std::polar(1.0, dk * i * point.x);
  double sum = 0.0;
  std::size_t n = 0;
  for (std::uint32_t j = 0; j < size_; ++j) {
    const std::complex<double> along = std::polar(1.0, dk * signedIndex(j, size_) * point.y);
    for (std::uint32_t i = 0; i <= size_ / 2; ++i, ++n) {
      const std::complex<double> turn =
          std::polar(1.0, -2.0 * pi * spectrum_.turnsPerSecond[n] * t);
      const std::complex<double> p(spectrum_.pReal[n], spectrum_.pImaginary[n]);
      const std::complex<double> m(spectrum_.mReal[n], spectrum_.mImaginary[n]);
      const double part = ((p * turn + m * std::conj(turn)) * along * across[i]).real();
      sum += i == 0 ? part : 2.0 * part;  // the other half of the plane is the conjugate
    }
  }
  return sum;
}

std::vector<double> FftTile::bandVariance(const FrequencySpectrum& target, std::size_t bins) const {
  constexpr int parts = 16;  // a side of each wave vector's square
  const double dk = 2.0 * pi / length_, low = target.lowest();
  const double perHertz = static_cast<double>(bins) / (target.highest() - low);
  std::vector<double> variance(bins, 0.0);
  for (std::uint32_t n = 0; n < size_ * size_; ++n) {
    const double share = 0.5 * amplitude_[n] * amplitude_[n] / (parts * parts);
    if (share < 1e-16) continue;
    const int i = signedIndex(n % size_, size_), j = signedIndex(n / size_, size_);
    for (int part = 0; part < parts * parts; ++part) {
      const double kx = dk * (i - 0.5 + (part % parts + 0.5) / parts);
      const double ky = dk * (j - 0.5 + (part / parts + 0.5) / parts);
      const double bin = (frequencyOf(std::hypot(kx, ky)) - low) * perHertz;
      if (bin < 0.0 || bin >= static_cast<double>(bins)) continue;
      variance[static_cast<std::size_t>(bin)] += share;
    }
  }
  return variance;
}

std::size_t FftTile::memoryBytes() const {
  return texels_.size() * sizeof(Texel) +
         halfCount() * (4 * sizeof(fftwf_complex) + 6 * sizeof(float) + sizeof(double));
}

}  // namespace seaway::rivals
