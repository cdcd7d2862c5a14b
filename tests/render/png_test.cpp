#include "render/png.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "surface/input_error.h"

namespace seaway::render {
namespace {

namespace fs = std::filesystem;

ColourImage pattern(glm::ivec2 size) {
  ColourImage image;
  image.size = size;
  for (int i = 0; i < 3 * size.x * size.y; ++i) image.rgb.push_back((i * 37 + i / 7) % 256);
  return image;
}

class Png : public testing::Test {
 protected:
  Png() { fs::create_directories(folder_); }
  ~Png() override { fs::remove_all(folder_); }
  fs::path folder_ =
      fs::temp_directory_path() /
      ("seaway_png_" + std::to_string(testing::UnitTest::GetInstance()->random_seed()) +
       testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(Png, ReadsBackWhatWasWritten) {
  for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(17, 5), glm::ivec2(320, 200)}) {
    const ColourImage image = pattern(size);
    writePng(folder_ / "a.png", image);
    const ColourImage read = readPng(folder_ / "a.png");
    EXPECT_EQ(read.size, image.size);
    EXPECT_EQ(read.rgb, image.rgb);
  }
}

TEST_F(Png, LeavesNothingBesideTheFile) {
  writePng(folder_ / "a.png", pattern({8, 8}));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(Png, UnwritablePathIsAnInputErrorThatNamesIt) {
  const fs::path path = folder_ / "missing" / "a.png";
  try {
    writePng(path, pattern({2, 2}));
    FAIL() << "written";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos) << error.what();
  }
}

TEST_F(Png, DirectoryInPlaceOfTheFileIsAnInputErrorAndLeavesNoPartialFile) {
  fs::create_directories(folder_ / "a.png" / "inside");
  EXPECT_THROW(writePng(folder_ / "a.png", pattern({2, 2})), InputError);
  EXPECT_FALSE(fs::exists(folder_ / "a.png.partial"));
}

TEST_F(Png, ReadingSomethingElseIsAnInputError) {
  std::ofstream(folder_ / "a.png") << "not a picture";
  EXPECT_THROW(readPng(folder_ / "a.png"), InputError);
  EXPECT_THROW(readPng(folder_ / "none.png"), InputError);
}

TEST_F(Png, SizesThatDoNotMatchThePixelsAreRefused) {
  ColourImage image = pattern({4, 4});
  image.size = {4, 5};
  EXPECT_THROW(writePng(folder_ / "a.png", image), InputError);
  EXPECT_THROW(writePng(folder_ / "a.png", ColourImage{}), InputError);
}

}  // namespace
}  // namespace seaway::render
