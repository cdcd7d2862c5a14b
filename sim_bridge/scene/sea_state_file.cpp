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

void emitOctave(YAML::Emitter& out, const OctaveEntry& octave) {
  out << YAML::Flow << YAML::BeginMap;
  emit(out, "kind", std::string("perlin"));
  emit(out, "standard_deviation_m", octave.standardDeviation);
  emit(out, "lattice_m", octave.latticeSize);
  emit(out, "toward_deg", octave.toward_deg);
  out << YAML::EndMap;
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
  static const Mapping<E> schema({
      choice("kind", &E::kind, {{"perlin", OctaveKind::perlin}}, "kind of octave"),
      number("standard_deviation_m", &E::standardDeviation, "m", Range::atLeast(0.0),
             "of the octave's height", Need::required),
      number("lattice_m", &E::latticeSize, "m", Range::above(0.0), "side of a lattice cell",
             Need::required),
      number("toward_deg", &E::toward_deg, "°", Range::within(-360.0, 360.0),
             "compass direction the octave drifts to", Need::required),
  });
  return schema;
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
    octaves.push_back(makePerlinOctave(entry.standardDeviation, entry.latticeSize,
                                       towardFromCompassToward(entry.toward_deg), depth));
  }
  return octaves;
}

}  // namespace seaway::bridge
