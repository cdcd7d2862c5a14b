#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "render/shading/pixel_shader.h"
#include "tests/render/stage.h"

// From radiance to the bytes of a picture: tone curves and dither.
namespace seaway::render {
namespace {

/// The curve in double, as a byte that is not rounded.
double shown(ToneCurve curve, double x) {
  double linear = x;
  if (curve == ToneCurve::filmic) {
    linear = x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
  }
  if (curve == ToneCurve::reinhard) linear = x * (1.0 + x / 16.0) / (1.0 + x);
  linear = std::min(linear, 1.0);
  return 255.0 *
         (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055);
}

constexpr ToneCurve curves[] = {ToneCurve::filmic, ToneCurve::reinhard, ToneCurve::linear};

std::vector<std::uint8_t> mapped(const std::vector<glm::vec3>& radiance, const ToneMapping& tones,
                                 glm::ivec2 first = {0, 0}) {
  std::vector<std::uint8_t> rgb(3 * radiance.size());
  mapTones(radiance, tones, first, rgb.data());
  return rgb;
}

TEST(ToneCurves, AreWhatTheirFormulasSay) {
  for (const ToneCurve curve : curves) {
    std::vector<glm::vec3> radiance;
    for (double x = 0.0; x < 20.0; x = 1.02 * x + 1e-4)
      radiance.push_back(glm::vec3(x, 0.5 * x, 0));
    const auto rgb = mapped(radiance, {.exposure = 0.5f, .curve = curve});
    for (std::size_t i = 0; i < radiance.size(); ++i) {
      // Half a byte of rounding, and half of the table's largest step.
      EXPECT_NEAR(rgb[3 * i], shown(curve, 0.5 * double{radiance[i].x}), 0.85);
      EXPECT_NEAR(rgb[3 * i + 1], shown(curve, 0.5 * double{radiance[i].y}), 0.85);
      EXPECT_EQ(rgb[3 * i + 2], 0);
    }
    EXPECT_EQ(mapped({glm::vec3(1e9f)}, {.curve = curve})[0], 255);
    EXPECT_EQ(mapped({glm::vec3(-1.0f)}, {.curve = curve})[0], 0);
  }
}

TEST(Dither, KeepsTheMeanThatRoundingLoses) {
  for (const double radiance : {0.02, 0.11, 0.3001, 0.9}) {
    const std::vector<glm::vec3> row(128, glm::vec3(static_cast<float>(radiance)));
    const double wanted = shown(ToneCurve::linear, radiance);
    double sum = 0.0;
    int least = 255, most = 0;
    for (int y = 0; y < 64; ++y) {
      const auto rgb = mapped(row, {.curve = ToneCurve::linear, .dithers = true}, {40, y});
      for (std::size_t i = 0; i < row.size(); ++i) {
        sum += rgb[3 * i];
        least = std::min<int>(least, rgb[3 * i]);
        most = std::max<int>(most, rgb[3 * i]);
      }
    }
    // The table's own step is up to 0.7 of a byte; 8192 thresholds are even to a hundredth.
    EXPECT_NEAR(sum / (64.0 * 128.0), wanted, 0.4) << radiance;
    EXPECT_LE(most - least, 1) << radiance;
    EXPECT_LE(most, wanted + 1.4) << radiance;
  }
}

TEST(Dither, OfAPieceOfARowIsThatOfTheRow) {
  std::vector<glm::vec3> row;
  for (int i = 0; i < 200; ++i) row.push_back(glm::vec3(0.2f + 0.001f * static_cast<float>(i)));
  const ToneMapping tones{.exposure = 1.0f, .curve = ToneCurve::filmic, .dithers = true};
  const auto whole = mapped(row, tones, {0, 7});
  const auto piece = mapped({row.begin() + 37, row.begin() + 90}, tones, {37, 7});
  EXPECT_TRUE(std::equal(piece.begin(), piece.end(), whole.begin() + 3 * 37));
}

TEST(Dither, InEveryTechniqueIsWithinAStepAndLeavesRadianceAlone) {
  test::Stage stage;
  // Sky alone: where edges are smoothed, neighbours' steps come together.
  stage.camera = test::cameraAt({0, 0, 50.0}, 40.0, 0.0, 40.0, {64, 48});
  for (const auto& way : test::everyWay({32, 32})) {
    SCOPED_TRACE(way.name);
    const auto drawn = [&](bool dithers) {
      test::Stage here = stage;
      here.light.dithers = dithers;
      EffectLedger effects;
      View view = here.view(effects);
      view.wantsRadiance = true;
      return way.technique->draw(view);
    };
    const Frame plain = drawn(false), dithered = drawn(true), again = drawn(true);
    EXPECT_EQ(plain.radiance, dithered.radiance);
    EXPECT_EQ(again.colour.rgb, dithered.colour.rgb);
    EXPECT_NE(plain.colour.rgb, dithered.colour.rgb);
    for (std::size_t i = 0; i < plain.colour.rgb.size(); ++i) {
      ASSERT_LE(std::abs(plain.colour.rgb[i] - dithered.colour.rgb[i]), 1) << i;
    }
  }
}

TEST(ToneCurves, AreTheSameInEveryTechnique) {
  test::Stage stage;
  stage.camera = test::cameraAt({0, 0, 50.0}, 10.0, 0.0, 40.0, {32, 24});
  for (const ToneCurve curve : curves) {
    stage.light.toneCurve = curve;
    for (const auto& way : test::everyWay({32, 32})) {
      SCOPED_TRACE(way.name);
      EffectLedger effects;
      View view = stage.view(effects);
      view.wantsRadiance = true;
      const Frame frame = way.technique->draw(view);
      // Sky alone: no edges that are smoothed. GL's radiance is of half floats.
      for (int x = 0; x < 32; ++x) {
        const double x0 = double{frame.radiance[static_cast<std::size_t>(x)].g} * frame.exposure;
        EXPECT_NEAR(frame.colour.rgb[3 * static_cast<std::size_t>(x) + 1], shown(curve, x0), 1.2);
      }
    }
  }
}

}  // namespace
}  // namespace seaway::render
