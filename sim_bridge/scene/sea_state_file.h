#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim_bridge/scene/schema.h"
#include "surface/field/octave.h"

namespace seaway::bridge {

/// One octave as a file gives it. Which keys a kind needs: `octaveEntrySchema`.
struct OctaveEntry {
  OctaveKind kind = OctaveKind::perlin;
  double standardDeviation = 0.0;              ///< m
  double toward_deg = 0.0;                     ///< compass direction the octave goes to
  std::optional<double> latticeSize;           ///< perlin, m
  std::optional<double> frequency;             ///< group and regular, Hz
  std::optional<double> bandwidth;             ///< group, Hz
  std::optional<double> directionalWidth_deg;  ///< group
  double phase_deg = 0.0;                      ///< regular
};

/// The entry that reads back as `octave` at a depth (m, > 0 or infinite).
OctaveEntry entryOf(const Octave& octave, double depth);

/// The kind's word in files.
std::string kindName(OctaveKind kind);

/// Where a fitted sea state comes from.
struct FitProvenance {
  std::string source;      ///< file, or `jonswap:Hs,Tp,gamma`
  std::string recordTime;  ///< ISO 8601, of a measured record
  std::string model = "perlin";
  std::string options;      ///< what the fit was told, such as `octaves 8, from_deg 196`
  std::string judgedOn;     ///< spectrum that the residual is measured on
  double hm0Target = 0.0;   ///< m
  double hm0Fit = 0.0;      ///< m
  double tm02Target = 0.0;  ///< s
  double tm02Fit = 0.0;     ///< s
  double tpTarget = 0.0;    ///< s
  double tpFit = 0.0;       ///< s
  double residual = 0.0;    ///< relative L2
};

/// A sea state as octaves: what `seaway fit --out` writes and `state: {file: …}` reads; also
/// `state: {octaves: […]}` in a scene, then without provenance.
struct FittedSeaState {
  std::vector<OctaveEntry> octaves;
  FitProvenance provenance;

  double significantWaveHeight() const;  ///< 4√Σa², m
};

const Mapping<OctaveEntry>& octaveEntrySchema();

/// Keys of a sea state file.
const Mapping<FittedSeaState>& seaStateFileSchema();

/// Throws InputError for anything the schema does not allow, and where no octave has energy.
FittedSeaState loadSeaState(const std::filesystem::path& file);

/// Writes beside `file`, then renames. Throws InputError where it cannot. What is written reads
/// back to the same numbers.
void writeSeaState(const std::filesystem::path& file, const FittedSeaState& seaState);

/// The octaves at a depth (m, > 0 or infinite).
std::vector<Octave> octavesOf(const FittedSeaState& seaState, double depth);

}  // namespace seaway::bridge
