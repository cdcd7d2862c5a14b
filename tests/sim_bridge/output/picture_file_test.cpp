#include "sim_bridge/output/picture_file.h"

#include <gtest/gtest.h>

#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

using test::inputErrorOf;
using test::TempFolder;

TEST(PictureFile, PicturesArePngByName) {
  const TempFolder folder;
  EXPECT_NO_THROW(requireWritablePicture(folder / "a.png"));
  EXPECT_NO_THROW(requireWritablePicture(folder / "a.PNG"));
  for (const char* name : {"a.jpg", "a", "png", "a.png.jpeg"}) {
    EXPECT_NE(inputErrorOf([&] { requireWritablePicture(folder / name); }).find(".png"),
              std::string::npos)
        << name;
  }
  EXPECT_TRUE(folder.files().empty());
}

TEST(PictureFile, IsWrittenWholeWithNothingBesideIt) {
  const TempFolder folder;
  writePicture(folder / "a.png", {{2, 1}, {1, 2, 3, 4, 5, 6}});
  EXPECT_EQ(folder.files(), std::vector<std::string>{"a.png"});
}

TEST(PictureFileHard, ASizeThatNoMachineHoldsIsRefused) {
  EXPECT_NO_THROW(requireMemoryForPicture({64, 48}));
  // 141 TB.
  EXPECT_THROW(requireMemoryForPicture({1 << 21, 1 << 20}), std::runtime_error);
}

}  // namespace
}  // namespace seaway::bridge
