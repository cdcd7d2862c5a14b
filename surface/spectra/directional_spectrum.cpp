#include "surface/spectra/directional_spectrum.h"

#include <numbers>
#include <sstream>

namespace seaway {

std::optional<std::string> DirectionalSpectrum::validate() const {
  if (const auto wrong = energy.validate()) return wrong;
  const std::size_t count = energy.frequency.size();
  std::ostringstream message;
  if (!moments.empty() && moments.size() != count) {
    message << moments.size() << " directional moments for " << count << " frequencies";
    return message.str();
  }
  // Rounded tables give r slightly above 1.
  constexpr double highestR = 1.0 + 1e-2;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const DirectionalMoments& m = moments[i];
    if ((m.hasFirst() && m.r1() > highestR) ||
        (m.hasSecond() && std::hypot(m.a2, m.b2) > highestR)) {
      message << "directional moment above 1 at " << energy.frequency[i] << " Hz";
      return message.str();
    }
  }
  if (density.size() != count * direction.size()) {
    message << density.size() << " densities for " << count << " frequencies and "
            << direction.size() << " directions";
    return message.str();
  }
  for (std::size_t i = 0; i < density.size(); ++i) {
    if (!(std::isfinite(density[i]) && density[i] >= 0.0)) {
      message << "density " << density[i] << " m2/Hz/rad at "
              << energy.frequency[i / direction.size()]
              << " Hz is not allowed; must be finite and >= 0";
      return message.str();
    }
  }
  return std::nullopt;
}

void DirectionalSpectrum::integrateGrid() {
  const double width = 2.0 * std::numbers::pi / static_cast<double>(direction.size());
  const std::size_t count = energy.frequency.size();
  energy.density.assign(count, 0.0);
  moments.assign(count, {});
  for (std::size_t f = 0; f < count; ++f) {
    double sum = 0.0;
    DirectionalMoments m{0.0, 0.0, 0.0, 0.0};
    for (std::size_t d = 0; d < direction.size(); ++d) {
      const double part = at(f, d) * width;
      sum += part;
      m.a1 += part * std::cos(direction[d]);
      m.b1 += part * std::sin(direction[d]);
      m.a2 += part * std::cos(2.0 * direction[d]);
      m.b2 += part * std::sin(2.0 * direction[d]);
    }
    energy.density[f] = sum;
    if (sum > 0.0) moments[f] = {m.a1 / sum, m.b1 / sum, m.a2 / sum, m.b2 / sum};
  }
}

}  // namespace seaway
