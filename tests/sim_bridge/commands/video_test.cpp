#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <stdexcept>

#include "sim_bridge/output/video_file.h"
#include "tests/sim_bridge/test_support.h"

// `seaway run --video`: with programs that stand in for ffmpeg, and with ffmpeg itself where it is.
namespace seaway::bridge {
namespace {

using test::TempFolder;

/// A PATH on which `ffmpeg` is a script.
class StandIn {
 public:
  StandIn(const TempFolder& folder, const std::string& script) : before_(std::getenv("PATH")) {
    const auto program = folder.write("bin/ffmpeg", "#!/bin/sh\n" + script);
    chmod(program.c_str(), 0755);
    setenv("PATH", (program.parent_path().string() + ":/usr/bin:/bin").c_str(), 1);
  }
  ~StandIn() { setenv("PATH", before_.c_str(), 1); }

 private:
  std::string before_;
};

render::ColourImage grey(glm::ivec2 size) {
  return {size, std::vector<std::uint8_t>(std::size_t{3} * size.x * size.y, 90)};
}

/// Files named like the video, but for the video itself.
int leftovers(const TempFolder& folder) {
  int count = 0;
  for (const std::string& name : folder.files()) {
    count += name.find("film") != std::string::npos && name != "film.mp4";
  }
  return count;
}

TEST(Video, FramesGoThroughThePipeToTheByteAndTheFileAppearsWhole) {
  const TempFolder folder;
  // Its last argument is the file.
  const StandIn ffmpeg(folder, "for last; do :; done; cat > \"$last\"\n");
  VideoFile video(folder / "film.mp4", {7, 5}, 12.5);
  EXPECT_FALSE(std::filesystem::exists(folder / "film.mp4"));
  for (int i = 0; i < 3; ++i) video.write(grey({7, 5}));
  EXPECT_FALSE(std::filesystem::exists(folder / "film.mp4"));
  video.commit();
  EXPECT_EQ(test::readFile(folder / "film.mp4"), std::string(3 * 7 * 5 * 3, 90));
}

TEST(Video, WithoutFfmpegItIsRefusedByName) {
  const TempFolder folder;
  std::filesystem::create_directory(folder / "empty");
  const std::string before = std::getenv("PATH");
  setenv("PATH", (folder / "empty").c_str(), 1);
  const std::string message = test::inputErrorOf([&] { requireVideo(folder / "film.mp4"); });
  setenv("PATH", before.c_str(), 1);
  EXPECT_NE(message.find("ffmpeg is not on the PATH"), std::string::npos) << message;
  const StandIn ffmpeg(folder, "exit 0\n");
  EXPECT_NE(test::inputErrorOf([&] { requireVideo(folder / "film.avi"); }).find(".mp4"),
            std::string::npos);
  EXPECT_NE(test::inputErrorOf([&] { requireVideo("/proc/none/film.mp4"); }).find("written"),
            std::string::npos);
}

std::string faultOf(const std::function<void()>& act) {
  try {
    act();
  } catch (const std::runtime_error& fault) {
    return fault.what();
  }
  return "";
}

TEST(VideoHard, AnFfmpegThatFailsIsKilledOrWritesNothingLeavesNothing) {
  const TempFolder folder;
  const auto draw = [&] {
    return faultOf([&] {
      VideoFile video(folder / "film.mp4", {64, 64}, 10.0);
      for (int i = 0; i < 100; ++i) video.write(grey({64, 64}));
      video.commit();
    });
  };
  {
    const StandIn ffmpeg(folder, "echo 'no such codec' >&2; exit 3\n");
    EXPECT_NE(draw().find("no such codec"), std::string::npos);
  }
  {
    const StandIn ffmpeg(folder, "head -c 20000 > /dev/null; kill -9 $$\n");
    EXPECT_NE(draw().find("signal 9"), std::string::npos);
  }
  {
    const StandIn ffmpeg(folder, "cat > /dev/null\n");
    EXPECT_NE(draw().find("status 0"), std::string::npos);  // there is no file
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "film.mp4"));
  EXPECT_EQ(leftovers(folder), 0);
}

TEST(Video, ARunMakesOneThatFfprobeReads) {
  if (std::system("ffprobe -version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no ffmpeg here";
  const TempFolder folder;
  const auto scene = test::writeScene(folder);
  const auto outcome =
      test::seaway({"run", scene.string(), "--out", (folder / "out").string(), "--fps", "6",
                    "--size", "65x49", "--video", (folder / "film.mp4").string()});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string probe =
      "ffprobe -v error -count_frames -show_entries stream=width,height,"
      "nb_read_frames -of csv=p=0 " +
      (folder / "film.mp4").string() + " > " + (folder / "probe.txt").string();
  ASSERT_EQ(std::system(probe.c_str()), 0);
  EXPECT_EQ(test::readFile(folder / "probe.txt"), "66,50,6\n");
  EXPECT_EQ(leftovers(folder), 0);
}

TEST(Video, ARunWithoutFramesRefusesIt) {
  const TempFolder folder;
  const auto scene = test::writeScene(folder);
  const StandIn ffmpeg(folder, "exit 0\n");
  const auto outcome = test::seaway({"run", scene.string(), "--out", (folder / "out").string(),
                                     "--fps", "0", "--video", (folder / "film.mp4").string()});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("no frames"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace seaway::bridge
