#include "surface/spectra/new_wave.h"

#include <gtest/gtest.h>

#include <cmath>

#include "surface/constants.h"
#include "surface/field/wave_field.h"
#include "surface/input_error.h"
#include "surface/spectra/families.h"

namespace seaway {
namespace {

double heightAt(const WaveField& field, glm::dvec2 point, double t) {
  SurfaceSample sample;
  field.sampleReference(std::span(&point, 1), t, std::span(&sample, 1));
  return sample.height;
}

const NewWaveOptions focus{
    .crestHeight = 2.5, .place = {40.0, -30.0}, .time = 60.0, .toward = 0.4, .components = 96};

TEST(NewWave, TheCrestStandsAtItsPlaceAndTimeWithItsHeight) {
  const WaveField field(newWave(jonswap({4.0, 9.0, 3.3}), focus));
  EXPECT_NEAR(heightAt(field, focus.place, focus.time), 2.5, 1e-9);
  for (int n = 1; n < 200; ++n) {
    EXPECT_LT(heightAt(field, focus.place, focus.time + 0.2 * n), 2.5);
    EXPECT_LT(heightAt(field, focus.place, focus.time - 0.2 * n), 2.5);
  }
  EXPECT_LE(heightAt(field, focus.place, focus.time), field.heightBound() + 1e-12);
}

TEST(NewWave, ItsShapeInTimeIsTheAutocorrelationOfTheSpectrum) {
  const FrequencySpectrum spectrum = jonswap({4.0, 9.0, 3.3});
  const WaveField field(newWave(spectrum, focus));
  for (const double lag : {1.0, 4.5, 9.0}) {
    double sum = 0.0;
    for (std::size_t i = 1; i < spectrum.frequency.size(); ++i) {
      const double df = spectrum.frequency[i] - spectrum.frequency[i - 1];
      sum += df * spectrum.density[i] * std::cos(2.0 * pi * spectrum.frequency[i] * lag);
    }
    // 96 bands against 600: the narrow peak is resolved to a few per cent.
    EXPECT_NEAR(heightAt(field, focus.place, focus.time + lag), 2.5 * sum / spectrum.moment(0),
                0.06 * 2.5);
  }
}

TEST(NewWaveHard, OptionsOutOfRangeAreRejected) {
  EXPECT_THROW(newWave({{0.1, 0.2}, {0.0, 0.0}}, focus), InputError);
  EXPECT_THROW(newWave(jonswap({4.0, 9.0, 3.3}), {.crestHeight = 0.0}), InputError);
  EXPECT_THROW(newWave(jonswap({4.0, 9.0, 3.3}), {.components = 1}), InputError);
  EXPECT_THROW(newWave(jonswap({4.0, 9.0, 3.3}), {.depth = -1.0}), InputError);
}

}  // namespace
}  // namespace seaway
