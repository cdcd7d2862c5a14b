#include "sim_bridge/scene/sea_state_file.h"

#include <gtest/gtest.h>

#include "surface/angles.h"
#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

using test::inputErrorOf;
using test::TempFolder;

FittedSeaState example() {
  FittedSeaState state;
  state.octaves = {{OctaveKind::perlin, 0.1 + 1e-17, 100.0 / 3.0, 16.0},
                   {OctaveKind::perlin, 1e-9, 12.5, 359.5}};
  state.provenance.source = "a file: with, odd #signs";
  state.provenance.recordTime = "2020-06-08T03:50Z";
  state.provenance.hm0Target = 1.1188494089912189;
  return state;
}

TEST(SeaStateFile, ReadsBackTheNumbersThatWereWritten) {
  const TempFolder folder;
  writeSeaState(folder / "sea.yaml", example());
  const FittedSeaState read = loadSeaState(folder / "sea.yaml");
  ASSERT_EQ(read.octaves.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(read.octaves[i].standardDeviation, example().octaves[i].standardDeviation);
    EXPECT_EQ(read.octaves[i].latticeSize, example().octaves[i].latticeSize);
    EXPECT_EQ(read.octaves[i].toward_deg, example().octaves[i].toward_deg);
  }
  EXPECT_EQ(read.provenance.source, example().provenance.source);
  EXPECT_EQ(read.provenance.recordTime, example().provenance.recordTime);
  EXPECT_EQ(read.provenance.hm0Target, example().provenance.hm0Target);
}

TEST(SeaStateFile, LeavesNoTraceOfTheFileBesideIt) {
  const TempFolder folder;
  writeSeaState(folder / "sea.yaml", example());
  EXPECT_EQ(folder.files(), std::vector<std::string>{"sea.yaml"});
}

TEST(SeaStateFile, OctavesDriftWhereTheCompassSays) {
  FittedSeaState state;
  state.octaves = {{OctaveKind::perlin, 1.0, 10.0, 90.0}};  // to the east
  EXPECT_NEAR(octavesOf(state, 100.0)[0].toward, 0.0, 1e-12);
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
