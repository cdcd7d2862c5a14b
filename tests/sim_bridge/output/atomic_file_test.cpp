#include "sim_bridge/output/atomic_file.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim_bridge/output/number_text.h"
#include "surface/input_error.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

using test::TempFolder;

TEST(AtomicFile, AppearsOnlyWhenCommitted) {
  const TempFolder folder;
  AtomicFile file(folder / "a.txt");
  file.stream() << "whole";
  EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
  file.commit();
  EXPECT_EQ(test::readFile(folder / "a.txt"), "whole");
  EXPECT_EQ(folder.files(), std::vector<std::string>{"a.txt"});
}

TEST(AtomicFile, LeavesTheOldFileAndNoRestWhenGivenUp) {
  const TempFolder folder;
  folder.write("a.txt", "old");
  { AtomicFile(folder / "a.txt").stream() << "half"; }
  EXPECT_EQ(test::readFile(folder / "a.txt"), "old");
  EXPECT_EQ(folder.files(), std::vector<std::string>{"a.txt"});
}

TEST(AtomicFile, SaysWhyNothingCanBeWritten) {
  const TempFolder folder;
  folder.write("file", "");
  EXPECT_NE(test::inputErrorOf([&] { AtomicFile(folder / "file/b"); }).find("Not a directory"),
            std::string::npos);
  EXPECT_NE(test::inputErrorOf([&] { AtomicFile(folder / "none/b"); }).find("No such file"),
            std::string::npos);
  EXPECT_THROW(requireWritableFolder(folder / "file"), InputError);
  EXPECT_EQ(folder.files(), std::vector<std::string>{"file"});
}

TEST(NumberText, IsTheShortestThatReadsBack) {
  EXPECT_EQ(numberText(0.1), "0.1");
  EXPECT_EQ(numberText(0.1f), "0.1");
  EXPECT_EQ(numberText(1.0 / 3.0), "0.3333333333333333");
  EXPECT_EQ(numberText(-std::nan("")), "nan");
  EXPECT_EQ(numberText(-INFINITY), "-inf");
}

TEST(AtomicFileHard, WritesThroughALinkAndRefusesWhatIsNoRegularFile) {
  const TempFolder folder;
  folder.write("real.txt", "old");
  std::filesystem::create_symlink(folder / "real.txt", folder / "link.txt");
  AtomicFile file(folder / "link.txt");
  file.stream() << "new";
  file.commit();
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
  EXPECT_EQ(test::readFile(folder / "real.txt"), "new");
  EXPECT_NE(test::inputErrorOf([] { AtomicFile device("/dev/null"); }).find("not a regular file"),
            std::string::npos);
  EXPECT_FALSE(test::inputErrorOf([] { AtomicFile nameless(""); }).empty());
}

}  // namespace
}  // namespace seaway::bridge
