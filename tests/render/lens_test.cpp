#include "render/lens.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <glm/geometric.hpp>
#include <random>

#include "render/exr.h"
#include "render/png.h"
#include "render/technique_choice.h"
#include "surface/input_error.h"
#include "surface/surface_ray.h"
#include "tests/render/hard_views.h"

// Lenses that bend, several samples a pixel, and what frames hold beside colour.
namespace seaway::render {
namespace {

const Distortion action{-0.28, 0.09, -0.012, 6e-4, -4e-4};  // an action camera's

View viewOf(const WaterSurface& water, const Camera& camera, EffectLedger& effects) {
  View view;
  view.water = &water;
  view.time = 3.0;
  view.camera = camera;
  view.effects = &effects;
  return view;
}

std::string refusal(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Lens, DistortsByOpenCVsFormula) {
  const Distortion d{-0.3, 0.1, 0.02, 0.001, -0.002};
  // The formula in the header of OpenCV's calib3d, worked out apart.
  const glm::dvec2 seen = distorted(d, {0.3, -0.2});
  EXPECT_NEAR(seen.x, 0.28808018199999996, 1e-15);
  EXPECT_NEAR(seen.y, -0.19209678800000002, 1e-15);
  EXPECT_EQ(distorted({}, {0.3, -0.2}), glm::dvec2(0.3, -0.2));
}

TEST(Lens, TheInverseIsWithinTenToTheMinusTwelfth) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  double worst = 0.0, worstPlace = 0.0;
  int found = 0;
  for (int i = 0; i < 20000; ++i) {
    const Distortion d{0.4 * unit(random), 0.2 * unit(random), 0.05 * unit(random),
                       0.01 * unit(random), 0.01 * unit(random)};
    const glm::dvec2 seen(unit(random), unit(random));
    const std::optional<glm::dvec2> place = undistorted(d, seen);
    if (!place) continue;
    ++found;
    worst = std::max(worst, glm::distance(distorted(d, *place), seen) / (1.0 + glm::length(seen)));
  }
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec2 place(0.8 * unit(random), 0.8 * unit(random));
    const std::optional<glm::dvec2> back = undistorted(action, distorted(action, place));
    ASSERT_TRUE(back.has_value());
    worstPlace = std::max(worstPlace, glm::distance(*back, place));
  }
  std::printf("of 20000 %d have an inverse; off by at most %.2g, places by %.2g\n", found, worst,
              worstPlace);
  EXPECT_GT(found, 12000);
  EXPECT_LE(worst, 1e-12);
  EXPECT_LE(worstPlace, 1e-11);  // the same by the derivatives' inverse, here at most 8
}

TEST(Lens, OnesThatFoldOrNeedTooMuchAreRefusedByTheirCoefficients) {
  Camera camera = test::cameraAt({0, 0, 5.0}, -10.0, 0.0, 90.0, {64, 48});
  const auto refused = [&](const Distortion& d) {
    camera.distortion = d;
    return refusal([&] { lensMap(camera, 1); });
  };
  EXPECT_NE(refused({.k1 = -0.6}).find("k1 = -0.6"), std::string::npos);  // largest r: 0.5 at 0.75
  EXPECT_NE(refused({.k1 = -1e9}).find("folds"), std::string::npos);
  EXPECT_NE(refused({.p1 = 5.0}).find("p1 = 5"), std::string::npos);
  EXPECT_NE(refused({.k1 = std::nan("")}).find("folds"), std::string::npos);
  EXPECT_EQ(refused({.k1 = -0.02}), "");
  EXPECT_EQ(refused({.k1 = 1e3}), "");  // strange, but each place is seen once
  camera.size = {4096, 4096};
  EXPECT_NE(refused({.k1 = 1.0}).find("undistorted picture of"), std::string::npos);
}

TEST(Lens, APictureIsWhatItsBentRaysMeet) {
  const WaterSurface water = test::groupSea(1.0, 6.0);
  Camera camera = test::cameraAt({0, 0, 5.0}, -14.0, 4.0, 60.0, {120, 90});
  const Intrinsics pinhole{95.0, 100.0, 52.0, 47.0};
  camera.intrinsics = pinhole;
  camera.distortion = action;
  EffectLedger effects;
  View view = viewOf(water, camera, effects);
  view.wantsNormals = view.wantsLabels = view.wantsRadiance = true;
  const Frame frame = makeLens(makeSoftwareGrid({.grid = {192, 384}}))->draw(view);
  test::expectSane(frame, camera.size);
  const SurfaceAtTime now = water.at(view.time);
  int other = 0;
  std::vector<double> errors, slips;
  for (int y = 0; y < 90; ++y) {
    for (int x = 0; x < 120; ++x) {
      const glm::dvec2 seen((x - pinhole.cx) / pinhole.fx, (y - pinhole.cy) / pinhole.fy);
      const glm::dvec2 place = *undistorted(action, seen);
      const glm::dvec3 ray =
          glm::normalize(camera.forward() - place.x * camera.left() - place.y * camera.up());
      const auto distance = distanceToWater(now, camera.position, ray);
      const std::size_t i = static_cast<std::size_t>(y) * 120 + x;
      const bool drawn = frame.classes[i] == PixelClass::water;
      other += drawn != distance.has_value();
      if (!drawn || !distance) continue;
      const double axial = *distance * glm::dot(ray, camera.forward());
      errors.push_back(std::abs(frame.depth.metres[i] / axial - 1.0));
    }
  }
  ASSERT_GT(errors.size(), 5000u);
  std::sort(errors.begin(), errors.end());
  std::printf("%zu pixels, depth off by %.4f (median), %.4f (90 %%); %d of another class\n",
              errors.size(), errors[errors.size() / 2], errors[errors.size() * 9 / 10], other);
  // Depth is that of the nearest pixel of the larger picture: half a pixel off, a hundredth of a
  // radian over a grazing angle of a quarter. Without the bend the median would be 0.06.
  EXPECT_LE(errors[errors.size() / 2], 0.015);
  EXPECT_LE(other, 90);  // a silhouette's length
}

TEST(Lens, ABentPictureOfAFlatFieldKeepsItsPlace) {
  // The sky alone, in which nothing but direction tells: radiance against the pinhole's own.
  const WaterSurface water = test::stillSea();
  Camera camera = test::cameraAt({0, 0, 5.0}, 40.0, 0.0, 50.0, {81, 61});
  EffectLedger effects;
  View view = viewOf(water, camera, effects);
  view.wantsRadiance = true;
  const auto lens = makeLens(makeSoftwareGrid({.grid = {64, 64}}));
  const Frame plain = lens->draw(view);
  view.camera.distortion = Distortion{.k1 = -0.2};
  const Frame bent = lens->draw(view);
  // The middle of the picture is the view axis, which no lens moves.
  const std::size_t middle = std::size_t{30} * 81 + 40;
  EXPECT_LE(glm::distance(bent.radiance[middle], plain.radiance[middle]), 1e-3f);
  // Its corner shows what lies farther out.
  const glm::dvec2 corner(-40.0 * camera.pixelExtent().x, -30.0 * camera.pixelExtent().y);
  EXPECT_GT(glm::length(*undistorted(*view.camera.distortion, corner)), glm::length(corner));
}

TEST(Lens, SamplesOfAPixelAreAveragedInLinearRadianceAndLabelsStayThoseOfItsCentre) {
  const WaterSurface water = test::groupSea(1.0, 6.0);
  const Camera camera = test::cameraAt({0, 0, 5.0}, -8.0, 4.0, 60.0, {64, 40});
  const auto plain = makeSoftwareGrid({.grid = {128, 256}});
  const auto lens = makeLens(makeSoftwareGrid({.grid = {128, 256}}));
  EffectLedger effects;
  View view = viewOf(water, camera, effects);
  view.wantsRadiance = view.wantsLabels = view.wantsNormals = true;
  const Frame once = plain->draw(view);
  View large = view;
  large.camera.size *= 3;
  const Frame fine = plain->draw(large);
  view.samplesPerSide = 3;
  const Frame often = lens->draw(view);
  EXPECT_EQ(often.classes, once.classes);
  EXPECT_EQ(often.depth.metres, once.depth.metres);
  EXPECT_EQ(often.foam, once.foam);
  float worst = 0.0f;
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 64; ++x) {
      glm::vec3 sum(0.0f);
      for (int i = 0; i < 9; ++i) {
        sum += fine.radiance[static_cast<std::size_t>(3 * y + i / 3) * 192 + 3 * x + i % 3];
      }
      const glm::vec3 mean = often.radiance[static_cast<std::size_t>(y) * 64 + x];
      worst = std::max(worst, glm::distance(mean, sum / 9.0f) / (1e-3f + glm::length(mean)));
    }
  }
  EXPECT_LE(worst, 1e-6f);  // float sums of nine
  EXPECT_NE(often.colour.rgb, once.colour.rgb);
}

TEST(Lens, ColoursAreTheSameBitsWhetherRadianceAndLabelsAreAskedForOrNot) {
  const WaterSurface water = test::groupSea(2.0, 7.0);
  const Camera camera = test::cameraAt({0, 0, 6.0}, -9.0, 5.0, 60.0, {96, 64});
  EffectLedger effects;
  View view = viewOf(water, camera, effects);
  view.light.windSpeed = 14.0;
  const Frame bare = makeSoftwareGrid({.grid = {96, 96}})->draw(view);
  view.wantsRadiance = view.wantsLabels = true;
  const Frame full = makeSoftwareGrid({.grid = {96, 96}})->draw(view);
  EXPECT_EQ(bare.colour.rgb, full.colour.rgb);
  EXPECT_TRUE(bare.radiance.empty() && bare.instances.empty() && bare.foam.empty());
  EXPECT_GT(full.exposure, 0.0f);
}

// What is glittering, foaming and rippling below a pixel is averaged as more samples would.
TEST(Lens, APictureIsAsBrightAsThatOfSixteenSamplesAPixel) {
  const WaterSurface water = test::groupSea(1.0, 6.0);
  Camera camera = test::cameraAt({0, 0, 8.0}, -12.0, 0.0, 50.0, {96, 64});
  EffectLedger effects;
  View view = viewOf(water, camera, effects);
  view.light.sunElevation = 0.3;
  view.light.sunDirection = 0.4;  // the view's azimuth: into the glitter
  view.wantsRadiance = true;
  const auto lens = makeLens(makeSoftwareGrid({.grid = {256, 512}}));
  const auto meanLuminance = [](const Frame& frame) {
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < frame.classes.size(); ++i) {
      if (frame.classes[i] != PixelClass::water) continue;
      sum += glm::dot(frame.radiance[i], glm::vec3(0.2126f, 0.7152f, 0.0722f));
      ++count;
    }
    return sum / count;
  };
  const double once = meanLuminance(lens->draw(view));
  view.samplesPerSide = 4;
  const double often = meanLuminance(lens->draw(view));
  std::printf("mean luminance of water %.4f, by sixteen samples %.4f\n", once, often);
  EXPECT_NEAR(once / often, 1.0, 0.05);
}

Mesh cube(float half) {
  Mesh mesh;
  mesh.parts.push_back({{}, glm::vec3(0.6f)});
  const auto at = [&](int i) {
    return glm::vec3(i & 1 ? half : -half, i & 2 ? half : -half, i & 4 ? half : -half);
  };
  const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& f : faces) {
    for (const int i : {f[0], f[1], f[2], f[0], f[2], f[3]}) {
      mesh.parts[0].vertices.push_back(at(i));
    }
  }
  mesh.boundingRadius = 1.8 * half;
  return mesh;
}

TEST(Labels, InstancesAreTheFrontmostObjectsInEveryVariant) {
  const WaterSurface water = test::groupSea(1.5, 7.0);
  const Mesh mesh = cube(1.5f);
  Camera camera = test::cameraAt({0, 0, 4.0}, -8.0, 0.0, 50.0, {160, 100});
  camera.worldFromCamera = attitude(0.0, -0.14, 0.0);
  const SceneObject objects[] = {{&mesh, {20, 5, 0.5}, {1, 0, 0, 0}, 7},
                                 {&mesh, {20, -5, 0.5}, {1, 0, 0, 0}, 300},
                                 {&mesh, {30, -7.5, 0.5}, {1, 0, 0, 0}, 12},
                                 {&mesh, {16, 0, 0.5}, {1, 0, 0, 0}, 0}};
  EffectLedger effects;
  View view = viewOf(water, camera, effects);
  view.light.windSpeed = 16.0;
  view.objects = objects;
  view.wantsLabels = view.wantsRadiance = true;
  const auto at = [&](const Frame& frame, double x, double y) {
    const glm::dvec3 p = glm::dvec3(x, y, 0.9) - camera.position;
    const Intrinsics pinhole = camera.pinhole();
    const double axial = glm::dot(p, camera.forward());
    const int column =
        static_cast<int>(std::lround(pinhole.cx - pinhole.fx * glm::dot(p, camera.left()) / axial));
    const int row =
        static_cast<int>(std::lround(pinhole.cy - pinhole.fy * glm::dot(p, camera.up()) / axial));
    return frame.instances[static_cast<std::size_t>(row) * 160 + column];
  };
  const Frame truth = makeSoftwareGrid({.grid = {128, 256}})->draw(view);
  EXPECT_EQ(at(truth, 20, 5), 7);
  EXPECT_EQ(at(truth, 20, -5), 300);  // hides the one behind it
  EXPECT_EQ(at(truth, 16, 0), 0);     // none is asked for
  double foam = 0.0;
  for (std::size_t i = 0; i < truth.classes.size(); ++i) {
    if (truth.classes[i] != PixelClass::object) {
      EXPECT_EQ(truth.instances[i], 0);
    }
    if (truth.classes[i] != PixelClass::water) {
      EXPECT_EQ(truth.foam[i], 0);
    }
    foam += truth.foam[i] / 255.0 / static_cast<double>(truth.foam.size());
  }
  EXPECT_GT(foam, 0.005);
  for (const GridVariant variant :
       {GridVariant::cpuVertices, GridVariant::gpu, GridVariant::marched}) {
    const Frame frame =
        makeProjectedGrid(test::sharedContext(), {.grid = {128, 256}, .variant = variant})
            ->draw(view);
    int ids = 0, radiances = 0;
    double white = 0.0;
    for (std::size_t i = 0; i < truth.classes.size(); ++i) {
      ids += frame.instances[i] != truth.instances[i];
      white += frame.foam[i] / 255.0 / static_cast<double>(frame.foam.size());
      radiances += glm::distance(frame.radiance[i], truth.radiance[i]) >
                   0.05f * (0.02f + glm::length(truth.radiance[i]));
    }
    std::printf("%s: %d pixels of other instances, foam %.4f of %.4f, %d other radiances\n",
                std::string(gridVariantName(variant)).c_str(), ids, white, foam, radiances);
    EXPECT_LE(ids, 16);  // of outlines some 250 pixels long
    // Whiteness is a ramp over slopes, of which each way loses its own within a pixel.
    EXPECT_NEAR(white, foam, 0.3 * foam);
    EXPECT_LE(radiances, 16000 / 20);  // outlines, and crests whose glints moved
  }
}

/// Bytes that the program's allocations hold; 0 where a sanitizer replaces them.
double heldBytes() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
}

TEST(LensMemory, OfTheLargerPictureIsWhatItsLimitCountsWith) {
  if (heldBytes() == 0.0) GTEST_SKIP() << "allocations are not counted here";
  const WaterSurface water = test::moderateSea();
  const auto taken = [&](glm::ivec2 size, int samples, double& pixels) {
    EffectLedger effects;
    Camera camera = test::cameraAt({0, 0, 6.0}, -6.0, 0.0, 60.0, size);
    if (samples == 1) camera.distortion = action;
    const glm::dvec2 larger(samples == 1 ? lensMap(camera, 1).wide.size : samples * size);
    pixels = larger.x * larger.y;
    View view = viewOf(water, camera, effects);
    view.samplesPerSide = samples;
    const double before = heldBytes();
    const auto technique = makeTechnique({.grid = {64, 64}});
    const Frame frame = technique->draw(view);
    return heldBytes() - before;
  };
  for (const int samples : {1, 3}) {
    double fewPixels = 0.0, manyPixels = 0.0;
    taken({64, 48}, samples, fewPixels);  // what is made once
    const double few = taken({320, 240}, samples, fewPixels);
    const double many = taken({960, 720}, samples, manyPixels);
    const double each = (many - few) / (manyPixels - fewPixels);
    std::printf("%d a side: %.1f bytes a pixel of the larger picture\n", samples, each);
    EXPECT_LT(each, lensBytesPerPixel);
    EXPECT_GT(each, 0.4 * lensBytesPerPixel);
  }
}

TEST(LensHard, OnePixelSixteenSamplesASideAndWhatIsTooMuch) {
  const WaterSurface water = test::groupSea(1.0, 6.0);
  Camera camera = test::cameraAt({0, 0, 5.0}, -20.0, 0.0, 60.0, {1, 1});
  camera.distortion = Distortion{.k1 = -0.2};
  EffectLedger effects;
  View view = viewOf(water, camera, effects);
  view.wantsLabels = view.wantsNormals = view.wantsRadiance = true;
  const auto lens = makeLens(makeSoftwareGrid({.grid = {32, 32}}));
  for (const int samples : {1, 2, 16}) {
    view.samplesPerSide = samples;
    view.camera.distortion = Distortion{.k1 = -0.2};
    test::expectSane(lens->draw(view), {1, 1});
    view.camera.distortion.reset();
    test::expectSane(lens->draw(view), {1, 1});
  }
  EXPECT_NE(refusal([&] { validateSamples({640, 480}, 17); }).find("17"), std::string::npos);
  EXPECT_NE(refusal([&] { validateSamples({640, 480}, 0); }).find("[1, 16]"), std::string::npos);
  EXPECT_NE(refusal([&] {
              validateSamples({8192, 8192}, 8);
            }).find("4294967296"),
            std::string::npos);
  EXPECT_EQ(refusal([&] { validateSamples({8192, 8192}, 1); }), "");
  // Techniques by themselves draw neither.
  view.samplesPerSide = 2;
  EXPECT_NE(refusal([&] { makeSoftwareGrid()->draw(view); }).find("2 samples"), std::string::npos);
  view.samplesPerSide = 1;
  view.camera.distortion = action;
  EXPECT_NE(refusal([&] { makeSoftwareGrid()->draw(view); }).find("distortion"), std::string::npos);
}

TEST(FrameFilesOfNumbers, RadianceGoesThroughHalfFloatsAndLabelsThroughEightOrSixteenBits) {
  const std::string folder = ::testing::TempDir();
  const glm::ivec2 size(3, 2);
  const std::vector<glm::vec3> radiance{
      {0.0f, 0.5f, 1.0f}, {1e-3f, 12.25f, 6e4f}, {1e9f, 1, 2}, {3, 4, 5}, {6, 7, 8}, {9, 10, 11}};
  const std::vector<float> metres{1.0f, 2.5f, INFINITY, 1e5f, 0.1f, 7.0f};
  glm::ivec2 read;
  writeRadianceExr(folder + "/r.exr", size, radiance, &metres);
  const std::vector<glm::vec3> back = readRadianceExr(folder + "/r.exr", read);
  ASSERT_EQ(read, size);
  for (std::size_t i = 0; i < back.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const float wanted = std::min(radiance[i][c], 65504.0f);  // the largest half
      EXPECT_NEAR(back[i][c], wanted, wanted * 0x1p-11f);
    }
  }
  EXPECT_EQ(readDepthExr(folder + "/r.exr", read), metres);
  writeRadianceExr(folder + "/r.exr", size, radiance, nullptr);
  EXPECT_THROW(readDepthExr(folder + "/r.exr", read), std::runtime_error);
  for (const std::uint16_t most : {std::uint16_t{255}, std::uint16_t{40000}}) {
    const std::vector<std::uint16_t> labels{0, 1, 2, 3, 17, most};
    writeGreyPng(folder + "/l.png", size, labels);
    EXPECT_EQ(readGreyPng(folder + "/l.png", read), labels);
  }
}

}  // namespace
}  // namespace seaway::render
