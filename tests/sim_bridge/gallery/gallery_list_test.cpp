#include "sim_bridge/gallery/gallery_list.h"

#include <gtest/gtest.h>

#include "render/png.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

std::string refusal(const std::string& text) {
  const test::TempFolder folder;
  const auto file = folder.write("list.yaml", text);
  return test::inputErrorOf([&] { loadGallery(file); });
}

TEST(GalleryList, FaultsAreNamedWithFileLineAndKey) {
  EXPECT_NE(refusal("pictures: []\n").find("holds no picture"), std::string::npos);
  EXPECT_NE(refusal("pictures:\n  - {name: a, scene: s.yaml, caption: c}\n").find("list.yaml:2"),
            std::string::npos);
  EXPECT_NE(refusal("pictures:\n  - {name: a, scene: s.yaml, caption: c, camera: x, sizes: 3}\n")
                .find("sizes"),
            std::string::npos);
  const std::string twice = refusal(
      "pictures:\n  - {name: a, scene: s.yaml, caption: c, camera: x}\n"
      "  - {name: a, scene: t.yaml, caption: c, camera: x}\n");
  EXPECT_NE(twice.find("list.yaml:3"), std::string::npos) << twice;
  EXPECT_NE(twice.find("twice"), std::string::npos) << twice;
}

TEST(GalleryList, TheCommandOfAPictureIsOneThatDrawsIt) {
  const test::TempFolder folder;
  test::writeScene(folder);
  const auto file = folder.write(
      "list.yaml",
      "pictures:\n  - {name: high, scene: scene.yaml, time_s: 1, size: [64, 36], caption: c,\n"
      "     from: {latitude_deg: 28.878, longitude_deg: -78.467, height_m: 40}, pitch_deg: -20}\n");
  const Gallery gallery = loadGallery(file);
  const std::string command = commandOf(gallery, gallery.pictures.front());
  EXPECT_NE(command.find("--from=28.878,-78.467,40"), std::string::npos) << command;
  EXPECT_NE(command.find("--out high.png"), std::string::npos) << command;
}

TEST(GalleryCommand, WritesAPageThatHoldsItsPicturesAndGoldenOnes) {
  const test::TempFolder folder;
  test::writeScene(folder);
  const auto file = folder.write(
      "list.yaml",
      "pictures:\n  - {name: high, scene: scene.yaml, time_s: 1, size: [64, 36], caption: \"a < "
      "b\",\n"
      "     from: {latitude_deg: 28.878, longitude_deg: -78.467, height_m: 40}, pitch_deg: -20}\n");
  const test::Outcome drawn =
      test::seaway({"gallery", file.string(), "--out", (folder / "page").string(), "--golden",
                    (folder / "golden").string()});
  ASSERT_EQ(drawn.status, 0) << drawn.err;
  const std::string page = test::readFile(folder / "page/index.html");
  EXPECT_NE(page.find("data:image/png;base64,iVBOR"), std::string::npos);
  EXPECT_NE(page.find("a &lt; b"), std::string::npos);
  EXPECT_NE(page.find("seaway render"), std::string::npos);
  EXPECT_EQ(page.find("http"), std::string::npos) << "fetches something";
  EXPECT_EQ(render::readPng(folder / "page/high.png").size, glm::ivec2(64, 36));
  EXPECT_EQ(render::readPng(folder / "golden/high.png").size, glm::ivec2(240, 135));
  EXPECT_EQ(test::seaway({"gallery", file.string()}).status, 2);
  EXPECT_EQ(test::seaway({"gallery", (folder / "none.yaml").string(), "--out", "x"}).status, 2);
}

}  // namespace
}  // namespace seaway::bridge
