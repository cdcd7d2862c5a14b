#include "sim_bridge/scene/sea_state_file.h"

#include <yaml-cpp/yaml.h>

#include <cmath>

#include "sim_bridge/output/atomic_file.h"
#include "sim_bridge/scene/schema_fields.h"
#include "surface/angles.h"

namespace seaway::bridge {
namespace {

const Mapping<FitProvenance>& provenanceSchema() {
  using P = FitProvenance;
  const Range height = Range::atLeast(0.0);
  static const Mapping<P> schema({
      text("source", &P::source, "file or spectrum the octaves were fitted to"),
      text("record_time", &P::recordTime, "time of a measured record, ISO 8601, UTC"),
      text("model", &P::model, "kind of field that was fitted"),
      text("options", &P::options, "what the fit was told"),
      text("judged_on", &P::judgedOn, "spectrum that the residual is measured on"),
      number("hm0_target_m", &P::hm0Target, "m", height, "significant wave height of the target"),
      number("hm0_fit_m", &P::hm0Fit, "m", height, "the same of the fit"),
      number("tm02_target_s", &P::tm02Target, "s", height, "zero-crossing period of the target"),
      number("tm02_fit_s", &P::tm02Fit, "s", height, "the same of the fit"),
      number("tp_target_s", &P::tpTarget, "s", height, "peak period of the target"),
      number("tp_fit_s", &P::tpFit, "s", height, "the same of the fit"),
      number("residual_l2", &P::residual, "1", height, "relative L2 residual"),
  });
  return schema;
}

void requireEnergy(const FittedSeaState& seaState, const YamlValue& value) {
  if (seaState.octaves.empty() || seaState.significantWaveHeight() <= 0.0) {
    value.fail("has no octave with energy (for flat water use `state: {calm: {}}`)");
  }
}

// Yaml-cpp writes numbers with a fixed precision of its own; these are the shortest that read back.
void emit(YAML::Emitter& out, const char* key, double value) {
  out << YAML::Key << key << YAML::Value << numberText(value);
}

void emit(YAML::Emitter& out, const char* key, const std::string& value) {
  if (!value.empty()) out << YAML::Key << key << YAML::Value << value;
}

void emit(YAML::Emitter& out, const char* key, const std::optional<double>& value) {
  if (value) emit(out, key, *value);
}

void emitOctave(YAML::Emitter& out, const OctaveEntry& octave) {
  out << YAML::Flow << YAML::BeginMap;
  emit(out, "kind", kindName(octave.kind));
  emit(out, "standard_deviation_m", octave.standardDeviation);
  emit(out, "lattice_m", octave.latticeSize);
  emit(out, "frequency_hz", octave.frequency);
  emit(out, "bandwidth_hz", octave.bandwidth);
  emit(out, "directional_width_deg", octave.directionalWidth_deg);
  if (octave.kind == OctaveKind::regular) emit(out, "phase_deg", octave.phase_deg);
  emit(out, "toward_deg", octave.toward_deg);
  out << YAML::EndMap;
}

/// A kind needs its own keys and takes no others.
void requireKeysOfKind(const OctaveEntry& entry, const YamlValue& value) {
  const bool perlin = entry.kind == OctaveKind::perlin, group = entry.kind == OctaveKind::group;
  const auto check = [&](const char* key, const std::optional<double>& given, bool wanted) {
    if (wanted == given.has_value()) return;
    value.fail("a " + kindName(entry.kind) + " octave " + (wanted ? "needs" : "has no") + " key '" +
               key + "'");
  };
  check("lattice_m", entry.latticeSize, perlin);
  check("frequency_hz", entry.frequency, !perlin);
  check("bandwidth_hz", entry.bandwidth, group);
  check("directional_width_deg", entry.directionalWidth_deg, group);
}

void emitProvenance(YAML::Emitter& out, const FitProvenance& provenance) {
  out << YAML::Key << "provenance" << YAML::Value << YAML::BeginMap;
  emit(out, "source", provenance.source);
  emit(out, "record_time", provenance.recordTime);
  emit(out, "model", provenance.model);
  emit(out, "options", provenance.options);
  emit(out, "judged_on", provenance.judgedOn);
  emit(out, "hm0_target_m", provenance.hm0Target);
  emit(out, "hm0_fit_m", provenance.hm0Fit);
  emit(out, "tm02_target_s", provenance.tm02Target);
  emit(out, "tm02_fit_s", provenance.tm02Fit);
  emit(out, "tp_target_s", provenance.tpTarget);
  emit(out, "tp_fit_s", provenance.tpFit);
  emit(out, "residual_l2", provenance.residual);
  out << YAML::EndMap;
}

}  // namespace

double FittedSeaState::significantWaveHeight() const {
  double variance = 0.0;
  for (const OctaveEntry& octave : octaves) {
    variance += octave.standardDeviation * octave.standardDeviation;
  }
  return 4.0 * std::sqrt(variance);
}

const Mapping<OctaveEntry>& octaveEntrySchema() {
  using E = OctaveEntry;
  static const Mapping<E> schema(
      {
          choice("kind", &E::kind,
                 {{"perlin", OctaveKind::perlin},
                  {"group", OctaveKind::group},
                  {"regular", OctaveKind::regular}},
                 "kind of octave"),
          number("standard_deviation_m", &E::standardDeviation, "m", Range::within(0.0, 1000.0),
                 "of the octave's height (a regular wave's amplitude over √2)", Need::required),
          number("lattice_m", &E::latticeSize, "m", Range::above(0.0),
                 "perlin: side of a lattice cell"),
          number("frequency_hz", &E::frequency, "Hz", Range::above(0.0),
                 "group, regular: frequency of its waves"),
          number("bandwidth_hz", &E::bandwidth, "Hz", Range::above(0.0),
                 "group: full width at half maximum of its spectrum at a fixed point"),
          number("directional_width_deg", &E::directionalWidth_deg, "°", Range::within(0.1, 180.0),
                 "group: full width at half maximum over direction"),
          number("phase_deg", &E::phase_deg, "°", Range::within(-360.0, 360.0),
                 "regular: phase at the anchor at time 0"),
          number("toward_deg", &E::toward_deg, "°", Range::within(-360.0, 360.0),
                 "compass direction the octave goes to", Need::required),
      },
      requireKeysOfKind);
  return schema;
}

std::string kindName(OctaveKind kind) {
  switch (kind) {
    case OctaveKind::perlin:
      return "perlin";
    case OctaveKind::group:
      return "group";
    case OctaveKind::regular:
      return "regular";
  }
  return "";
}

OctaveEntry entryOf(const Octave& octave, double depth) {
  OctaveEntry entry;
  entry.kind = octave.kind;
  entry.standardDeviation = octave.standardDeviation;
  entry.toward_deg = compassTowardFromToward(octave.toward);
  if (octave.kind == OctaveKind::perlin) {
    entry.latticeSize = octave.latticeSize;
    return entry;
  }
  const WaveBand band = bandOf(octave, depth);
  entry.frequency = band.frequency;
  if (octave.kind == OctaveKind::group) {
    entry.bandwidth = band.bandwidth;
    entry.directionalWidth_deg = degreesFromRadians(band.directionalWidth);
  } else {
    entry.phase_deg = degreesFromRadians(octave.phase);
  }
  return entry;
}

const Mapping<FittedSeaState>& seaStateFileSchema() {
  static const Mapping<FittedSeaState> schema(
      {list("octaves", &FittedSeaState::octaves, octaveEntrySchema(), "the field", Need::required),
       mapping("provenance", &FittedSeaState::provenance, provenanceSchema(),
               "what it was fitted to, and how well")},
      requireEnergy);
  return schema;
}

FittedSeaState loadSeaState(const std::filesystem::path& file) {
  return seaStateFileSchema().read(readYaml(file));
}

void writeSeaState(const std::filesystem::path& file, const FittedSeaState& seaState) {
  YAML::Emitter out;
  out << YAML::Comment("Written by `seaway fit`; a scene uses it as  state: {file: THIS}");
  out << YAML::BeginMap;
  emitProvenance(out, seaState.provenance);
  out << YAML::Key << "octaves" << YAML::Value << YAML::BeginSeq;
  for (const OctaveEntry& octave : seaState.octaves) emitOctave(out, octave);
  out << YAML::EndSeq << YAML::EndMap;
  AtomicFile target(file);
  target.stream() << out.c_str() << '\n';
  target.commit();
}

std::vector<Octave> octavesOf(const FittedSeaState& seaState, double depth) {
  std::vector<Octave> octaves;
  for (const OctaveEntry& entry : seaState.octaves) {
    const double toward = towardFromCompassToward(entry.toward_deg);
    const double deviation = entry.standardDeviation;
    switch (entry.kind) {
      case OctaveKind::perlin:
        octaves.push_back(makePerlinOctave(deviation, *entry.latticeSize, toward, depth));
        break;
      case OctaveKind::group:
        octaves.push_back(makeGroupOctave(deviation, *entry.frequency, *entry.bandwidth, toward,
                                          radiansFromDegrees(*entry.directionalWidth_deg), depth));
        break;
      case OctaveKind::regular:
        octaves.push_back(makeRegularWave(deviation * std::sqrt(2.0), *entry.frequency, toward,
                                          radiansFromDegrees(entry.phase_deg), depth));
        break;
    }
  }
  return octaves;
}

}  // namespace seaway::bridge
