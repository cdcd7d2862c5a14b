#include <algorithm>
#include <cmath>

#include "tests/sim_bridge/capi/support.h"

namespace seaway::bridge::test {
namespace {

/// A picture with room for exactly its pixels.
struct Picture {
  std::vector<std::uint8_t> rgb;
  std::vector<float> depth;
  seaway_image image = seaway_image_default();
  Picture(std::uint32_t width, std::uint32_t height)
      : rgb(3 * width * height, 1), depth(width * height, -1.0f) {
    image.width = width;
    image.height = height;
    image.rgb = rgb.data();
    image.rgb_size = rgb.size();
    image.depth = depth.data();
    image.depth_size = depth.size();
  }
};

seaway_camera looksNorthFrom(double height) {
  seaway_camera camera = seaway_camera_default();
  camera.latitude_deg = 28.878;
  camera.longitude_deg = -78.467;
  camera.height = height;
  return camera;
}

TEST(CapiPictures, ShowSkyAboveAndWaterBelowTheHorizon) {
  const SeaPointer sea = seaFrom(openSea);
  Picture picture(64, 48);
  const seaway_camera camera = looksNorthFrom(10.0);
  ASSERT_EQ(seaway_sea_render(sea.get(), nullptr, &camera, nullptr, &picture.image), SEAWAY_OK)
      << seaway_last_error();
  for (std::size_t x = 0; x < 64; ++x) {
    EXPECT_TRUE(std::isinf(picture.depth[x]));
    const float nearest = picture.depth[47 * 64 + x];
    // The last row looks 29° down: 10 m / tan 29° away on flat water, with waves of a metre or two.
    EXPECT_GT(nearest, 12.0f);
    EXPECT_LT(nearest, 24.0f);
  }
  const std::uint8_t* sky = &picture.rgb[3 * 32];
  const std::uint8_t* water = &picture.rgb[3 * (47 * 64 + 32)];
  EXPECT_GT(static_cast<int>(sky[2]), static_cast<int>(water[2]));
}

TEST(CapiPictures, DepthIsTheDistanceThatARayMeasures) {
  const SeaPointer sea = seaFrom(openSea);
  Picture picture(1, 1);
  seaway_camera camera = looksNorthFrom(12.0);
  camera.pitch_deg = -40.0;
  camera.field_of_view_deg = 1.0;
  ASSERT_EQ(seaway_sea_render(sea.get(), nullptr, &camera, nullptr, &picture.image), SEAWAY_OK);
  const double angle = 40.0 * M_PI / 180.0;
  const double origin[] = {0, 0, 12}, direction[] = {0, std::cos(angle), -std::sin(angle)};
  double distance = 0.0;
  ASSERT_EQ(seaway_sea_cast_rays(sea.get(), 0.0, 1, origin, direction, nullptr, &distance),
            SEAWAY_OK);
  // The grid's 256 rows are spread over 1° here: what they cannot carry is far below a centimetre.
  EXPECT_NEAR(picture.depth[0], distance, 0.02);
}

TEST(CapiPictures, ComeFromTheScenesCameras) {
  const SeaPointer sea = seaFrom(boats);
  Picture first(64, 48), bow(64, 48), mast(64, 48);
  ASSERT_EQ(seaway_sea_render(sea.get(), nullptr, nullptr, nullptr, &first.image), SEAWAY_OK)
      << seaway_last_error();
  ASSERT_EQ(seaway_sea_render(sea.get(), "bow", nullptr, nullptr, &bow.image), SEAWAY_OK);
  ASSERT_EQ(seaway_sea_render(sea.get(), "mast", nullptr, nullptr, &mast.image), SEAWAY_OK);
  EXPECT_EQ(first.depth, bow.depth);
  EXPECT_NE(first.depth, mast.depth);
  EXPECT_EQ(seaway_sea_render(sea.get(), "mist", nullptr, nullptr, &mast.image), SEAWAY_NOT_FOUND);
  EXPECT_NE(std::string(seaway_last_error()).find("did you mean 'mast'"), std::string::npos);
}

TEST(CapiPictures, TakeTheScenesSizeForNone) {
  const SeaPointer sea = seaFrom(openSea);
  std::uint32_t width = 0, height = 0;
  ASSERT_EQ(seaway_sea_picture_size(sea.get(), &width, &height), SEAWAY_OK);
  EXPECT_EQ(width, 64u);
  EXPECT_EQ(height, 48u);
  Picture picture(64, 48);
  picture.image.width = picture.image.height = 0;
  const seaway_camera camera = looksNorthFrom(10.0);
  EXPECT_EQ(seaway_sea_render(sea.get(), nullptr, &camera, nullptr, &picture.image), SEAWAY_OK);
  EXPECT_EQ(std::count(picture.depth.begin(), picture.depth.end(), -1.0f), 0);
}

TEST(CapiPicturesHard, TooSmallBuffersStayAsTheyAre) {
  const SeaPointer sea = seaFrom(openSea);
  const seaway_camera camera = looksNorthFrom(10.0);
  Picture picture(64, 48);
  const Picture untouched = picture;
  picture.image.rgb_size -= 1;
  EXPECT_EQ(seaway_sea_render(sea.get(), nullptr, &camera, nullptr, &picture.image),
            SEAWAY_BUFFER_TOO_SMALL);
  EXPECT_NE(std::string(seaway_last_error()).find("9216"), std::string::npos);
  picture.image.rgb_size += 1;
  picture.image.depth_size -= 1;
  EXPECT_EQ(seaway_sea_render(sea.get(), nullptr, &camera, nullptr, &picture.image),
            SEAWAY_BUFFER_TOO_SMALL);
  EXPECT_EQ(picture.rgb, untouched.rgb);
  EXPECT_EQ(picture.depth, untouched.depth);
}

TEST(CapiPicturesHard, RefuseSizesCamerasAndBackendsThatCannotBe) {
  const SeaPointer sea = seaFrom(openSea);
  Picture picture(64, 48);
  seaway_camera camera = looksNorthFrom(10.0);
  const auto render = [&] {
    return seaway_sea_render(sea.get(), nullptr, &camera, nullptr, &picture.image);
  };
  picture.image.width = 8193;
  EXPECT_EQ(render(), SEAWAY_BAD_ARGUMENT);
  picture.image.width = 0;
  EXPECT_EQ(render(), SEAWAY_BAD_ARGUMENT);
  picture.image.width = 64;
  camera.latitude_deg = NAN;
  EXPECT_EQ(render(), SEAWAY_BAD_ARGUMENT);
  camera = looksNorthFrom(10.0);
  camera.field_of_view_deg = 180.0;
  EXPECT_EQ(render(), SEAWAY_BAD_ARGUMENT);
  camera = looksNorthFrom(10.0);
  camera.mount = "nobody";
  EXPECT_EQ(render(), SEAWAY_NOT_FOUND);
  camera.mount = nullptr;
  seaway_render_options options = seaway_render_options_default();
  options.backend = "crayon";
  EXPECT_EQ(seaway_sea_render(sea.get(), nullptr, &camera, &options, &picture.image),
            SEAWAY_BAD_INPUT);
  EXPECT_EQ(seaway_sea_render(sea.get(), nullptr, nullptr, nullptr, &picture.image),
            SEAWAY_NOT_FOUND);  // the scene has no camera
}

}  // namespace
}  // namespace seaway::bridge::test
