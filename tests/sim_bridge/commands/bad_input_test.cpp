#include <gtest/gtest.h>

#include "tests/sim_bridge/test_support.h"

// What the command says to bad input: status 2, one clear message, no file touched.
namespace seaway::bridge {
namespace {

using test::Outcome;
using test::TempFolder;
using test::writeScene;
using Replacements = std::vector<std::pair<std::string, std::string>>;

void expectBadInput(const Outcome& outcome, const std::string& wanted) {
  EXPECT_EQ(outcome.status, 2) << outcome.err;
  EXPECT_NE(outcome.err.find(wanted), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("terminate"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.out, "");
}

// Runs a scene with a fault; expects the message and that nothing is written.
void expectBadScene(const Replacements& replacements, const std::string& wanted) {
  const TempFolder folder;
  const std::string scene = writeScene(folder, replacements).string();
  const auto before = folder.files();
  expectBadInput(test::seaway({"run", scene, "--out", (folder / "out").string()}), wanted);
  EXPECT_EQ(folder.files(), before);
}

TEST(BadInput, MissingSceneFile) {
  expectBadInput(test::seaway({"query", "/nowhere/scene.yaml", "--time", "0", "--at", "1,2"}),
                 "/nowhere/scene.yaml: no such file");
}

TEST(BadInput, SceneThatIsAFolder) {
  const TempFolder folder;
  expectBadInput(test::seaway({"explain", folder.path().string()}), "cannot be read");
}

TEST(BadInput, MalformedYamlTellsFileAndLine) {
  expectBadScene({{"[64, 48]", "[64, 48"}}, "scene.yaml:2");
}

TEST(BadInput, UnknownKeyTellsTheNearestOne) {
  expectBadScene({{"vessels:", "vesels:"}}, "key 'vesels': unknown key; did you mean 'vessels'?");
}

TEST(BadInput, WaveHeightOfZeroOrLess) {
  expectBadScene({{"1.12", "0"}}, "scene.yaml:7: key 'sea.state.jonswap.hm0_m': 0 is not allowed");
  expectBadScene({{"1.12", "-2"}}, "must be > 0 m");
}

TEST(BadInput, NotANumber) {
  expectBadScene({{"1.12", ".nan"}}, ".nan is not allowed");
  expectBadScene({{"1.12", "high"}}, "'high' is not a number");
  const TempFolder folder;
  const std::string scene = writeScene(folder).string();
  expectBadInput(test::seaway({"query", scene, "--time", "nan", "--at", "28.9,-78"}), "--time");
  expectBadInput(test::seaway({"query", scene, "--time", "0", "--at", "nan,-78"}), "nan");
}

TEST(BadInput, Latitude91) {
  expectBadScene({{"28.878", "91"}}, "'sea.anchor.latitude_deg': 91 is not allowed");
  const TempFolder folder;
  expectBadInput(
      test::seaway({"query", writeScene(folder).string(), "--time", "0", "--at", "91,-78"}),
      "must be in [-90, 90]");
}

TEST(BadInput, ImageWithoutPixels) {
  expectBadScene({{"[64, 48]", "[64, 0]"}}, "'run.size[1]': 0 is not allowed");
  const TempFolder folder;
  const std::string scene = writeScene(folder).string();
  for (const char* size : {"0x480", "640x0", "640", "640x-1", "ax3", "9000x9000"}) {
    expectBadInput(test::seaway({"render", scene, "--time", "0", "--size", size, "--out",
                                 (folder / "f.png").string()}),
                   "--size");
  }
}

TEST(BadInput, MissingVesselFile) {
  expectBadScene({{"launch.yaml", "boat.yaml"}}, "key 'vessels[0].model': no such file");
}

TEST(BadInput, OutputThatCannotBeWritten) {
  const TempFolder folder;
  const std::string scene = writeScene(folder).string();
  const std::string underFile = (folder / "scene.yaml").string() + "/out";
  expectBadInput(test::seaway({"run", scene, "--out", underFile}), "scene.yaml/out");
  expectBadInput(test::seaway({"render", scene, "--time", "0", "--out", underFile + "/a.png"}),
                 "cannot be written");
  expectBadInput(test::seaway({"render", scene, "--time", "0", "--out", folder.path().string()}),
                 "is a folder");
  expectBadInput(test::seaway({"fit", "pm:2,8", "--out", underFile + "/sea.yaml"}),
                 "cannot be written");
}

TEST(BadInput, SpectrumWithoutEnergy) {
  const TempFolder folder;
  const std::string header = "#YY  MM DD hh mm Sep_Freq  < spec_1 (freq_1) ... >\n";
  const std::string spectrum =
      folder
          .write("zero.data_spec", header +
                                       "2020 06 08 03 50 9.999 0.000 (0.100) 0.000 (0.200) "
                                       "0.000 (0.300)\n")
          .string();
  expectBadInput(test::seaway({"fit", spectrum, "--out", (folder / "sea.yaml").string()}),
                 "zero.data_spec:2");
  expectBadInput(test::seaway({"fit", "jonswap:0,8", "--out", (folder / "sea.yaml").string()}),
                 "0 is not allowed; must be > 0 m");
  EXPECT_EQ(folder.files(), std::vector<std::string>{"zero.data_spec"});
}

TEST(BadInput, BadArgumentsOfFit) {
  const TempFolder folder;
  const std::string out = (folder / "sea.yaml").string();
  const std::vector<std::vector<std::string>> bad = {{"jonswap:a,b"},
                                                     {"jonswap:1"},
                                                     {"pm:1,8,3"},
                                                     {"jonswap:1,8,0.5"},
                                                     {"pm:1,8", "--record", "0"},
                                                     {"pm:1,8", "--octaves", "0"},
                                                     {"pm:1,8", "--model", "fourier"},
                                                     {"/nowhere.data_spec"}};
  for (std::vector<std::string> arguments : bad) {
    arguments.insert(arguments.begin(), "fit");
    arguments.insert(arguments.end(), {"--out", out});
    const Outcome outcome = test::seaway(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments[1] << outcome.err;
  }
  EXPECT_TRUE(folder.files().empty());
}

TEST(BadInput, UnknownCommandNamesTheWordAndTheCommands) {
  expectBadInput(test::seaway({"bogus"}), "'bogus' is no command");
  expectBadInput(test::seaway({"bogus"}), "run, query, render");
  expectBadInput(test::seaway({"rander"}), "did you mean 'render'?");
}

TEST(BadInput, EmptyNamesOfOutput) {
  const TempFolder folder;
  const std::string scene = writeScene(folder).string();
  expectBadInput(test::seaway({"run", scene, "--out", ""}), "--out");
  expectBadInput(test::seaway({"cost", scene, "--out", ""}), "--out");
  expectBadInput(test::seaway({"buoy", scene, "--at", "28.878,-78.467", "--out", ""}), "--out");
  expectBadInput(test::seaway({"render", scene, "--time", "0", "--out", ""}), "--out");
}

TEST(BadInput, PicturesInOtherFormats) {
  const TempFolder folder;
  const std::string scene = writeScene(folder).string();
  const auto before = folder.files();
  expectBadInput(
      test::seaway({"render", scene, "--time", "0", "--out", (folder / "a.jpg").string()}),
      "must end in .png");
  EXPECT_EQ(folder.files(), before);
}

TEST(BadInput, WavesBeyondAllWaterTellFileAndLine) {
  expectBadScene({{"1.12", "1e200"}},
                 "scene.yaml:7: key 'sea.state.jonswap.hm0_m': 1e200 is not allowed");
  expectBadScene({{"5.6", "1e200"}}, "scene.yaml:8: key 'sea.state.jonswap.tp_s'");
}

TEST(BadInput, ASecondYamlDocument) {
  expectBadScene({{"vessels:", "---\nvessels:"}}, "second YAML document");
}

TEST(BadInput, TimeWithoutARecordNamesFileAndOption) {
  const TempFolder folder;
  const std::string file =
      folder
          .write("b.data_spec",
                 "#YY  MM DD hh mm Sep_Freq  < spec_1 (freq_1) ... >\n"
                 "2020 06 08 03 50 9.999 0.100 (0.100) 0.200 (0.200) 0.100 (0.300)\n")
          .string();
  const Outcome outcome = test::seaway(
      {"fit", file, "--time", "2020-06-09T00:00", "--out", (folder / "sea.yaml").string()});
  expectBadInput(outcome, "b.data_spec: --time 2020-06-09T00:00: no record within 30 minutes");
}

TEST(BadInput, BadPointsFile) {
  const TempFolder folder;
  const std::string scene = writeScene(folder).string();
  const auto ask = [&](const std::string& text) {
    return test::seaway({"query", scene, "--time", "0", "--points", "-"}, text);
  };
  expectBadInput(ask("x_m,y_m\n1,zwei\n"),
                 "standard input:2: column 'y_m': 'zwei' is not a number");
  expectBadInput(ask("x_m\n1\n"), "the header needs");
  expectBadInput(ask("latitude_deg,longitude_deg\n91,0\n"), "must be in [-90, 90]");
  expectBadInput(test::seaway({"query", scene, "--time", "0", "--points", "/nowhere.csv"}),
                 "/nowhere.csv");
  expectBadInput(test::seaway({"query", scene, "--time", "0"}), "points are wanted");
  expectBadInput(test::seaway({"query", scene, "--at", "28.9,-78"}), "--time is wanted");
}

}  // namespace
}  // namespace seaway::bridge
