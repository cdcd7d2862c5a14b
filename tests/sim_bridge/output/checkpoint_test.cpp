#include "sim_bridge/output/checkpoint.h"

#include <gtest/gtest.h>

#include <fstream>

#include "sim_bridge/scene/scene_loader.h"
#include "sim_bridge/simulation.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

using test::TempFolder;

std::string sceneFile(const std::string& name) {
  return SEAWAY_SOURCE_DIR "/configs/scenes/" + name;
}

/// Everything that a telemetry row and a query would tell, bit for bit.
void expectSame(const Simulation& a, const Simulation& b) {
  ASSERT_EQ(a.time(), b.time());
  ASSERT_EQ(a.vessels().size(), b.vessels().size());
  for (std::size_t i = 0; i < a.vessels().size(); ++i) {
    const VesselPose p = a.vessels()[i].pose(), q = b.vessels()[i].pose();
    EXPECT_EQ(p.position, q.position) << i;
    EXPECT_EQ(p.height, q.height) << i;
    EXPECT_EQ(p.roll, q.roll) << i;
    EXPECT_EQ(p.pitch, q.pitch) << i;
    EXPECT_EQ(p.direction, q.direction) << i;
    for (const glm::dvec2 offset : {glm::dvec2(0.0), glm::dvec2(-20.0, 5.0), glm::dvec2(9.0)}) {
      const auto x = a.surface().sample(p.position + offset, a.time());
      const auto y = b.surface().sample(p.position + offset, b.time());
      EXPECT_EQ(x.height, y.height) << i;
      EXPECT_EQ(x.slope, y.slope) << i;
      EXPECT_EQ(x.verticalVelocity, y.verticalVelocity) << i;
    }
  }
}

class Resumed : public testing::TestWithParam<const char*> {};

TEST_P(Resumed, GoesOnBitForBit) {
  const Scene scene = loadScene(sceneFile(GetParam()));
  const Sea sea = buildSea(scene);
  const Audience audience{.cameras = scene.cameras, .places = {}};
  Simulation whole(scene, sea);
  whole.attend(audience);
  whole.stepTo(3.1);
  Simulation resumed = Simulation::resumed(scene, sea, audience, whole.state());
  expectSame(whole, resumed);
  whole.stepTo(5.0);
  resumed.stepTo(5.0);
  expectSame(whole, resumed);
  EXPECT_EQ(whole.state(), resumed.state());
}

// Prescribed and free vessels, wakes, trails, ripples, splashes, an outline.
INSTANTIATE_TEST_SUITE_P(Scenes, Resumed,
                         testing::Values("canaveral.yaml", "crossing_wakes.yaml", "voyage.yaml",
                                         "quiet_bay.yaml", "crater_lake.yaml"));

TEST(CheckpointHard, BytesThatAreCutOffOrOfAnotherSceneAreRefused) {
  const Scene scene = loadScene(sceneFile("canaveral.yaml"));
  const Sea sea = buildSea(scene);
  Simulation simulation(scene, sea);
  simulation.stepTo(0.5);
  const std::string state = simulation.state();
  const auto resume = [&](const Scene& into, const std::string& bytes) {
    return test::inputErrorOf([&] { Simulation::resumed(into, sea, {}, bytes); });
  };
  for (std::size_t size = 0; size < state.size(); size += 1 + state.size() / 200) {
    EXPECT_NE(resume(scene, state.substr(0, size)), "") << size;
  }
  EXPECT_NE(resume(scene, state + "x"), "");
  Scene other = scene;
  other.vessels.clear();
  EXPECT_NE(resume(other, state), "");
}

TEST(CheckpointHard, AFileThatIsNoneOrDamagedSaysSo) {
  const TempFolder folder;
  const Scene scene = loadScene(test::writeScene(folder));
  const auto file = folder / "run.checkpoint";
  writeCheckpoint(file, scene, {3.0, "state"});
  const Checkpoint read = readCheckpoint(file, scene);
  EXPECT_EQ(read.time, 3.0);
  EXPECT_EQ(read.state, "state");
  const std::string whole = test::readFile(file);
  const auto faultOf = [&](const std::string& bytes) {
    folder.write("bad.checkpoint", bytes);
    return test::inputErrorOf([&] { readCheckpoint(folder / "bad.checkpoint", scene); });
  };
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_NE(faultOf(whole.substr(0, size)), "") << size;
  }
  for (std::size_t i = 0; i < whole.size(); i += 7) {
    std::string flipped = whole;
    flipped[i] = static_cast<char>(flipped[i] ^ 4);
    EXPECT_NE(faultOf(flipped), "") << i;
  }
  EXPECT_NE(test::inputErrorOf([&] { readCheckpoint(folder / "none", scene); }), "");
}

TEST(CheckpointHard, ASceneThatHasChangedIsNamed) {
  const TempFolder folder;
  const auto path = test::writeScene(folder);
  const auto file = folder / "run.checkpoint";
  writeCheckpoint(file, loadScene(path), {3.0, "state"});
  folder.write("launch.yaml", test::readFile(folder / "launch.yaml") + "# heavier\n");
  const std::string message = test::inputErrorOf([&] { readCheckpoint(file, loadScene(path)); });
  EXPECT_NE(message.find("launch.yaml"), std::string::npos) << message;
}

TEST(RunResumed, HasTheRowsAndFramesOfAnUninterruptedRun) {
  const TempFolder folder;
  const std::string scene = test::writeScene(folder).string();
  const auto run = [&](const std::string& out, std::vector<std::string> more) {
    std::vector<std::string> arguments{"run", scene,   "--fps",
                                       "4",   "--out", (folder / out).string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto outcome = test::seaway(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
  };
  const std::string checkpoint = (folder / "half.checkpoint").string();
  run("whole", {"--duration", "2"});
  run("first", {"--duration", "1", "--checkpoint", checkpoint});
  run("second", {"--duration", "2", "--resume", checkpoint});
  const std::string whole = test::readFile(folder / "whole/telemetry.csv");
  EXPECT_EQ(test::readFile(folder / "second/telemetry.csv"), whole);
  for (const char* frame : {"000004", "000005", "000006", "000007"}) {
    const std::string name = std::string("/frames/") + frame + ".png";
    EXPECT_EQ(test::readFile(folder / ("second" + name)), test::readFile(folder / ("whole" + name)))
        << frame;
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "second/frames/000003.png"));
  const auto over = test::seaway({"run", scene, "--duration", "1", "--resume", checkpoint, "--out",
                                  (folder / "third").string()});
  EXPECT_EQ(over.status, 2);
  EXPECT_NE(over.err.find("--duration"), std::string::npos) << over.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "third"));
}

// Killed outright, at any place between two checkpoints.
TEST(RunResumedHard, AnInterruptedRunHasTheTelemetryOfAWholeOne) {
  const TempFolder folder;
  const std::string scene = test::writeScene(folder).string();
  const std::string checkpoint = (folder / "run.checkpoint").string();
  const auto arguments = [&](const char* out, const char* duration) {
    return std::vector<std::string>{
        "run", scene, "--fps", "0", "--out", (folder / out).string(), "--duration", duration};
  };
  const auto run = [&](std::vector<std::string> words, const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
    const auto outcome = test::seaway(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
  };
  const std::vector<std::string> kept{"--checkpoint", checkpoint, "--checkpoint-every", "0.7"};
  run(arguments("whole", "3"), {});
  run(arguments("first", "1"), kept);
  // What a run that is killed leaves: rows beyond its last checkpoint.
  std::ofstream(checkpoint + ".telemetry.csv", std::ios::app) << "1.02,28.8";
  std::vector<std::string> onwards = kept;
  onwards.insert(onwards.end(), {"--resume", checkpoint});
  run(arguments("second", "2"), onwards);
  run(arguments("third", "3"), onwards);
  EXPECT_EQ(test::readFile(folder / "third/telemetry.csv"),
            test::readFile(folder / "whole/telemetry.csv"));
}

TEST(RunResumed, MissingOrOtherTelemetryIsNamed) {
  const TempFolder folder;
  const std::string scene = test::writeScene(folder).string();
  const std::string checkpoint = (folder / "run.checkpoint").string();
  const auto run = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{"run", scene, "--fps", "0", "--out", (folder / "out").string()};
    words.insert(words.end(), more.begin(), more.end());
    return test::seaway(words);
  };
  ASSERT_EQ(run({"--duration", "1", "--checkpoint", checkpoint}).status, 0);
  const std::vector<std::string> onwards{"--duration", "2", "--resume", checkpoint};
  const std::string rows = test::readFile(checkpoint + ".telemetry.csv");
  folder.write("run.checkpoint.telemetry.csv", rows.substr(0, rows.size() - 1) + "7");
  const auto other = run(onwards);
  EXPECT_EQ(other.status, 2);
  EXPECT_NE(other.err.find("run.checkpoint.telemetry.csv"), std::string::npos) << other.err;
  std::filesystem::remove(checkpoint + ".telemetry.csv");
  const auto missing = run(onwards);
  EXPECT_EQ(missing.status, 2);
  EXPECT_NE(missing.err.find("no such file"), std::string::npos) << missing.err;
  EXPECT_EQ(test::readFile(folder / "out/telemetry.csv"), rows) << "an earlier run's stays";
}

}  // namespace
}  // namespace seaway::bridge
