#include "sim_bridge/scene/sea_state_file.h"

#include <gtest/gtest.h>

#include "surface/angles.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

using test::inputErrorOf;
using test::TempFolder;

/// An octave with numbers that no short decimal holds, in the keys its kind has.
OctaveEntry entry(OctaveKind kind, double standardDeviation, double toward_deg) {
  OctaveEntry octave;
  octave.kind = kind;
  octave.standardDeviation = standardDeviation;
  octave.toward_deg = toward_deg;
  if (kind == OctaveKind::perlin) {
    octave.latticeSize = 100.0 / 3.0;
    return octave;
  }
  octave.frequency = 1.0 / 7.0;
  if (kind == OctaveKind::regular) octave.phase_deg = 10.0 / 3.0;
  if (kind == OctaveKind::group) {
    octave.bandwidth = 0.1 / 3.0;
    octave.directionalWidth_deg = 70.0 / 3.0;
  }
  return octave;
}

FittedSeaState example() {
  FittedSeaState state;
  state.octaves = {entry(OctaveKind::perlin, 0.1 + 1e-17, 16.0),
                   entry(OctaveKind::group, 1e-9, 359.5), entry(OctaveKind::regular, 0.3, 7.0)};
  state.provenance.source = "a file: with, odd #signs";
  state.provenance.recordTime = "2020-06-08T03:50Z";
  state.provenance.hm0Target = 1.1188494089912189;
  return state;
}

TEST(SeaStateFile, ReadsBackTheNumbersThatWereWritten) {
  const TempFolder folder;
  writeSeaState(folder / "sea.yaml", example());
  const FittedSeaState read = loadSeaState(folder / "sea.yaml");
  ASSERT_EQ(read.octaves.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(read.octaves[i].kind, example().octaves[i].kind);
    EXPECT_EQ(read.octaves[i].frequency, example().octaves[i].frequency);
    EXPECT_EQ(read.octaves[i].bandwidth, example().octaves[i].bandwidth);
    EXPECT_EQ(read.octaves[i].directionalWidth_deg, example().octaves[i].directionalWidth_deg);
    EXPECT_EQ(read.octaves[i].phase_deg, example().octaves[i].phase_deg);
    EXPECT_EQ(read.octaves[i].standardDeviation, example().octaves[i].standardDeviation);
    EXPECT_EQ(read.octaves[i].latticeSize, example().octaves[i].latticeSize);
    EXPECT_EQ(read.octaves[i].toward_deg, example().octaves[i].toward_deg);
  }
  EXPECT_EQ(read.provenance.source, example().provenance.source);
  EXPECT_EQ(read.provenance.recordTime, example().provenance.recordTime);
  EXPECT_EQ(read.provenance.hm0Target, example().provenance.hm0Target);
}

TEST(SeaStateFile, OctavesThatDisagreeWithTheirTargetAreReported) {
  const TempFolder folder;
  FittedSeaState state = example();
  const auto loaded = [&](double target) {
    state.provenance.hm0Target = target;
    writeSeaState(folder / "sea.yaml", state);
    folder.write("launch.yaml", test::vesselText());
    const auto scene = folder.write(
        "scene.yaml",
        test::sceneText({{"    jonswap:\n      hm0_m: 1.12\n      tp_s: 5.6\n      from_deg: 196\n",
                          "    file: sea.yaml\n"}}));
    const auto outcome =
        test::seaway({"query", scene.string(), "--time", "0", "--at", "28.878,-78.467"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.err;
  };
  const double given = state.significantWaveHeight();
  EXPECT_EQ(loaded(given), "");
  EXPECT_EQ(loaded(1.004 * given), "");
  EXPECT_NE(loaded(1.1 * given).find("hm0_target_m"), std::string::npos);
}

TEST(SeaStateFile, LeavesNoTraceOfTheFileBesideIt) {
  const TempFolder folder;
  writeSeaState(folder / "sea.yaml", example());
  EXPECT_EQ(folder.files(), std::vector<std::string>{"sea.yaml"});
}

TEST(SeaStateFile, OctavesDriftWhereTheCompassSays) {
  FittedSeaState state;
  state.octaves = {entry(OctaveKind::perlin, 1.0, 90.0)};  // to the east
  EXPECT_NEAR(octavesOf(state, 100.0)[0].toward, 0.0, 1e-12);
}

TEST(SeaStateFile, OctavesComeBackFromTheirEntriesAtAnyDepth) {
  for (const double depth : {5.0, 1e9}) {
    FittedSeaState state;
    for (const OctaveEntry& octave : example().octaves) state.octaves.push_back(octave);
    for (const Octave& octave : octavesOf(state, depth)) {
      FittedSeaState again;
      again.octaves = {entryOf(octave, depth)};
      const Octave back = octavesOf(again, depth).front();
      EXPECT_NEAR(back.waveNumber, octave.waveNumber, 1e-12 * octave.waveNumber);
      EXPECT_NEAR(back.lengthAlong, octave.lengthAlong, 1e-12 * octave.lengthAlong);
      EXPECT_NEAR(back.lengthAcross, octave.lengthAcross, 1e-12 * octave.lengthAcross);
      EXPECT_EQ(back.latticeSize, octave.latticeSize);
      EXPECT_NEAR(back.phase, octave.phase, 1e-14);
    }
  }
}

TEST(SeaStateFileHard, AnOctaveNeedsTheKeysOfItsKindAndNoOthers) {
  const TempFolder folder;
  const auto messageOf = [&](const std::string& octave) {
    const auto path = folder.write("sea.yaml", "octaves:\n  - {" + octave + "}\n");
    return inputErrorOf([&] { loadSeaState(path); });
  };
  EXPECT_NE(messageOf("kind: group, standard_deviation_m: 1, toward_deg: 0, frequency_hz: 0.1")
                .find("a group octave needs key 'bandwidth_hz'"),
            std::string::npos);
  EXPECT_NE(
      messageOf(
          "kind: perlin, standard_deviation_m: 1, toward_deg: 0, lattice_m: 3, frequency_hz: 0.1")
          .find("a perlin octave has no key 'frequency_hz'"),
      std::string::npos);
}

TEST(SeaStateFile, RefusesASeaWithoutEnergyAndBadValues) {
  const TempFolder folder;
  const auto fault = [&](const std::string& octave) {
    const auto file = folder.write("s.yaml", "octaves:\n  - {" + octave + "}\n");
    return inputErrorOf([&] { loadSeaState(file); });
  };
  EXPECT_NE(fault("standard_deviation_m: 0, lattice_m: 1, toward_deg: 0").find("energy"),
            std::string::npos);
  EXPECT_NE(fault("standard_deviation_m: 1, lattice_m: 0, toward_deg: 0")
                .find("s.yaml:2: key 'octaves[0].lattice_m': 0 is not allowed; must be > 0 m"),
            std::string::npos);
  EXPECT_NE(fault("kind: fourier, standard_deviation_m: 1, lattice_m: 1, toward_deg: 0")
                .find("must be one of: perlin"),
            std::string::npos);
}

}  // namespace
}  // namespace seaway::bridge
