#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "render/png.h"
#include "sim_bridge/gallery/gallery_drawing.h"
#include "sim_bridge/output/picture_file.h"

// Small pictures of configs/gallery.yaml against tests/golden. After a change that is meant to be
// seen: `./run gallery --golden tests/golden`, and look at contact_sheet.png there.
namespace seaway::bridge {
namespace {

const std::filesystem::path source(SEAWAY_SOURCE_DIR);

/// On one machine pictures are the same bits (AreTheSameBitsTwice). Other processors' vector units
/// fuse multiplications and additions, or do not: colours may come a step away, the rim of a crest
/// or of an object a pixel, foam's threshold in a few. No other processor has been measured: the
/// bounds are those of such rims, a hundredth of the pixels, and half a step on average a channel.
constexpr int farFrom = 12;       // 255ths of a channel
constexpr double mostFar = 0.01;  // of the pixels
constexpr double mostOnAverage = 0.5;

class GoldenPicture : public ::testing::TestWithParam<std::size_t> {};

const Gallery& gallery() {
  static const Gallery list = loadGallery(source / "configs/gallery.yaml");
  return list;
}

/// Leaves what was drawn and the difference beside the tests' binaries.
void keep(const GalleryPicture& picture, const render::ColourImage& drawn,
          const render::ColourImage& golden) {
  const std::filesystem::path folder =
      std::filesystem::path(SEAWAY_COMMAND).parent_path() / "golden";
  std::filesystem::create_directories(folder);
  writePicture(folder / (picture.name + ".png"), drawn);
  if (drawn.size == golden.size) {
    writePicture(folder / (picture.name + "_difference.png"), differencePicture(drawn, golden));
  }
  std::printf("see %s\n", folder.c_str());
}

TEST_P(GoldenPicture, IsDrawnAsItWas) {
  const GalleryPicture& picture = gallery().pictures[GetParam()];
  const DrawnPicture drawn = drawPicture(gallery(), picture, goldenSize, "osmesa", 0);
  const render::ColourImage golden =
      render::readPng(source / "tests/golden" / (picture.name + ".png"));
  ASSERT_EQ(drawn.frame.colour.size, golden.size);
  const PictureDifference d = differenceOf(drawn.frame.colour, golden, farFrom);
  std::printf("%s: mean %.4f, far %.4f %%, largest %d\n", picture.name.c_str(), d.meanAbsolute,
              100.0 * d.farShare, d.largest);
  EXPECT_LE(d.meanAbsolute, mostOnAverage);
  EXPECT_LE(d.farShare, mostFar);
  if (HasFailure()) keep(picture, drawn.frame.colour, golden);
}

INSTANTIATE_TEST_SUITE_P(Each, GoldenPicture,
                         ::testing::Range<std::size_t>(0, gallery().pictures.size()),
                         [](const auto& one) { return gallery().pictures[one.param].name; });

TEST(GoldenPictures, AreTheSameBitsTwiceAndInTheSecondFrame) {
  for (const char* name : {"calm", "harbour"}) {
    const auto at = std::find_if(gallery().pictures.begin(), gallery().pictures.end(),
                                 [&](const GalleryPicture& p) { return p.name == name; });
    ASSERT_NE(at, gallery().pictures.end());
    const DrawnPicture a = drawPicture(gallery(), *at, {96, 54}, "osmesa", 0);
    const DrawnPicture b = drawPicture(gallery(), *at, {96, 54}, "osmesa", 1);
    EXPECT_EQ(a.frame.colour.rgb, b.frame.colour.rgb) << name;
    EXPECT_EQ(a.frame.depth.metres, b.frame.depth.metres) << name;
  }
}

TEST(GoldenPictures, ADifferenceIsSeen) {
  render::ColourImage a{{4, 2}, std::vector<std::uint8_t>(24, 100)}, b = a;
  EXPECT_EQ(differenceOf(a, b, farFrom).largest, 0);
  b.rgb[4] = 140;
  const PictureDifference d = differenceOf(a, b, farFrom);
  EXPECT_EQ(d.largest, 40);
  EXPECT_DOUBLE_EQ(d.farShare, 1.0 / 8.0);
  EXPECT_DOUBLE_EQ(d.meanAbsolute, 40.0 / 24.0);
  EXPECT_EQ(differencePicture(a, b).rgb[4], 0);
  EXPECT_EQ(differencePicture(b, a).rgb[4], 255);
  const render::ColourImage sheet = contactSheet({a, b, a}, 2);
  EXPECT_EQ(sheet.size, glm::ivec2(12, 8));
  EXPECT_EQ(sheet.rgb[3 * (0 * 12 + 9) + 1], 140);  // pixel 1 of the second
  EXPECT_EQ(sheet.rgb[3 * (6 * 12 + 0)], 100);      // of the third, in the next row
}

}  // namespace
}  // namespace seaway::bridge
