#include "surface/spectra/directional_spectrum.h"

#include <gtest/gtest.h>

#include <cmath>

#include "surface/constants.h"

namespace seaway {
namespace {

DirectionalSpectrum grid() {
  DirectionalSpectrum spectrum;
  spectrum.energy.frequency = {0.1, 0.2};
  spectrum.direction = {0.0, 0.5 * pi, pi, 1.5 * pi};
  spectrum.density = {2.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0};
  spectrum.integrateGrid();
  return spectrum;
}

TEST(DirectionalSpectrum, AGridIntegratesToEnergyAndMoments) {
  const DirectionalSpectrum spectrum = grid();
  EXPECT_FALSE(spectrum.validate());
  EXPECT_NEAR(spectrum.energy.density[0], 4.0 * 0.5 * pi, 1e-12);
  EXPECT_NEAR(spectrum.moments[0].a1, 0.5, 1e-12);
  EXPECT_NEAR(spectrum.moments[0].b1, 0.0, 1e-12);
  EXPECT_NEAR(spectrum.moments[0].a2, 0.0, 1e-12);
  EXPECT_NEAR(spectrum.moments[0].r1(), 0.5, 1e-12);
  EXPECT_NEAR(spectrum.moments[0].spread(), 1.0, 1e-12);
}

TEST(DirectionalSpectrum, WithoutEnergyAFrequencyHasNoDirection) {
  const DirectionalSpectrum spectrum = grid();
  EXPECT_EQ(spectrum.energy.density[1], 0.0);
  EXPECT_FALSE(spectrum.moments[1].hasFirst());
  EXPECT_FALSE(spectrum.moments[1].hasSecond());
}

TEST(DirectionalSpectrumHard, ValidateNamesWhatIsWrong) {
  const auto faultAfter = [](auto change) {
    DirectionalSpectrum spectrum = grid();
    change(spectrum);
    return spectrum.validate().value_or("nothing");
  };
  EXPECT_EQ(faultAfter([](DirectionalSpectrum&) {}), "nothing");
  EXPECT_EQ(faultAfter([](DirectionalSpectrum& s) { s.moments.pop_back(); }),
            "1 directional moments for 2 frequencies");
  EXPECT_EQ(faultAfter([](DirectionalSpectrum& s) { s.density.pop_back(); }),
            "7 densities for 2 frequencies and 4 directions");
  EXPECT_EQ(faultAfter([](DirectionalSpectrum& s) { s.moments[0].a1 = 1.2; }),
            "directional moment above 1 at 0.1 Hz");
  EXPECT_EQ(faultAfter([](DirectionalSpectrum& s) { s.density[5] = -1.0; }),
            "density -1 m2/Hz/rad at 0.2 Hz is not allowed; must be finite and >= 0");
  EXPECT_EQ(faultAfter([](DirectionalSpectrum& s) { s.density[0] = NAN; }),
            "density nan m2/Hz/rad at 0.1 Hz is not allowed; must be finite and >= 0");
  EXPECT_NE(faultAfter([](DirectionalSpectrum& s) { s.energy.frequency[1] = 0.1; }), "nothing");
}

}  // namespace
}  // namespace seaway
